#include "renderer/error.h"
#include "renderer/scene/light/lights.h"
#include "renderer/scene/reach.h"

namespace guidelight {

namespace {

/// One overload per kind of emitter.
struct Maker {
  const LightContext& context;

  using Lights = std::vector<std::unique_ptr<Light>>;

  Lights operator()(const PointEmitter& e) const {
    check_position(e.position);
    return one(make_point_light(e));
  }
  Lights operator()(const SpotEmitter& e) const {
    check_position(e.to_world[3]);
    return one(make_spot_light(e, context));
  }
  Lights operator()(const DirectionalEmitter& e) const {
    return one(make_directional_light(e, context));
  }
  Lights operator()(const ConstantEmitter& e) const { return one(make_constant_light(e, context)); }
  Lights operator()(const EnvironmentEmitter& e) const {
    return one(make_environment_light(e, context));
  }
  Lights operator()(const ProjectorEmitter& e) const {
    check_position(e.to_world[3]);
    return one(make_projector_light(e));
  }
  Lights operator()(const SunSkyEmitter& e) const { return make_sun_sky_lights(e, context); }

  static void check_position(Vec3 position) {
    if (is_within(position, kLargestCoordinate)) return;
    throw Error("it is not finite or farther than {} from the origin; move it", kLargestCoordinate);
  }

  static Lights one(std::unique_ptr<Light> light) {
    Lights lights;
    lights.push_back(std::move(light));
    return lights;
  }
};

}  // namespace

std::vector<std::unique_ptr<Light>> make_lights(const EmitterDescription& description,
                                                const LightContext& context) {
  try {
    return std::visit(Maker{context}, description.model);
  } catch (const Error& error) {
    throw Error("line {}: emitter '{}': {}", description.line, description.name, error.what());
  }
}

}  // namespace guidelight
