#pragma once

#include <vector>

#include "renderer/math/vector.h"

namespace guidelight {

/// Finds places for labels beside the points that they name, so that none covers another.
class LabelPlacer {
 public:
  /// Labels stand within [0, room).
  explicit LabelPlacer(Vec2 room) : room_(room) {}

  /// Upper left corner of a label of this size: to the right of its point, else to the left, at a
  /// distance, or in the rows above and below; the first place that is free. If none is, the label
  /// covers others.
  Vec2 place(Vec2 point, Vec2 size, float distance);

 private:
  struct Box {
    Vec2 low;
    Vec2 high;
    bool overlaps(const Box& other) const;
  };
  Vec2 into_room(Vec2 corner, Vec2 size) const;

  Vec2 room_;
  std::vector<Box> taken_;
};

}  // namespace guidelight
