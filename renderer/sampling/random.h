#pragma once

#include <cstdint>

#include "renderer/math/vector.h"

namespace guidelight {

/// Mixes 64 bits so that every input bit affects every output bit (the finaliser of SplitMix64,
/// Steele et al. 2014).
constexpr uint64_t mix_bits(uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

/// Random numbers of one path: a PCG32 stream (O'Neill 2014) whose state and sequence are hashed
/// from (seed, pass, path index). Nothing is shared between paths, so any path can be traced again,
/// on any thread, in any order.
class Rng {
 public:
  Rng(uint64_t seed, uint64_t pass, uint64_t path) {
    const uint64_t key = mix_bits(mix_bits(mix_bits(seed) ^ pass) ^ path);
    state_ = mix_bits(key);
    increment_ = key | 1u;
  }

  uint32_t next_uint() {
    const uint64_t old = state_;
    state_ = old * 6364136223846793005ull + increment_;
    const auto shifted = static_cast<uint32_t>(((old >> 18u) ^ old) >> 27u);
    const auto rotation = static_cast<uint32_t>(old >> 59u);
    return (shifted >> rotation) | (shifted << ((32u - rotation) & 31u));
  }

  /// Uniform in [0,1), 24 bits: never 1.
  float next_float() { return static_cast<float>(next_uint() >> 8) * 0x1p-24f; }

  Vec2 next_vec2() {
    const float x = next_float();
    return {x, next_float()};
  }

 private:
  uint64_t state_;
  uint64_t increment_;
};

}  // namespace guidelight
