#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <unordered_map>

#include "renderer/math/vector.h"

namespace guidelight {

/// Where light paths that follow guides leave their photons, and which guide it was: photons
/// themselves have no room for it. Kept only when somebody wants to see it.
class GuidedPlaces {
 public:
  /// Thread safe. `guide`: position in the list of guides.
  void note(Vec3 position, uint32_t guide);
  /// Of exactly the position that was noted. Not while a pass is under way.
  std::optional<uint32_t> guide_at(Vec3 position) const;

 private:
  struct Part {
    std::mutex mutex;
    std::unordered_map<uint64_t, uint32_t> guides;  // by a hash of the position
  };
  std::array<Part, 32> parts_;  // so that threads seldom wait for each other
};

}  // namespace guidelight
