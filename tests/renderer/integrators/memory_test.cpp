// Progressive methods go on for ever: their memory must not grow with the passes.

#include <gtest/gtest.h>

#include "renderer/parallel/process_memory.h"
#include "tests/renderer/test_scenes.h"

namespace guidelight {
namespace {

class Memory : public ::testing::TestWithParam<const char*> {};

TEST_P(Memory, does_not_grow_with_passes) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer keeps what has been freed";
#endif
  const auto scene = testing::build(testing::room());
  const IntegratorInfo& info = find_integrator(GetParam());
  const auto integrator = info.create(scene, *info.make_settings(scene->description().hints));
  Parallel parallel(2);
  Film film(16, 16);
  const auto render = [&](uint32_t begin, uint32_t end) {
    for (uint32_t pass = begin; pass < end; ++pass) {
      integrator->render_pass(pass, film, {1, &parallel});
      film.finish_pass();
    }
  };
  render(0, 10);
  const auto after_10 = static_cast<double>(resident_bytes());
  render(10, 1000);
  EXPECT_LT(resident_bytes(), 1.02 * after_10);
}

INSTANTIATE_TEST_SUITE_P(integrators, Memory, ::testing::Values("ppm", "sppm", "vcm"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace guidelight
