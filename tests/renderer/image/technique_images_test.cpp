#include "renderer/image/technique_images.h"

#include <gtest/gtest.h>

namespace guidelight {
namespace {

constexpr TechniqueImages::Technique kConnection{.s = 2, .t = 3};
constexpr TechniqueImages::Technique kMerging{.s = 2, .t = 3, .is_merging = true};

TEST(TechniqueImages, are_means_over_passes_and_keep_connection_and_merging_apart) {
  TechniqueImages images(4, 2);
  images.add(kConnection, 1, 1, Color(1, 2, 3), Color(4, 5, 6));
  images.finish_pass();
  images.add(kMerging, 1, 1, Color(8), Color(16));
  images.finish_pass();
  const auto developed = images.develop();
  ASSERT_EQ(developed.size(), 2u);
  EXPECT_EQ(developed.at(kConnection).weighted.color(1, 1), Color(0.5f, 1, 1.5f));
  EXPECT_EQ(developed.at(kConnection).raw.color(1, 1), Color(2, 2.5f, 3));
  EXPECT_EQ(developed.at(kMerging).weighted.color(1, 1), Color(4));
  EXPECT_EQ(developed.at(kMerging).weighted.color(0, 0), Color(0));
}

TEST(TechniqueImages, of_blocks_are_means_over_the_pixels_that_each_holds) {
  // 5 × 3 pixels in blocks of 2 × 2: the last column and row hold fewer.
  TechniqueImages images(5, 3, 4, 2);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) images.add(kConnection, x, y, Color(3), Color(7));
  }
  images.finish_pass();
  const TechniqueImages::Pair kept = images.develop(kConnection);
  ASSERT_EQ(kept.weighted.width(), 3);
  ASSERT_EQ(kept.weighted.height(), 2);
  for (const float value : kept.weighted.data()) EXPECT_FLOAT_EQ(value, 3);
  const TechniqueImages::Pair smaller = images.develop(2).at(kConnection);
  ASSERT_EQ(smaller.raw.width(), 2);
  ASSERT_EQ(smaller.raw.height(), 1);
  for (const float value : smaller.raw.data()) EXPECT_FLOAT_EQ(value, 7);
}

TEST(TechniqueImages, leave_out_what_is_too_long_or_outside) {
  TechniqueImages images(2, 2, 4);
  images.add({.s = 3, .t = 3}, 0, 0, Color(1), Color(1));  // five segments
  images.add({.s = 3, .t = 3, .is_merging = true}, 2, 0, Color(1), Color(1));
  EXPECT_EQ(images.bytes(), 0u);
  images.add({.s = 3, .t = 3, .is_merging = true}, 1, 0, Color(1), Color(1));
  images.add({.s = 0, .t = 5}, 1, 0, Color(1), Color(1));
  images.add({.s = 4, .t = 1}, 1, 0, Color(1), Color(1));
  images.finish_pass();
  EXPECT_EQ(images.bytes(), 3u * 4u * 6u * sizeof(float));
  EXPECT_EQ(images.develop().size(), 3u);
  EXPECT_EQ(images.develop(kConnection).raw.color(0, 0), Color(0));
}

}  // namespace
}  // namespace guidelight
