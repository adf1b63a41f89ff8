#include "ui/picture_texture.h"

#include <epoxy/gl.h>

namespace guidelight {

PictureTexture::~PictureTexture() {
  if (name_) glDeleteTextures(1, &name_);
}

void PictureTexture::upload(const DisplayImage& image) {
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
