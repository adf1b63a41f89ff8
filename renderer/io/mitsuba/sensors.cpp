#include <algorithm>

#include "renderer/io/mitsuba/importer.h"
#include "renderer/io/mitsuba/values.h"
#include "renderer/scene/film_size.h"

namespace guidelight::mitsuba {
namespace {

/// "50mm" on 36 × 24 mm film as the angle of its diagonal [degrees].
float fov_of_focal_length(const Node& node, std::string text) {
  const size_t unit = text.find("mm");
  if (unit != std::string::npos) text.resize(unit);
  const double length = parse_number(text).value_or(0);
  if (!(length > 0) || !std::isfinite(length)) {
    throw Error("{}: '{}' is not a focal length; write for instance '50mm'.",
                node.source.to_string(), text);
  }
  return static_cast<float>(2 * std::atan(std::sqrt(36.0 * 36 + 24 * 24) / (2 * length)) * 180 /
                            std::numbers::pi);
}

FovAxis fov_axis(const std::string& name, Warnings& warnings, const Node& node) {
  if (name == "x") return FovAxis::X;
  if (name == "y") return FovAxis::Y;
  if (name == "diagonal") return FovAxis::Diagonal;
  if (name == "smaller") return FovAxis::Smaller;
  if (name == "larger") return FovAxis::Larger;
  warnings.add(node.source, "fov axis",
               fmt::format("the fovAxis '{}' is not known; 'x' stands in.", name));
  return FovAxis::X;
}

}  // namespace

void Importer::sensor(const Node& node) {
  if (has_sensor_) {
    warnings_.add(node.source, "second sensor", "only the first sensor of the scene is used.");
    return;
  }
  has_sensor_ = true;
  Properties p(node, warnings_);
  CameraDescription& camera = scene_.camera;
  if (node.type == "thinlens") {
    camera.model = CameraModel::ThinLens;
  } else if (node.type == "orthographic") {
    camera.model = CameraModel::Orthographic;
  } else if (node.type != "perspective") {
    warnings_.add(
        node.source, plugin_name(node),
        fmt::format("{} is not supported; a perspective camera stands in.", plugin_name(node)));
  }
  camera.to_world = p.transform({"to_world"});
  if (!(std::abs(glm::determinant(Mat3(camera.to_world))) > 0)) {
    throw Error("{}: the camera's transform is singular; correct it.", node.source.to_string());
  }
  std::tie(camera.fov, camera.fov_axis) = field_of_view(p);
  camera.principal_point_offset =
      Vec2(p.number({"principal_point_offset_x"}, 0), p.number({"principal_point_offset_y"}, 0));
  camera.near_clip = p.number({"near_clip"}, camera.near_clip);
  camera.far_clip = p.number({"far_clip"}, camera.far_clip);
  if (!(camera.near_clip >= 0 && camera.far_clip > camera.near_clip)) {
    throw Error("{}: the clip distances {} and {} leave nothing visible; correct them.",
                node.source.to_string(), camera.near_clip, camera.far_clip);
  }
  camera.aperture_radius = p.number({"aperture_radius"}, 0);
  camera.focus_distance = p.number({"focus_distance"}, camera.far_clip);
  p.ignore({"shutter_open", "shutter_close"});
  if (const Node* nested = p.object("film")) film(*nested);
  if (const Node* sampler = p.object("sampler")) {
    Properties samples(*sampler, warnings_);
    const int count = samples.integer({"sample_count"}, 0);
    if (count > 0) scene_.hints.samples_per_pixel = count;
  }
  if (const Node* inside = p.object("medium")) scene_.camera_medium = medium(*inside);
  p.warn_about_the_rest();
}

std::pair<float, FovAxis> Importer::field_of_view(Properties& p) {
  const Node& node = p.node();
  const FovAxis axis = fov_axis(p.text({"fov_axis"}, "x"), warnings_, node);
  const std::string focal_length = p.text({"focal_length"}, "50mm");
  if (!p.find({"fov"})) return {fov_of_focal_length(node, focal_length), FovAxis::Diagonal};
  const float fov = p.number({"fov"}, 50);
  if (!(fov > 0 && fov < 180)) {
    throw Error("{}: a field of view of {} degrees is not between 0 and 180; correct 'fov'.",
                node.source.to_string(), fov);
  }
  return {fov, axis};
}

void Importer::film(const Node& node) {
  Properties p(node, warnings_);
  FilmDescription& film = scene_.film;
  film.width = p.integer({"width"}, film.width);
  film.height = p.integer({"height"}, film.height);
  if (!is_film_size(film.width, film.height)) {
    throw Error(
        "{}: a film of {} x {} pixels cannot be rendered; use 1 to {} a side and at most {}.",
        node.source.to_string(), film.width, film.height, kMaxFilmSide, kMaxFilmPixels);
  }
  film.crop_x = p.integer({"crop_offset_x"}, 0);
  film.crop_y = p.integer({"crop_offset_y"}, 0);
  film.crop_width = p.integer({"crop_width"}, film.width);
  film.crop_height = p.integer({"crop_height"}, film.height);
  const auto inside = [](int64_t offset, int64_t size, int64_t whole) {
    return offset >= 0 && size > 0 && offset + size <= whole;
  };
  if (!inside(film.crop_x, film.crop_width, film.width) ||
      !inside(film.crop_y, film.crop_height, film.height)) {
    throw Error(
        "{}: the crop window of {} x {} pixels at ({}, {}) is not inside the film of {} x {}; "
        "correct it.",
        node.source.to_string(), film.crop_width, film.crop_height, film.crop_x, film.crop_y,
        film.width, film.height);
  }
  const bool is_whole = film.crop_width == film.width && film.crop_height == film.height;
  if (is_whole) film.crop_width = film.crop_height = 0;
  if (const Node* filter = p.object("rfilter")) reconstruction_filter(*filter);
}

void Importer::reconstruction_filter(const Node& node) {
  Properties p(node, warnings_);
  FilterSettings& filter = scene_.film.filter;
  filter.radius = std::clamp(p.number({"radius"}, 0), 0.0f, 32.0f);
  if (node.type == "box") {
    filter.kind = FilterKind::Box;
  } else if (node.type == "tent") {
    filter.kind = FilterKind::Tent;
  } else if (node.type == "gaussian") {
    filter.kind = FilterKind::Gaussian;
    filter.stddev = std::clamp(p.number({"stddev"}, 0.5f), 1e-2f, 32.0f);
    if (filter.radius == 0) filter.radius = 4 * filter.stddev;
  } else if (node.type == "mitchell") {
    filter.kind = FilterKind::Mitchell;
    filter.b = p.number({"b"}, filter.b);
    filter.c = p.number({"c"}, filter.c);
  } else if (node.type == "catmullrom") {  // a member of the same family
    filter.kind = FilterKind::Mitchell;
    filter.b = 0;
    filter.c = 0.5f;
  } else {
    warnings_.add(node.source, plugin_name(node),
                  fmt::format("{} is not supported; a Gaussian stands in.", plugin_name(node)));
    return;
  }
  p.warn_about_the_rest();
}

void Importer::integrator(const Node& node) {
  Properties p(node, warnings_);
  // Wrappers such as aov or adaptive leave the transport to the integrator inside them.
  if (const Node* nested = p.object("integrator")) return integrator(*nested);
  RenderHints& hints = scene_.hints;
  hints.integrator = node.type;
  if (p.find({"max_depth"})) {
    const int depth = p.integer({"max_depth"}, -1);
    hints.max_depth = depth < 0 ? -1 : depth;
  }
  if (p.find({"rr_depth"})) hints.russian_roulette_depth = p.integer({"rr_depth"}, 5);
  if (p.boolean({"hide_emitters"}, false)) {
    warnings_.add(node.source, "hide_emitters",
                  "'hideEmitters' is not supported; lights stay visible.");
  }
}

}  // namespace guidelight::mitsuba
