#pragma once

#include <span>
#include <string>
#include <vector>

#include "renderer/image/technique_images.h"

namespace guidelight {

/// Where the pictures of techniques lie: a row for each length of paths, and one below it for those
/// that merge; a column for each number of light vertices.
class PyramidLayout {
 public:
  struct Row {
    int length;  // segments
    bool is_merging;
    bool operator==(const Row&) const = default;
  };

  /// Into a room of the screen, for pictures of this shape (width over height).
  PyramidLayout(std::span<const TechniqueImages::Technique> techniques, Vec2 corner, Vec2 room,
                float aspect, float gap);

  const std::vector<Row>& rows() const { return rows_; }
  int columns() const { return columns_; }
  Vec2 size() const { return size_; }  // of a picture [pixels]
  /// Upper left corners [pixels].
  Vec2 corner(size_t row, int column) const;
  Vec2 corner(const TechniqueImages::Technique& technique) const;

 private:
  std::vector<Row> rows_;  // from above
  int columns_ = 1;
  Vec2 corner_;
  Vec2 size_{1};
  float gap_;
};

/// "Connection of 2 light vertices with 3 camera vertices (s 2, t 3)".
std::string describe(const TechniqueImages::Technique& technique);

}  // namespace guidelight
