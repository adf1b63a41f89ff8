#include "renderer/integrators/search_radius.h"

namespace guidelight {

std::vector<Parameter> RadiusSettings::radius_parameters() {
  const bool from_scene = radius_from == 0;
  return {
      {"radius_from", "Radius from",
       "What the initial radius is measured in: the scene's size or the pixel's footprint where "
       "the camera path first meets a surface that is not specular.",
       "", Parameter::Choice{&radius_from, {"scene", "pixel"}}},
      {"scene_radius", "Radius",
       "Initial radius, in percent of that of the scene's bounding sphere.", "% of scene",
       &scene_radius, 0, 100, true, from_scene ? "" : "The radius is from the pixel."},
      {"pixel_radius", "Radius in pixels", "Initial radius, in footprints of a pixel.", "pixels",
       &pixel_radius, 0, 1000, true, from_scene ? "The radius is from the scene." : ""},
  };
}

SearchRadius::SearchRadius(const Scene& scene, const RadiusSettings& settings) {
  const Camera& camera = scene.camera();
  if (settings.radius_from == 0) {
    constant_ = 0.01f * settings.scene_radius * scene.bounds().radius();
  } else {
    per_spread_ = settings.pixel_radius * camera.pixel_size_at_unit_distance();
  }
  typical_ = seen_directly(camera, glm::distance(scene.bounds().center(), camera.position()));
}

}  // namespace guidelight
