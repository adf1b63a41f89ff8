// Photon mapping where it could stumble; agreement_test.cpp compares its pictures with those of the
// path tracer.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/error.h"
#include "renderer/image/metrics.h"
#include "renderer/integrators/photon_mapping/settings.h"
#include "tests/renderer/test_scenes.h"

namespace guidelight {
namespace {

using ::testing::HasSubstr;

/// Few photons and rays, quick to render.
PhotonMappingSettings quick_settings() {
  PhotonMappingSettings settings;
  settings.light_paths = 2000;
  settings.gather_rays = 30;
  settings.max_length = 6;
  return settings;
}

Film render(std::shared_ptr<const Scene> scene, const PhotonMappingSettings& settings,
            uint32_t passes = 1, int threads = 2) {
  const Camera& camera = scene->camera();
  Film film(camera.width(), camera.height(), camera.film().filter);
  const auto integrator = find_integrator("photon_map").create(scene, settings);
  Parallel parallel(threads);
  for (uint32_t pass = 0; pass < passes; ++pass) {
    integrator->render_pass(pass, film, {1, &parallel, {}});
  }
  EXPECT_EQ(film.rejected(), 0u);
  return film;
}

Color mean_beauty(const SceneDescription& scene, const PhotonMappingSettings& settings,
                  uint32_t passes = 1) {
  return mean_color(render(testing::build(scene), settings, passes).develop(Layer::Beauty));
}

TEST(PhotonMapping, without_a_light_everything_is_black) {
  SceneDescription scene = testing::room();
  scene.shapes.pop_back();
  EXPECT_EQ(mean_beauty(scene, quick_settings()), Color(0));
}

TEST(PhotonMapping, a_light_without_power_changes_nothing) {
  SceneDescription scene = testing::room();
  scene.shapes.back().radiance = ColorInput{Color(0)};
  EXPECT_EQ(mean_beauty(scene, quick_settings()), Color(0));
}

TEST(PhotonMapping, shortest_paths_show_emitters_alone) {
  SceneDescription scene = testing::room();
  testing::look_at(scene, {0, 0, 0}, {0, 1, 0}, 20);  // into the lamp
  PhotonMappingSettings settings = quick_settings();
  settings.max_length = 1;
  const Color mean = mean_beauty(scene, settings);
  EXPECT_NEAR(mean.r, 10, 1e-4f);
  EXPECT_NEAR(mean.b, 8, 1e-4f);
  settings.max_length = 0;
  EXPECT_EQ(mean_beauty(scene, settings), Color(0));
  settings.min_length = 2;
  settings.max_length = 1;
  EXPECT_EQ(mean_beauty(scene, settings), Color(0));
}

TEST(PhotonMapping, black_walls_reflect_nothing) {
  SceneDescription scene = testing::room();
  for (BsdfDescription& bsdf : scene.bsdfs) bsdf.model = DiffuseBsdf{{Color(0)}};
  PhotonMappingSettings settings = quick_settings();
  settings.min_length = 2;
  EXPECT_EQ(mean_beauty(scene, settings), Color(0));
}

TEST(PhotonMapping, a_map_smaller_than_k_is_read_as_a_whole) {
  // 20 light paths leave fewer than 100 photons; with k = 1000 every estimate uses all of them
  // within the largest distance, and the mean of many passes is still of the right magnitude.
  const SceneDescription scene = testing::room();
  PhotonMappingSettings settings = quick_settings();
  const Color expected = mean_beauty(scene, settings, 8);
  settings.light_paths = 20;
  settings.neighbors = 1000;
  settings.global_distance = 30;
  const Color found = mean_beauty(scene, settings, 64);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 0.2f * expected[c]);
}

TEST(PhotonMapping, searching_nowhere_is_refused) {
  const auto scene = testing::build(testing::room());
  for (float PhotonMappingSettings::*distance :
       {&PhotonMappingSettings::global_distance, &PhotonMappingSettings::caustic_distance}) {
    PhotonMappingSettings settings;
    settings.*distance = 0;
    try {
      find_integrator("photon_map").create(scene, settings);
      FAIL() << "accepted";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("search distance of 0"));
    }
  }
}

TEST(PhotonMapping, pictures_do_not_depend_on_threads) {
  const auto scene = testing::build(testing::room(40, 40));
  for (const bool is_cached : {true, false}) {
    PhotonMappingSettings settings = quick_settings();
    settings.irradiance_cache = is_cached;
    settings.gather_rays = 10;
    const Image one = render(scene, settings, 1, 1).develop(Layer::Beauty);
    const Image two = render(scene, settings, 1, 2).develop(Layer::Beauty);
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 40; ++x) ASSERT_EQ(one.color(x, y), two.color(x, y)) << x << ", " << y;
    }
  }
}

/// Mean difference of the blocks of two pictures of 32×32, relative to the mean.
double block_difference(const Image& picture, const Image& reference) {
  constexpr int kBlock = 8;
  double difference = 0;
  double total = 0;
  for (int y0 = 0; y0 < picture.height(); y0 += kBlock) {
    for (int x0 = 0; x0 < picture.width(); x0 += kBlock) {
      double sum = 0;
      for (int i = 0; i < kBlock * kBlock; ++i) {
        const int x = x0 + i % kBlock;
        const int y = y0 + i / kBlock;
        sum += luminance(picture.color(x, y)) - luminance(reference.color(x, y));
        total += luminance(reference.color(x, y));
      }
      difference += std::abs(sum);
    }
  }
  return difference / total;
}

TEST(PhotonMapping, bias_shrinks_with_the_radius) {
  // Indirect light of estimates over large and small discs, against the path tracer. The noise of a
  // difference is about 1 % (measured over seeds).
  SceneDescription description = testing::room(32, 32);
  description.hints.max_depth = 6;
  const auto scene = testing::build(description);
  const Image reference = testing::render(scene, 256).develop(Layer::Indirect);
  const auto bias = [&](int neighbors) {
    PhotonMappingSettings settings = quick_settings();
    settings.light_paths = 4000;
    settings.global_distance = 100;
    settings.neighbors = neighbors;
    return block_difference(render(scene, settings, 12).develop(Layer::Indirect), reference);
  };
  const double large = bias(1000);
  const double small = bias(20);
  EXPECT_LT(small, 0.5 * large) << small << " against " << large;
}

TEST(PhotonMapping, shrinking_takes_fewer_photons_from_pass_to_pass) {
  const auto scene = testing::build(testing::room());
  PhotonMappingSettings settings;
  settings.alpha = 0.5f;
  const PhotonMappingPass first(*scene, settings, 0, 0);
  const PhotonMappingPass fourth(*scene, settings, 3, 0);
  EXPECT_EQ(first.global.neighbors, 60);
  EXPECT_EQ(fourth.global.neighbors, 30);
  EXPECT_NEAR(fourth.global.max_distance, first.global.max_distance / std::sqrt(2.0f), 1e-6f);
  const PhotonMappingPass last(*scene, settings, 1000000, 0);
  EXPECT_EQ(last.global.neighbors, 3);
  settings.neighbors = 2;
  EXPECT_EQ(PhotonMappingPass(*scene, settings, 9, 0).global.neighbors, 2);
}

}  // namespace
}  // namespace guidelight
