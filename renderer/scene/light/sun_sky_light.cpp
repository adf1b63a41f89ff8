#include "renderer/error.h"
#include "renderer/math/axes.h"
#include "renderer/scene/light/daylight.h"
#include "renderer/scene/light/lights.h"

namespace guidelight {

namespace {

/// The sky as a latitude-longitude image, its lower half black.
std::shared_ptr<const Image> bake_sky(const Daylight& daylight) {
  constexpr int kWidth = 512;
  constexpr int kHeight = 512;
  auto image = std::make_shared<Image>(kWidth, kHeight, 3);
  for (int y = 0; y < kHeight / 2; ++y) {
    const float theta = (static_cast<float>(y) + 0.5f) * kPi / kHeight;
    for (int x = 0; x < kWidth; ++x) {
      const float phi = (static_cast<float>(x) + 0.5f) * 2 * kPi / kWidth;
      const Vec3 direction(std::sin(theta) * std::sin(phi), std::cos(theta),
                           -std::sin(theta) * std::cos(phi));
      const Color radiance = daylight.sky_radiance(direction);
      for (int c = 0; c < 3; ++c) image->pixel(x, y)[c] = radiance[c];
    }
  }
  return image;
}

}  // namespace

std::vector<std::unique_ptr<Light>> make_sun_sky_lights(const SunSkyEmitter& emitter,
                                                        const LightContext& context) {
  const auto axes = orthonormal_axes(emitter.to_world);
  if (!axes)
    throw Error("the transform is singular or not finite; give it one that can be inverted");
  if (!(length_squared(emitter.sun_direction) > 0)) {
    throw Error("the direction of the sun has no length; give it one");
  }
  const Daylight daylight(emitter.sun_direction, emitter.turbidity);
  std::vector<std::unique_ptr<Light>> lights;
  const Vec3 towards_sun = glm::normalize(*axes * emitter.sun_direction);
  const Color sun = emitter.sun_scale * daylight.sun_radiance();
  if (emitter.sun && !is_black(sun)) {
    // A larger sun keeps its power; one of no size would be a direction, for which a thousandth is
    // as good.
    const float size = std::max(emitter.sun_radius_scale, 1e-3f);
    const float radius = std::min(size * Daylight::kSunAngularRadius, 0.5f * kPi);
    const float dimming =
        sqr(std::sin(0.5f * Daylight::kSunAngularRadius) / std::sin(0.5f * radius));
    lights.push_back(make_distant_disc_light(towards_sun, radius, sun * dimming, context));
  }
  if (emitter.sky) {
    const EnvironmentEmitter sky{bake_sky(daylight), emitter.to_world, emitter.sky_scale};
    lights.push_back(make_environment_light(sky, context));
  }
  return lights;
}

}  // namespace guidelight
