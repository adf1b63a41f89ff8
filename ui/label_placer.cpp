#include "ui/label_placer.h"

#include <algorithm>

namespace guidelight {

bool LabelPlacer::Box::overlaps(const Box& other) const {
  return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y &&
         other.low.y < high.y;
}

Vec2 LabelPlacer::into_room(Vec2 corner, Vec2 size) const {
  return glm::max(glm::min(corner, room_ - size), Vec2(0));
}

Vec2 LabelPlacer::place(Vec2 point, Vec2 size, float distance) {
  constexpr float kBetweenRows = 2;  // [pixels]
  const auto beside = [&](int row, bool right) {
    const float x = right ? distance : -distance - size.x;
    const float y = static_cast<float>(row) * (size.y + kBetweenRows) - 0.5f * size.y;
    return into_room(point + Vec2(x, y), size);
  };
  for (const int row : {0, -1, 1, -2, 2, -3, 3}) {
    for (const bool right : {true, false}) {
      const Vec2 candidate = beside(row, right);
      const Box box{candidate, candidate + size};
      if (std::ranges::any_of(taken_, [&](const Box& b) { return b.overlaps(box); })) continue;
      taken_.push_back(box);
      return candidate;
    }
  }
  return beside(0, true);
}

}  // namespace guidelight
