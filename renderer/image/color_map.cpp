#include <algorithm>
#include <cstdint>
#include <span>

#include "renderer/image/tonemap.h"

namespace guidelight {

namespace {

// Equally spaced samples of the published maps, 0xRRGGBB, interpolated linearly between.

/// Smith & van der Walt 2015 (CC0).
constexpr uint32_t kViridis[] = {0x440154, 0x482475, 0x414487, 0x355f8d, 0x2a788e, 0x21908c,
                                 0x22a884, 0x43bf71, 0x7ad151, 0xbbdf27, 0xfde725};
constexpr uint32_t kMagma[] = {0x000004, 0x140e36, 0x3b0f70, 0x641a80, 0x8c2981, 0xb63679,
                               0xde4968, 0xf76f5c, 0xfe9f6d, 0xfece91, 0xfcfdbf};
/// Mikhailov 2019.
constexpr uint32_t kTurbo[] = {0x30123b, 0x4145ab, 0x4675ed, 0x39a2fc, 0x1bcfd4,
                               0x24eca6, 0x61fc6c, 0xa4fc3b, 0xd1e834, 0xf3c63a,
                               0xfe9b2d, 0xf36315, 0xd93806, 0xb11901, 0x7a0402};

std::span<const uint32_t> samples_of(ColorMap map) {
  switch (map) {
    case ColorMap::Viridis:
      return kViridis;
    case ColorMap::Turbo:
      return kTurbo;
    case ColorMap::Magma:
      break;
  }
  return kMagma;
}

Color unpack(uint32_t rgb) { return Color(rgb >> 16 & 0xff, rgb >> 8 & 0xff, rgb & 0xff) / 255.0f; }

}  // namespace

Color color_map(ColorMap map, float t) {
  const auto samples = samples_of(map);
  const float position =
      (t > 0 ? std::min(t, 1.0f) : 0.0f) * static_cast<float>(samples.size() - 1);
  const size_t first = std::min(static_cast<size_t>(position), samples.size() - 2);
  return glm::mix(unpack(samples[first]), unpack(samples[first + 1]),
                  position - static_cast<float>(first));
}

}  // namespace guidelight
