#pragma once

#include "renderer/scene/light/light.h"

/// The kinds of light, one file each; only make_lights() and tests name them.
namespace guidelight {

std::unique_ptr<Light> make_point_light(const PointEmitter& emitter);
/// Throws Error for a singular transform.
std::unique_ptr<Light> make_spot_light(const SpotEmitter& emitter, const LightContext& context);
/// Throws Error for a direction of no length.
std::unique_ptr<Light> make_directional_light(const DirectionalEmitter& emitter,
                                              const LightContext& context);
std::unique_ptr<Light> make_constant_light(const ConstantEmitter& emitter,
                                           const LightContext& context);
/// Throws Error for a missing image or a singular transform.
std::unique_ptr<Light> make_environment_light(const EnvironmentEmitter& emitter,
                                              const LightContext& context);
/// Throws Error for a missing image, a singular transform or a field of view outside (0,π).
std::unique_ptr<Light> make_projector_light(const ProjectorEmitter& emitter);
/// A cone of constant radiance around `towards` (unit, away from the scene).
std::unique_ptr<Light> make_distant_disc_light(Vec3 towards, float angular_radius, Color radiance,
                                               const LightContext& context);
/// The sun, the sky or both. Throws Error for a singular transform.
std::vector<std::unique_ptr<Light>> make_sun_sky_lights(const SunSkyEmitter& emitter,
                                                        const LightContext& context);

}  // namespace guidelight
