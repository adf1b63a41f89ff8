#pragma once

#include <vector>

#include "renderer/integrators/integrator.h"

namespace guidelight {

/// Light tracing, BDPT, probabilistic PPM (Knaus and Zwicker 2011), BPM and VCM (Georgiev et al.
/// 2012): one kernel, in which each takes part of the techniques.
std::vector<IntegratorInfo> bidirectional_infos();

}  // namespace guidelight
