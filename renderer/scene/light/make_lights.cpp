#include "renderer/error.h"
#include "renderer/scene/light/lights.h"

namespace guidelight {

namespace {

/// One overload per kind of emitter.
struct Maker {
  const LightContext& context;

  using Lights = std::vector<std::unique_ptr<Light>>;

  Lights operator()(const PointEmitter& e) const { return one(make_point_light(e)); }
  Lights operator()(const SpotEmitter& e) const { return one(make_spot_light(e, context)); }
  Lights operator()(const DirectionalEmitter& e) const {
    return one(make_directional_light(e, context));
  }
  Lights operator()(const ConstantEmitter& e) const { return one(make_constant_light(e, context)); }
  Lights operator()(const EnvironmentEmitter& e) const {
    return one(make_environment_light(e, context));
  }
  Lights operator()(const ProjectorEmitter& e) const { return one(make_projector_light(e)); }
  Lights operator()(const SunSkyEmitter& e) const { return make_sun_sky_lights(e, context); }

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
