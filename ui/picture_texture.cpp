#include "ui/picture_texture.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace guidelight {

DisplayImage reduced(const DisplayImage& image, int longest) {
  const int n = std::max(1, (std::max(image.width, image.height) + longest - 1) / longest);
  DisplayImage out{(image.width + n - 1) / n, (image.height + n - 1) / n, {}};
  out.rgba.reserve(size_t{4} * out.width * out.height);
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      const size_t column = std::min(x * n + n / 2, image.width - 1);
      const size_t row = std::min(y * n + n / 2, image.height - 1);
      const auto pixel =
          image.rgba.begin() + static_cast<std::ptrdiff_t>(4 * (row * image.width + column));
      out.rgba.insert(out.rgba.end(), pixel, pixel + 4);
    }
  }
  return out;
}

PictureTexture::~PictureTexture() {
  if (name_) glDeleteTextures(1, &name_);
}

void PictureTexture::upload(const DisplayImage& image) {
  GLint longest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &longest);
  if (longest > 0 && std::max(image.width, image.height) > longest) {
    upload(reduced(image, longest));
    return;
  }
  const bool first = name_ == 0;
  if (first) glGenTextures(1, &name_);
  glBindTexture(GL_TEXTURE_2D, name_);
  if (first) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  }
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (image.width == width_ && image.height == height_) {
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE,
                    image.rgba.data());
  } else {
    width_ = image.width;
    height_ = image.height;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.rgba.data());
  }
}

void PictureTexture::set_smooth(bool smooth) {
  if (smooth == smooth_ || name_ == 0) return;
  smooth_ = smooth;
  glBindTexture(GL_TEXTURE_2D, name_);
  const int filter = smooth ? GL_LINEAR : GL_NEAREST;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
}

ImTextureID PictureTexture::id() const {
  return reinterpret_cast<ImTextureID>(static_cast<uintptr_t>(name_));
}

}  // namespace guidelight
