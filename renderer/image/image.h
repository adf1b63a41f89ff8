#pragma once

#include <span>
#include <vector>

#include "renderer/math/vector.h"

namespace guidelight {

/// Row-major float image, top row first, channels interleaved. Values are linear.
class Image {
 public:
  Image() = default;
  Image(int width, int height, int channels)
      : width_(width),
        height_(height),
        channels_(channels),
        data_(static_cast<size_t>(width) * height * channels) {}

  int width() const { return width_; }
  int height() const { return height_; }
  int channels() const { return channels_; }
  bool empty() const { return data_.empty(); }
  size_t pixel_count() const { return static_cast<size_t>(width_) * height_; }

  float* pixel(int x, int y) { return &data_[(static_cast<size_t>(y) * width_ + x) * channels_]; }
  const float* pixel(int x, int y) const {
    return &data_[(static_cast<size_t>(y) * width_ + x) * channels_];
  }
  /// RGB of a pixel; an image of one or two channels is grey.
  Color color(int x, int y) const {
    const float* p = pixel(x, y);
    return channels_ >= 3 ? Color(p[0], p[1], p[2]) : Color(p[0]);
  }

  std::span<float> data() { return data_; }
  std::span<const float> data() const { return data_; }

 private:
  int width_ = 0;
  int height_ = 0;
  int channels_ = 0;
  std::vector<float> data_;
};

/// 8-bit display-referred picture, RGBA, top row first: what a screen or a PNG shows.
struct DisplayImage {
  int width = 0;
  int height = 0;
  std::vector<uint8_t> rgba;  // width × height × 4
};

}  // namespace guidelight
