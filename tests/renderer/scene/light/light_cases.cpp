#include "tests/renderer/scene/light/light_cases.h"

#include <gtest/gtest.h>

#include "renderer/sampling/random.h"
#include "tests/renderer/scene/shape_cases.h"

namespace guidelight::light_test {

using namespace shape_test;

LightContext context() {
  LightContext result;
  result.scene_center = {0.5f, 0, 0};
  result.scene_radius = 4;
  return result;
}

Lamp area_lamp(const ShapeDescription& description) {
  Lamp lamp;
  lamp.shape = make_shape(description);
  lamp.accelerator = std::make_unique<Accelerator>(1);
  lamp.accelerator->add_shape(*lamp.shape, 0);
  lamp.accelerator->build();
  lamp.light = make_area_light({kRadiance, kNone}, *lamp.shape, context());
  return lamp;
}

Lamp other_lamp(decltype(EmitterDescription::model) model) {
  EmitterDescription description;
  description.name = "test";
  description.model = std::move(model);
  Lamp lamp;
  auto lights = make_lights(description, context());
  EXPECT_EQ(lights.size(), 1u);
  lamp.light = std::move(lights.at(0));
  return lamp;
}

namespace {

std::shared_ptr<const Image> noise_image(int width, int height) {
  auto image = std::make_shared<Image>(width, height, 3);
  Rng rng(99, 0, 0);
  for (float& v : image->data()) v = rng.next_float() < 0.4f ? 0 : 3 * sqr(rng.next_float());
  return image;
}

/// Looks from (0,1,-2.5) at the origin, roughly.
Mat4 towards_receiver() {
  return glm::translate(Mat4(1), Vec3(0, 1, -2.5f)) * glm::rotate(Mat4(1), 0.3f, Vec3(1, 0.2f, 0));
}

SunSkyEmitter sun_sky(bool sun, bool sky) {
  SunSkyEmitter emitter;
  emitter.sun = sun;
  emitter.sky = sky;
  emitter.sun_direction = glm::normalize(Vec3(0.3f, 1, -0.8f));
  emitter.sun_radius_scale = 200;
  emitter.to_world = glm::rotate(Mat4(1), 0.4f, Vec3(0.2f, 1, 0));
  return emitter;
}

EnvironmentEmitter environment() { return {noise_image(13, 9), placed({}, {-1, 1, 1}), 0.7f}; }

SpotEmitter spot() {
  SpotEmitter emitter;
  emitter.to_world = towards_receiver();
  emitter.cutoff_angle = 0.5f;
  emitter.beam_width = 0.2f;
  return emitter;
}

}  // namespace

const std::vector<Case>& area_lights() {
  static const std::vector<Case> lights = {
      {"rectangle",
       [] {
         return area_lamp(describe(square(), placed({0, 1, -2.5f}, {1.5f, 0.7f, 1})));
       }},
      {"cube",
       [] {
         return area_lamp(describe(cube(), placed({0.6f, 0.4f, -2.5f}, {0.5f, 0.7f, 0.2f})));
       }},
      {"sphere",
       [] {
         return area_lamp(describe(SphereShape{}, placed({0, 1, -2.5f}, Vec3(0.8f))));
       }},
      {"ellipsoid",
       [] {
         return area_lamp(describe(SphereShape{}, placed({0, 1, -2.5f}, {1.5f, 0.6f, 0.3f})));
       }},
      {"disk",
       [] {
         return area_lamp(describe(DiskShape{}, placed({0, 1, -2.5f}, {1, 0.5f, 1})));
       }},
      {"cylinder",
       [] {
         return area_lamp(describe(CylinderShape{}, placed({0, 1, -2.5f}, {0.5f, 0.4f, 1})));
       }},
      {"around_it", [] { return area_lamp(describe(SphereShape{}, placed({}, Vec3(4)), true)); }},
  };
  return lights;
}

const std::vector<Case>& distant_lights() {
  static const std::vector<Case> lights = {
      {"constant", [] { return other_lamp(ConstantEmitter{kRadiance}); }},
      {"environment", [] { return other_lamp(environment()); }},
      {"sun", [] { return other_lamp(sun_sky(true, false)); }},
      {"sky", [] { return other_lamp(sun_sky(false, true)); }},
  };
  return lights;
}

const std::vector<Case>& delta_lights() {
  static const std::vector<Case> lights = {
      {"point",
       [] {
         return other_lamp(PointEmitter{{0, 1, -2.5f}, kRadiance});
       }},
      {"spot", [] { return other_lamp(spot()); }},
      {"projector",
       [] {
         return other_lamp(ProjectorEmitter{towards_receiver(), noise_image(7, 5), 0.8f, 2});
       }},
      {"directional",
       [] {
         return other_lamp(DirectionalEmitter{{1, -2, 3}, kRadiance});
       }},
  };
  return lights;
}

std::vector<Case> non_delta_lights() {
  std::vector<Case> all = area_lights();
  all.insert(all.end(), distant_lights().begin(), distant_lights().end());
  return all;
}

std::vector<Case> all_lights() {
  std::vector<Case> all = non_delta_lights();
  all.insert(all.end(), delta_lights().begin(), delta_lights().end());
  return all;
}

}  // namespace guidelight::light_test
