#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "renderer/integrators/integrator.h"
#include "tests/statistics/hypothesis_tests.h"

/// Independent runs of a method, judged by the means of blocks of the picture: what is compared by
/// t-tests.
namespace guidelight::testing {

struct Method {
  std::string name;        // of the integrator
  std::string parameters;  // key=value,key=value
  uint32_t passes = 8;     // of a run
};
inline void PrintTo(const Method& method, std::ostream* out) { *out << method.name; }

struct Runs {
  int count;
  uint64_t first_seed;  // the others follow
  int block;            // side of the blocks in pixels; divides the picture's sides
  /// Guides of pass i are number i modulo their count; null is without guides.
  std::vector<std::shared_ptr<const GuideMixture>> guides = {nullptr};
};

/// Of each block's mean luminance, and last of the whole picture's.
std::vector<statistics::Moments> measure(std::shared_ptr<const Scene> scene, const Method& method,
                                         const Runs& runs);

/// Says both means with their standard errors.
std::string describe(const statistics::Moments& found, const statistics::Moments& expected);

}  // namespace guidelight::testing
