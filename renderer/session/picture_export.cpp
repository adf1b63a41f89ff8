#include "renderer/session/picture_export.h"

#include <algorithm>
#include <filesystem>

#include "renderer/error.h"
#include "renderer/image/technique_images.h"
#include "renderer/io/guide_file.h"

namespace guidelight {

namespace {

std::string matrix_text(const Mat4& m) {
  std::string text;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      text += fmt::format("{}{}", text.empty() ? "" : " ", m[column][row]);
    }
  }
  return text;
}

/// The job's region of an image, or all of it. Coarse pictures are kept whole.
Image crop(const Image& image, const RenderJob& job, const Snapshot& snapshot) {
  if (!job.region || snapshot.coarse) return image;
  const auto whole = PixelRegion::whole(image.width(), image.height());
  const PixelRegion shown = intersection(*job.region, whole);
  if (shown.empty()) {
    throw Error("the render region lies outside the {}x{} picture: choose one inside",
                image.width(), image.height());
  }
  return cropped(image, shown);
}

std::string extension(const std::string& path) {
  std::string text = std::filesystem::path(path).extension().string();
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

void require_picture(const Snapshot& snapshot) {
  if (!snapshot.has_picture()) throw Error("there is no picture yet: wait for the first pass");
}

}  // namespace

Metadata describe_render(const RenderJob& job, const Snapshot& snapshot) {
  const SceneDescription& description = job.scene->description();
  Metadata data;
  data["software"] = "Guidelight";
  data["scene"] = description.path;
  data["scene_hash"] = description.file_hash;
  for (const auto& [name, value] : description.defines) data["define." + name] = value;
  data["integrator"] = job.integrator;
  const auto settings = job.settings
                            ? job.settings->clone()
                            : find_integrator(job.integrator).make_settings(description.hints);
  for (const Parameter& parameter : settings->parameters()) {
    data["set." + parameter.key] = parameter_text(parameter);
  }
  if (job.guides && !job.guides->empty()) data["guides"] = guides_text(*job.guides);
  data["passes"] = fmt::format("{}", snapshot.passes);
  data["seconds"] = fmt::format("{:.3f}", snapshot.seconds);
  data["seed"] = fmt::format("{}", job.seed);
  data["camera_to_world"] = matrix_text(job.scene->camera().description().to_world);
  data["size"] = fmt::format("{}x{}", snapshot.full_width, snapshot.full_height);
  if (job.region) {
    data["region"] =
        fmt::format("{},{},{},{}", job.region->x0, job.region->y0, job.region->x1, job.region->y1);
  }
  return data;
}

void export_exr(const std::string& path, const RenderJob& job, const Snapshot& snapshot,
                bool half_precision) {
  require_picture(snapshot);
  ImageLayers picture;
  picture.metadata = describe_render(job, snapshot);
  for (const Layer layer : kAllLayers) {
    picture.layers.emplace_back(layer_name(layer), crop(snapshot.layer(layer), job, snapshot));
  }
  write_exr(path, picture, half_precision);
}

void check_techniques(const std::string& path, const std::string& integrator) {
  if (extension(path) != ".exr") {
    throw Error("{}: techniques are layers of an .exr: choose this ending", path);
  }
  if (!find_integrator(integrator).combines_techniques) {
    throw Error("{}: the integrator '{}' does not combine techniques: choose bdpt or vcm", path,
                integrator);
  }
}

void export_techniques(const std::string& path, const RenderJob& job, const Snapshot& snapshot) {
  ImageLayers picture;
  if (job.techniques) {
    for (const auto& [technique, images] : job.techniques->develop()) {
      picture.layers.emplace_back(technique.name() + ".weighted", images.weighted);
      picture.layers.emplace_back(technique.name() + ".raw", images.raw);
    }
  }
  if (picture.layers.empty()) throw Error("{}: there are no techniques yet: render longer", path);
  picture.metadata = describe_render(job, snapshot);
  write_exr(path, picture);
}

void export_png(const std::string& path, const RenderJob& job, const Snapshot& snapshot,
                const DisplaySettings& display, Layer layer) {
  require_picture(snapshot);
  DisplayImage image;
  display_image(crop(snapshot.layer(layer), job, snapshot), display, image);
  Metadata data = describe_render(job, snapshot);
  data["layer"] = layer_name(layer);
  data["exposure"] = fmt::format("{}", display.exposure);
  write_png(path, image, data);
}

bool is_picture_path(const std::string& path) {
  const std::string ending = extension(path);
  return ending == ".exr" || ending == ".png";
}

void check_picture_path(const std::string& path) {
  if (!is_picture_path(path)) {
    throw Error("{}: pictures are written as .exr or .png: choose one of these endings", path);
  }
}

void export_picture(const std::string& path, const RenderJob& job, const Snapshot& snapshot,
                    bool full_float) {
  check_picture_path(path);
  if (extension(path) == ".exr") {
    export_exr(path, job, snapshot, !full_float);
  } else {
    export_png(path, job, snapshot, {});
  }
}

}  // namespace guidelight
