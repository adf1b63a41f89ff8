#include "renderer/image/zeroed_array.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace guidelight {
namespace {

struct Sums {
  double a = 0;
  int b = 0;
};

TEST(ZeroedArray, begins_with_zeros_and_copies_its_values) {
  ZeroedArray<Sums> array(1000);
  EXPECT_TRUE(std::ranges::all_of(array, [](Sums s) { return s.a == 0 && s.b == 0; }));
  array[7].a = 2.5;
  ZeroedArray<Sums> copy = array;
  array[7].a = 0;
  EXPECT_EQ(copy[7].a, 2.5);
  EXPECT_EQ(copy.size(), 1000u);

  array = std::move(copy);
  EXPECT_EQ(array[7].a, 2.5);
  array = ZeroedArray<Sums>();
  EXPECT_TRUE(array.empty());
  EXPECT_EQ(array.begin(), array.end());
}

}  // namespace
}  // namespace guidelight
