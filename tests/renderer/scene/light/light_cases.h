#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "renderer/scene/accelerator.h"
#include "renderer/scene/light/light.h"

/// Lights of every kind for tests of their sampling; all shine at the origin.
namespace guidelight::light_test {

inline const Color kRadiance(2, 1, 0.5f);

/// A light, with the surface it lies on if it has one.
struct Lamp {
  std::unique_ptr<Shape> shape;
  std::unique_ptr<Accelerator> accelerator;
  std::unique_ptr<Light> light;

  /// The point of the light that a ray meets; false if it misses.
  bool intersect(const Ray& ray, SurfacePoint& point) const {
    const Hit hit = accelerator->intersect(ray);
    if (hit.valid()) shape->fill(ray, hit, point);
    return hit.valid();
  }
};

/// What lights are told of the scene.
LightContext context();
Lamp area_lamp(const ShapeDescription& description);
/// Of an emitter that makes one light.
Lamp other_lamp(decltype(EmitterDescription::model) model);

struct Case {
  const char* name;
  std::function<Lamp()> make;
};

/// On surfaces; of infinite distance; such that no ray meets them by chance.
const std::vector<Case>& area_lights();
const std::vector<Case>& distant_lights();
const std::vector<Case>& delta_lights();
std::vector<Case> non_delta_lights();
std::vector<Case> all_lights();

inline const auto kCaseName = [](const auto& test) { return test.param.name; };

}  // namespace guidelight::light_test
