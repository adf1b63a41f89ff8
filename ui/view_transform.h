#pragma once

#include "renderer/math/vector.h"

namespace guidelight {

/// How the picture lies in the window: screen = origin + scale·pixel.
class ViewTransform {
 public:
  static constexpr float kMinScale = 1.0f / 16;
  static constexpr float kMaxScale = 64;

  /// The room for the picture on the screen and the picture's size [pixels]. While nobody has
  /// zoomed, the picture fills the room; otherwise it stays centred where it was.
  void set_room(Vec2 corner, Vec2 size, Vec2 picture_size);

  void fit();
  /// Whole screen pixels per picture pixel, centred.
  void zoom_to(float scale);
  /// Zooms around a point of the screen, which stays over the same picture pixel.
  void zoom_about(Vec2 screen, float factor);
  void move(Vec2 screen_offset);

  Vec2 to_screen(Vec2 pixel) const { return origin() + scale_ * pixel; }
  Vec2 to_pixel(Vec2 screen) const { return (screen - origin()) / scale_; }
  float scale() const { return scale_; }
  bool fitted() const { return fitted_; }

 private:
  Vec2 origin() const;

  Vec2 corner_{0};
  Vec2 room_{1};
  Vec2 picture_{1};
  Vec2 center_{0.5f};  // the picture's pixel in the middle of the room
  float scale_ = 1;
  bool fitted_ = true;
};

}  // namespace guidelight
