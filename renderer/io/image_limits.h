#pragma once

#include <cstddef>
#include <cstdint>

#include "renderer/error.h"

namespace guidelight {

/// Refuses sizes that no honest file of `file_bytes` bytes has, before anything is allocated for
/// them: more than 65536 pixels a side, more than 1 GiB of floats, or more than 384 MiB of them in
/// a file that would have to be compressed over 256 times. Throws Error with the reason only.
inline void check_image_size(int64_t width, int64_t height, int channels, size_t file_bytes) {
  constexpr int64_t kMaxSide = 65536;
  constexpr int64_t kMaxBytes = int64_t{1} << 30;
  constexpr int64_t kAlwaysAllowed = int64_t{384} << 20;
  if (width < 1 || height < 1 || channels < 1) {
    throw Error("it claims {} x {} pixels with {} channels", width, height, channels);
  }
  const int64_t bytes = width > kMaxSide || height > kMaxSide
                            ? kMaxBytes + 1
                            : width * height * channels * static_cast<int64_t>(sizeof(float));
  const bool implausible =
      bytes > kAlwaysAllowed && bytes / 1024 > static_cast<int64_t>(file_bytes);
  if (bytes > kMaxBytes || implausible) {
    throw Error("it claims {} x {} pixels with {} channels, too much for {}", width, height,
                channels, implausible ? "the size of the file" : "this program");
  }
}

}  // namespace guidelight
