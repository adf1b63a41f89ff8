#pragma once

#include <bit>

#include "renderer/sampling/random.h"

namespace guidelight {

/// Bits that look random and depend on a place alone.
inline uint64_t hash_position(Vec3 p) {
  const uint64_t xy =
      static_cast<uint64_t>(std::bit_cast<uint32_t>(p.x)) << 32 | std::bit_cast<uint32_t>(p.y);
  return mix_bits(mix_bits(xy) ^ std::bit_cast<uint32_t>(p.z));
}

}  // namespace guidelight
