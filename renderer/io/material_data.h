#pragma once

#include <optional>
#include <string_view>

#include "renderer/math/vector.h"

/// Named materials of the Mitsuba formats.
namespace guidelight {

/// Index of refraction of a dielectric such as "bk7", "water" or "diamond"; case does not matter.
std::optional<float> named_ior(std::string_view name);

struct ConductorData {
  Color eta;
  Color k;
};

/// Complex index of a conductor such as "Au" or "Cu"; "none" is a perfect mirror.
std::optional<ConductorData> named_conductor(std::string_view name);

}  // namespace guidelight
