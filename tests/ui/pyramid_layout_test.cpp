#include "ui/techniques/pyramid_layout.h"

#include <gtest/gtest.h>

namespace guidelight {
namespace {

using Technique = TechniqueImages::Technique;

TEST(PyramidLayout, has_a_row_per_length_with_merging_below_connection) {
  const std::vector<Technique> techniques = {
      {.s = 0, .t = 2}, {.s = 1, .t = 2}, {.s = 2, .t = 2, .is_merging = true}, {.s = 3, .t = 1}};
  const PyramidLayout layout(techniques, Vec2(10, 20), Vec2(430, 330), 1, 10);
  const std::vector<PyramidLayout::Row> expected = {{1, false}, {2, false}, {2, true}, {3, false}};
  EXPECT_EQ(layout.rows(), expected);
  EXPECT_EQ(layout.columns(), 4);
  EXPECT_EQ(layout.size(), Vec2(75, 75));  // four rows and three gaps in 330 pixels
  EXPECT_EQ(layout.corner(techniques[0]), Vec2(10, 20));
  EXPECT_EQ(layout.corner(techniques[1]), Vec2(10 + 85, 20 + 85));
  EXPECT_EQ(layout.corner(techniques[2]), Vec2(10 + 2 * 85, 20 + 2 * 85));
  EXPECT_EQ(layout.corner(techniques[3]), Vec2(10 + 3 * 85, 20 + 3 * 85));
}

TEST(PyramidLayout, fits_wide_pictures_by_their_width) {
  const std::vector<Technique> techniques = {{.s = 0, .t = 2}, {.s = 1, .t = 1}};
  const PyramidLayout layout(techniques, Vec2(0), Vec2(410, 1000), 2, 10);
  EXPECT_EQ(layout.size(), Vec2(200, 100));
}

TEST(Techniques, are_named_in_words_and_by_their_numbers) {
  EXPECT_EQ(describe({.s = 1, .t = 3}),
            "Connection of 1 light vertex with 3 camera vertices (s 1, t 3)");
  EXPECT_EQ(describe({.s = 2, .t = 2, .is_merging = true}),
            "Merging of 2 light vertices with 2 camera vertices (s 2, t 2)");
  EXPECT_EQ(describe({.s = 0, .t = 2}), "Camera paths that hit a light (s 0, t 2)");
  EXPECT_EQ(describe({.s = 3, .t = 1}), "Light paths that the camera sees (s 3, t 1)");
}

}  // namespace
}  // namespace guidelight
