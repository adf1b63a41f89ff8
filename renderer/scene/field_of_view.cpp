#include "renderer/scene/field_of_view.h"

namespace guidelight {

Vec2 half_extent(float fov, FovAxis axis, float aspect) {
  const float half = std::tan(0.5f * fov * kPi / 180);
  const bool wide = aspect > 1;
  switch (axis) {
    case FovAxis::X:
      return {half, half / aspect};
    case FovAxis::Y:
      return {half * aspect, half};
    case FovAxis::Smaller:
      return wide ? Vec2(half * aspect, half) : Vec2(half, half / aspect);
    case FovAxis::Larger:
      return wide ? Vec2(half, half / aspect) : Vec2(half * aspect, half);
    case FovAxis::Diagonal:
      break;
  }
  const float half_height = half / std::sqrt(1 + sqr(aspect));
  return {half_height * aspect, half_height};
}

}  // namespace guidelight
