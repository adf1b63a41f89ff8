#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/io/mitsuba/importer.h"
#include "renderer/io/sun_position.h"
#include "renderer/scene/field_of_view.h"

namespace guidelight::mitsuba {

void Importer::emitter(const Node& node) {
  if (node.type == "area") return;  // stands there to be referred to
  Properties p(node, warnings_);
  p.ignore({"sampling_weight", "cache", "mis_compensation"});
  const std::optional<EmitterModel> model = emitter_model(p);
  if (!model) {
    warnings_.add(node.source, plugin_name(node),
                  fmt::format("{} is not supported; it is left out.", plugin_name(node)));
    return;
  }
  p.warn_about_the_rest();
  scene_.emitters.push_back({node.id, node.source.line, *model});
}

std::optional<Importer::EmitterModel> Importer::emitter_model(Properties& p) {
  const std::string& type = p.node().type;
  const auto emission = [&](Properties::Names names) {
    return constant_color(p, names, Color(1), SpectrumUse::Emission);
  };
  if (type == "point") {
    const Vec3 origin = transform_point(p.transform({"to_world"}), Vec3(0));
    return PointEmitter{p.vector({"position"}, origin), emission({"intensity"})};
  }
  if (type == "spot") return spot(p);
  if (type == "directional") {
    const Vec3 forward = transform_vector(p.transform({"to_world"}), Vec3(0, 0, 1));
    const Vec3 direction = p.vector({"direction"}, forward);
    if (!(length_squared(direction) > 0)) {
      throw Error("{}: the light's direction is zero; give it one.", p.node().source.to_string());
    }
    return DirectionalEmitter{glm::normalize(direction), emission({"irradiance"})};
  }
  if (type == "constant") return ConstantEmitter{emission({"radiance"})};
  if (type == "envmap") {
    const bool raw = p.number({"gamma"}, -1) == 1;
    return EnvironmentEmitter{image(p, raw), p.transform({"to_world"}), p.number({"scale"}, 1)};
  }
  if (type == "sun" || type == "sky" || type == "sunsky") return sun_sky(p);
  if (type == "projector") return projector(p);
  return std::nullopt;
}

SpotEmitter Importer::spot(Properties& p) {
  SpotEmitter light;
  light.to_world = p.transform({"to_world"});
  light.intensity = constant_color(p, {"intensity"}, Color(1), SpectrumUse::Emission);
  const float cutoff = std::clamp(p.number({"cutoff_angle"}, 20), 0.01f, 179.9f);
  const float beam = std::clamp(p.number({"beam_width"}, cutoff * 3 / 4), 0.0f, cutoff);
  light.cutoff_angle = cutoff * kPi / 180;
  light.beam_width = beam * kPi / 180;
  if (const Node* map = p.find({"texture"})) {
    const ColorInput input = color_input(*map, SpectrumUse::Emission);
    light.texture = input.texture;
    light.intensity *= input.value;
  }
  return light;
}

SunSkyEmitter Importer::sun_sky(Properties& p) {
  SunSkyEmitter light;
  const std::string& type = p.node().type;
  light.sun = type != "sky";
  light.sky = type != "sun";
  light.turbidity = std::clamp(p.number({"turbidity"}, 3), 1.7f, 10.0f);
  const float scale = p.number({"scale"}, 1);
  light.sun_scale = p.number({"sun_scale"}, 1) * scale;
  light.sky_scale = p.number({"sky_scale"}, 1) * scale;
  light.sun_radius_scale = p.number({"sun_radius_scale"}, 1);
  // Version 3 gives the sun's diameter in degrees instead.
  if (p.find({"sun_aperture"}))
    light.sun_radius_scale = p.number({"sun_aperture"}, 0.5358f) / 0.5358f;
  light.ground_albedo = constant_color(p, {"albedo"}, Color(0.15f), SpectrumUse::Reflectance);
  light.to_world = p.transform({"to_world"});
  if (document_.version >= 3) {  // there, up is +z
    light.to_world = light.to_world * glm::rotate(Mat4(1), kPi / 2, Vec3(1, 0, 0));
  }

  PlaceAndTime when;
  when.year = p.integer({"year"}, when.year);
  when.month = p.integer({"month"}, when.month);
  when.day = p.integer({"day"}, when.day);
  when.hour = p.number({"hour"}, when.hour);
  when.minute = p.number({"minute"}, when.minute);
  when.second = p.number({"second"}, when.second);
  when.latitude = p.number({"latitude"}, when.latitude);
  when.longitude = p.number({"longitude"}, when.longitude);
  when.timezone = p.number({"timezone"}, when.timezone);
  light.sun_direction = sun_direction(when);
  if (p.find({"sun_direction"})) {
    const Vec3 world = p.vector({"sun_direction"}, Vec3(0, 1, 0));
    const Vec3 local = transform_vector(glm::inverse(light.to_world), world);
    if (!(length_squared(local) > 0)) {
      throw Error("{}: the sun's direction is zero; give it one.", p.node().source.to_string());
    }
    light.sun_direction = glm::normalize(local);
  }
  p.ignore({"resolution", "complex_sun"});
  return light;
}

ProjectorEmitter Importer::projector(Properties& p) {
  ProjectorEmitter light;
  light.to_world = p.transform({"to_world"});
  light.scale = p.number({"scale"}, 1);
  light.image = projected_image(p, light.scale);
  const float aspect =
      static_cast<float>(light.image->width()) / static_cast<float>(light.image->height());
  const auto [fov, axis] = field_of_view(p);
  light.fov_x = 2 * std::atan(half_extent(fov, axis, aspect).x);
  return light;
}

/// The image of a bitmap; a colour is an image of one pixel.
std::shared_ptr<const Image> Importer::projected_image(Properties& p, float& scale) {
  const Node* map = p.find({"irradiance"});
  if (!map) map = p.object("texture");
  if (!map && p.find({"filename"})) return image(p, false);
  const ColorInput input = map ? color_input(*map, SpectrumUse::Emission) : ColorInput{};
  if (input.texture != kNone) {
    if (const auto* bitmap = std::get_if<BitmapTexture>(&scene_.textures[input.texture].model)) {
      scale *= luminance(input.value);
      return bitmap->image;
    }
    warnings_.add(map->source, "projected texture",
                  "only bitmaps can be projected; a plain colour stands in.");
  }
  auto pixel = std::make_shared<Image>(1, 1, 3);
  for (int c = 0; c < 3; ++c) pixel->data()[c] = input.value[c];
  return pixel;
}

}  // namespace guidelight::mitsuba
