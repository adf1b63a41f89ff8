#include "ui/view_transform.h"

#include <algorithm>

namespace guidelight {

void ViewTransform::set_room(Vec2 corner, Vec2 size, Vec2 picture_size) {
  // A picture of another size keeps its zoom relative to the whole.
  if (picture_size != picture_) center_ *= picture_size / picture_;
  corner_ = corner;
  room_ = glm::max(size, Vec2(1));
  picture_ = glm::max(picture_size, Vec2(1));
  if (fitted_) fit();
}

void ViewTransform::fit() {
  fitted_ = true;
  center_ = 0.5f * picture_;
  scale_ = std::clamp(std::min(room_.x / picture_.x, room_.y / picture_.y), kMinScale, kMaxScale);
}

void ViewTransform::zoom_to(float scale) {
  fitted_ = false;
  center_ = 0.5f * picture_;
  scale_ = std::clamp(scale, kMinScale, kMaxScale);
}

void ViewTransform::zoom_about(Vec2 screen, float factor) {
  const Vec2 pixel = to_pixel(screen);
  fitted_ = false;
  scale_ = std::clamp(scale_ * factor, kMinScale, kMaxScale);
  move(screen - to_screen(pixel));
}

void ViewTransform::move(Vec2 screen_offset) {
  fitted_ = false;
  center_ = glm::clamp(center_ - screen_offset / scale_, Vec2(0), picture_);
}

/// On whole screen pixels, so that at scale 1 a picture pixel is exactly one screen pixel.
Vec2 ViewTransform::origin() const { return glm::round(corner_ + 0.5f * room_ - scale_ * center_); }

}  // namespace guidelight
