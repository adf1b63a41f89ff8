#pragma once

#include <cstdint>

namespace guidelight {

inline constexpr int kMaxFilmSide = 65536;  // [pixels]
inline constexpr int64_t kMaxFilmPixels = int64_t{1} << 28;

/// Whether a film has pixels, and no more than can be meant; to be asked before anything is
/// allocated for it.
constexpr bool is_film_size(int64_t width, int64_t height) {
  return width > 0 && height > 0 && width <= kMaxFilmSide && height <= kMaxFilmSide &&
         width * height <= kMaxFilmPixels;
}

}  // namespace guidelight
