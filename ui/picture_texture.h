#pragma once

#include <imgui.h>

#include "renderer/image/image.h"

namespace guidelight {

/// Every n-th pixel, so that no side is longer than `longest`; the middle of each square of n × n.
DisplayImage reduced(const DisplayImage& image, int longest);

/// A display picture in an OpenGL texture; reduced if it is larger than those can be. Needs the
/// window's context while it lives.
class PictureTexture {
 public:
  PictureTexture() = default;
  ~PictureTexture();
  PictureTexture(const PictureTexture&) = delete;
  PictureTexture& operator=(const PictureTexture&) = delete;

  void upload(const DisplayImage& image);
  /// Blends between pixels, or shows each as a square.
  void set_smooth(bool smooth);
  bool empty() const { return width_ == 0; }
  ImTextureID id() const;

 private:
  unsigned name_ = 0;
  int width_ = 0;
  int height_ = 0;
  bool smooth_ = true;
};

}  // namespace guidelight
