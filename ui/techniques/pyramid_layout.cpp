#include "ui/techniques/pyramid_layout.h"

#include <fmt/format.h>

#include <algorithm>

namespace guidelight {
namespace {

std::string vertices(int count, const char* side) {
  return fmt::format("{} {} {}", count, side, count == 1 ? "vertex" : "vertices");
}

}  // namespace

PyramidLayout::PyramidLayout(std::span<const TechniqueImages::Technique> techniques, Vec2 corner,
                             Vec2 room, float aspect, float gap)
    : corner_(corner), gap_(gap) {
  for (const TechniqueImages::Technique& technique : techniques) {
    const Row row{technique.path_length(), technique.is_merging};
    if (std::ranges::find(rows_, row) == rows_.end()) rows_.push_back(row);
    columns_ = std::max(columns_, technique.s + 1);
  }
  std::ranges::sort(rows_, {},
                    [](const Row& row) { return std::pair(row.length, row.is_merging); });
  const Vec2 cells(columns_, std::max<size_t>(rows_.size(), 1));
  const Vec2 largest = glm::max((room - gap * (cells - 1.0f)) / cells, Vec2(1));
  const float height = std::min(largest.y, largest.x / aspect);
  size_ = glm::floor(Vec2(height * aspect, height));
}

Vec2 PyramidLayout::corner(size_t row, int column) const {
  return corner_ + (size_ + gap_) * Vec2(column, row);
}

Vec2 PyramidLayout::corner(const TechniqueImages::Technique& technique) const {
  const auto row = std::ranges::find(rows_, Row{technique.path_length(), technique.is_merging});
  return corner(static_cast<size_t>(row - rows_.begin()), technique.s);
}

std::string describe(const TechniqueImages::Technique& technique) {
  const auto [s, t, is_merging] = technique;
  const std::string numbers = fmt::format(" (s {}, t {})", s, t);
  if (is_merging) {
    return "Merging of " + vertices(s, "light") + " with " + vertices(t, "camera") + numbers;
  }
  if (s == 0) return "Camera paths that hit a light" + numbers;
  if (t == 1) return "Light paths that the camera sees" + numbers;
  return "Connection of " + vertices(s, "light") + " with " + vertices(t, "camera") + numbers;
}

}  // namespace guidelight
