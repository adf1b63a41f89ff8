#pragma once

#include <set>
#include <string>
#include <vector>

#include "renderer/scene/description.h"

namespace guidelight::testing {

/// Side of their square pictures in pixels.
inline constexpr int kComparisonSide = 64;

/// Small scenes on which methods are compared: each has something that is easily got wrong.
struct ComparisonScene {
  std::string name;
  SceneDescription (*make)();
  bool is_diffuse;  // light tracing sees all of it
};
const std::vector<ComparisonScene>& comparison_scenes();
/// Some of them.
std::vector<ComparisonScene> comparison_scenes(const std::set<std::string>& names);

}  // namespace guidelight::testing
