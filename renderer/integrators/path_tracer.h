#pragma once

#include "renderer/integrators/integrator.h"

namespace guidelight {

/// Settings of the path tracer.
struct PathTracerSettings : IntegratorSettings {
  int max_depth = -1;              // segments; 1 shows emitters only, -1 has no limit
  int russian_roulette_depth = 3;  // segments before paths may be ended by chance

  std::vector<Parameter> parameters() override;
  std::unique_ptr<IntegratorSettings> clone() const override;
};

/// Unidirectional path tracing with next-event estimation, combined with BSDF sampling by the power
/// heuristic (Veach 1997, section 9.2), and Russian roulette. The oracle of the other integrators:
/// it shares nothing with them but the scene.
IntegratorInfo path_tracer_info();

}  // namespace guidelight
