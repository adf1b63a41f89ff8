// Progressive photon mapping against closed forms and against the path tracer.

#include "renderer/integrators/progressive_photons/progressive_photons.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <thread>

#include "renderer/error.h"
#include "renderer/image/metrics.h"
#include "renderer/integrators/pixel_history.h"
#include "tests/renderer/test_scenes.h"
#include "tests/statistics/hypothesis_tests.h"

namespace guidelight {
namespace {

using testing::build;

using Settings = std::vector<std::pair<std::string, std::string>>;

std::unique_ptr<Integrator> make(const std::shared_ptr<const Scene>& scene, const std::string& name,
                                 const Settings& values = {}) {
  const IntegratorInfo& info = find_integrator(name);
  const auto settings = info.make_settings(scene->description().hints);
  for (const auto& [key, value] : values) set_parameter(*settings, key, value);
  return info.create(scene, *settings);
}

Film film_of(const Scene& scene) {
  return Film(scene.camera().width(), scene.camera().height(), scene.camera().film().filter);
}

void render(Integrator& integrator, Film& film, uint32_t first_pass, uint32_t passes,
            PassContext context = {}) {
  Parallel parallel(2);
  if (!context.parallel) context.parallel = &parallel;
  for (uint32_t pass = first_pass; pass < first_pass + passes; ++pass) {
    integrator.render_pass(pass, film, context);
    film.finish_pass();
  }
}

Film render(const std::shared_ptr<const Scene>& scene, const std::string& name,
            const Settings& values, uint32_t passes, uint64_t seed = 1) {
  Film film = film_of(*scene);
  render(*make(scene, name, values), film, 0, passes, {.seed = seed});
  return film;
}

const std::vector<std::string> kBoth = {"ppm", "sppm"};

class ProgressivePhotons : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(kinds, ProgressivePhotons, ::testing::ValuesIn(kBoth),
                         [](const auto& kind) { return kind.param; });

// -- Closed forms.

SceneDescription glowing_sphere() {
  SceneDescription scene = testing::empty_scene();
  auto& sphere = testing::add_sphere(scene, Vec3(0), 2, testing::add_diffuse(scene, Color(0.6f)));
  sphere.flip_normals = true;
  sphere.radiance = ColorInput{Color(1, 2, 3)};
  testing::look_at(scene, {0.5f, 0.2f, 0}, {1, 0, 1});
  return scene;
}

TEST_P(ProgressivePhotons, glowing_sphere_sums_the_geometric_series) {
  // Inside a sphere that emits Le and reflects ρ, paths of at most n segments show Le (1-ρⁿ)/(1-ρ).
  // The flux is even, so the radius matters only as far as the sphere is curved.
  const auto scene = build(glowing_sphere());
  for (const int length : {1, 2, 3, -1}) {
    const Film film = render(scene, GetParam(),
                             {{"max_length", fmt::format("{}", length)},
                              {"scene_radius", "5"},
                              {"light_paths", "20"},
                              {"alpha", "1"}},
                             64);
    const float sum = length < 0 ? 2.5f : (1 - std::pow(0.6f, length)) / 0.4f;
    const Color beauty = mean_color(film.develop(Layer::Beauty));
    // The standard error is 0.3 % (measured over seeds).
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(beauty[c] / (sum * (c + 1)), 1, 0.015) << length;
    const float direct = length == 1 ? 1.0f : 1.6f;
    EXPECT_NEAR(mean_color(film.develop(Layer::Direct)).r, direct, 0.015f * direct);
    EXPECT_NEAR(mean_color(film.develop(Layer::Merging)).r, beauty.r - 1, 1e-3);
  }
}

TEST_P(ProgressivePhotons, shortest_path_leaves_out_what_is_shorter) {
  const auto scene = build(glowing_sphere());
  const Film film = render(
      scene, GetParam(),
      {{"min_length", "3"}, {"max_length", "3"}, {"scene_radius", "5"}, {"light_paths", "20"}}, 64);
  EXPECT_NEAR(mean_color(film.develop(Layer::Beauty)).r, 0.36f, 0.015 * 0.36);
  EXPECT_EQ(mean_color(film.develop(Layer::Direct)), Color(0));
}

TEST_P(ProgressivePhotons, white_furnace_stays_white) {
  // Light at infinity as the origin of photons.
  SceneDescription description = testing::empty_scene();
  testing::add_sphere(description, Vec3(0), 1, testing::add_diffuse(description, Color(1)));
  testing::look_at(description, {0, 0, 3}, Vec3(0), 25);
  description.emitters.push_back({"environment", 0, ConstantEmitter{Color(1)}});
  const auto scene = build(description);
  const Film film =
      render(scene, GetParam(), {{"scene_radius", "3"}, {"light_paths", "80"}, {"alpha", "1"}}, 40);
  // The standard error is 0.8 %.
  EXPECT_NEAR(mean_color(film.develop(Layer::Beauty)).r, 1, 0.03);
}

// -- The path tracer; more scenes in agreement_test.cpp.

/// Luminance of blocks of pixels, over independent renders.
struct BlockMoments {
  static constexpr int kBlock = 8;
  std::vector<statistics::Moments> blocks;

  void add(const Image& image) {
    const int columns = image.width() / kBlock;
    const int rows = image.height() / kBlock;
    blocks.resize(static_cast<size_t>(columns) * rows);
    std::vector<double> sums(blocks.size());
    for (int y = 0; y < rows * kBlock; ++y) {
      for (int x = 0; x < columns * kBlock; ++x) {
        sums[static_cast<size_t>(y / kBlock) * columns + x / kBlock] +=
            luminance(image.color(x, y)) / (kBlock * kBlock);
      }
    }
    for (size_t i = 0; i < sums.size(); ++i) blocks[i].add(sums[i]);
  }
};

BlockMoments render_blocks(const std::shared_ptr<const Scene>& scene, const std::string& name,
                           const Settings& values, uint32_t passes, int runs) {
  BlockMoments moments;
  for (int run = 0; run < runs; ++run) {
    moments.add(render(scene, name, values, passes, 100 + run).develop(Layer::Beauty));
  }
  return moments;
}

/// False alarms: one in a thousand for each comparison of pictures.
void expect_same_means(const BlockMoments& a, const BlockMoments& b) {
  const double level = statistics::sidak_level(1e-3, a.blocks.size());
  for (size_t i = 0; i < a.blocks.size(); ++i) {
    EXPECT_GT(statistics::welch_test(a.blocks[i], b.blocks[i]), level)
        << "block " << i << ": " << a.blocks[i].mean() << " and " << b.blocks[i].mean();
  }
}

TEST_P(ProgressivePhotons, glossy_paint_keeps_its_reflection) {
  // A diffuse base under a smooth coat both is measured at and reflects.
  SceneDescription description = testing::room(32, 32);
  description.bsdfs.push_back({"paint", 0, PlasticBsdf{}});
  testing::add_sphere(description, {0, -0.5f, -0.4f}, 0.5f,
                      static_cast<int>(description.bsdfs.size()) - 1);
  description.hints.max_depth = 8;
  const auto scene = build(description);
  // A radius whose bias is below the noise.
  const Settings narrow = {{"scene_radius", "0.7"}, {"light_paths", "4"}};
  expect_same_means(render_blocks(scene, GetParam(), narrow, 20, 5),
                    render_blocks(scene, "path", {}, 100, 5));
}

/// Root of the mean squared difference of luminance.
double rms_difference(const Image& a, const Image& b) {
  double sum = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) sum += sqr(luminance(a.color(x, y) - b.color(x, y)));
  }
  return std::sqrt(sum / static_cast<double>(a.pixel_count()));
}

/// Direct light of a bulb close above a floor, with or without a shadow. The path tracer finds it
/// without noise.
SceneDescription bulb_over_floor(bool shadow) {
  SceneDescription scene = testing::empty_scene(24, 24);
  testing::add_rectangle(scene, glm::scale(Mat4(1), Vec3(4)),
                         testing::add_diffuse(scene, Color(0.7f)));
  if (shadow) {
    const Mat4 board = glm::translate(Mat4(1), Vec3(0.6f, 0, 0.3f));
    testing::add_rectangle(scene, glm::scale(board, Vec3(0.2f)), 0);
  }
  scene.emitters.push_back({"bulb", 0, PointEmitter{{0, 0, 0.6f}, Color(1)}});
  testing::look_at(scene, {0, -0.1f, 5}, Vec3(0), 25);
  scene.hints.max_depth = 2;
  return scene;
}

TEST_P(ProgressivePhotons, bias_shrinks_with_the_square_of_the_radius) {
  const auto scene = build(bulb_over_floor(false));
  const Image truth = render(scene, "path", {}, 64).develop(Layer::Beauty);
  const auto error_of = [&](const char* radius) {
    const Settings settings = {{"scene_radius", radius}, {"alpha", "1"}, {"light_paths", "50"}};
    return rms_difference(render(scene, GetParam(), settings, 30).develop(Layer::Beauty), truth);
  };
  // Not quite by 4: the smaller error has a third of noise, the larger one higher powers of R.
  const double ratio = error_of("8") / error_of("4");
  EXPECT_GT(ratio, 2.8);
  EXPECT_LT(ratio, 4.5);
}

TEST_P(ProgressivePhotons, error_falls_with_passes) {
  const auto scene = build(bulb_over_floor(false));
  const Image truth = render(scene, "path", {}, 64).develop(Layer::Beauty);
  Film film = film_of(*scene);
  const auto integrator = make(scene, GetParam(), {{"scene_radius", "4"}, {"light_paths", "2"}});
  render(*integrator, film, 0, 20);
  const double early = rms_difference(film.develop(Layer::Beauty), truth);
  render(*integrator, film, 20, 300);
  const double late = rms_difference(film.develop(Layer::Beauty), truth);
  EXPECT_LT(late, early / 1.8);  // n^(-1/3) is a factor of 2.5
}

// -- Specular, diffuse, specular.

/// A diffuse ball inside a ball of glass, under one light.
SceneDescription ball_in_larger_glass() {
  SceneDescription scene = testing::empty_scene();
  testing::add_sphere(scene, Vec3(0), 0.5f, testing::add_diffuse(scene, Color(0.8f)));
  scene.bsdfs.push_back({"glass", 0, DielectricBsdf{}});
  testing::add_sphere(scene, Vec3(0), 1, static_cast<int>(scene.bsdfs.size()) - 1);
  testing::look_at(scene, {0, 0, 4}, Vec3(0), 20);
  scene.hints.max_depth = 10;
  return scene;
}

TEST_P(ProgressivePhotons, point_light_is_seen_through_glass) {
  SceneDescription description = ball_in_larger_glass();
  description.emitters.push_back({"bulb", 0, PointEmitter{{2, 2, 4}, Color(10)}});
  const auto scene = build(description);
  EXPECT_EQ(mean_color(render(scene, "path", {}, 16).develop(Layer::Beauty)), Color(0));
  const Film film = render(scene, GetParam(), {{"light_paths", "100"}, {"scene_radius", "2"}}, 8);
  EXPECT_GT(mean_color(film.develop(Layer::Beauty)).g, 0.01f);
  EXPECT_GT(mean_color(film.develop(Layer::Caustic)).g, 0.01f);
}

TEST_P(ProgressivePhotons, small_lamp_through_glass_agrees_with_the_path_tracer) {
  SceneDescription description = ball_in_larger_glass();
  testing::add_sphere(description, {2, 2, 4}, 0.7f, testing::add_diffuse(description, Color(0)))
      .radiance = ColorInput{Color(10)};
  const auto scene = build(description);
  expect_same_means(
      render_blocks(scene, GetParam(), {{"light_paths", "100"}, {"scene_radius", "0.5"}}, 12, 6),
      render_blocks(scene, "path", {}, 1024, 6));
}

// -- What the film and the history say.

TEST_P(ProgressivePhotons, film_shows_emission_plus_the_density_estimates) {
  const auto scene = build(testing::room(24, 24));
  const Film film = render(scene, GetParam(), {{"scene_radius", "3"}}, 20);
  const Image merging = film.develop(Layer::Merging);
  double error = 0;
  double sum = 0;
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      Color estimate(0.0f);
      for (const DensityEstimate& e : film.density_estimates(x, y)) estimate += e.radiance();
      error += std::abs(luminance(estimate) - luminance(merging.color(x, y)));
      sum += luminance(merging.color(x, y));
    }
  }
  EXPECT_GT(sum, 1);
  EXPECT_LT(error, 1e-4 * sum);
}

/// Mean squared error that a film estimates.
double estimated_error(const Film& film) {
  const Image variance = film.develop(Layer::Variance);
  double sum = 0;
  for (const float v : variance.data()) sum += v;
  return sum / static_cast<double>(variance.pixel_count());
}

TEST_P(ProgressivePhotons, estimated_error_is_the_true_error) {
  // A picture that is mostly bias, smooth or with an edge, and one that is all noise. Neighbouring
  // pixels see the same photons, so that one render says little: several are averaged.
  constexpr int kRuns = 5;
  for (const bool shadow : {false, true}) {
    const auto scene = build(bulb_over_floor(shadow));
    const Image truth = render(scene, "path", {}, 256).develop(Layer::Beauty);
    for (const auto& [radius, light_paths] : {std::pair{"5", "20"}, std::pair{"1", "4"}}) {
      const Settings settings = {{"scene_radius", radius}, {"light_paths", light_paths}};
      double estimated = 0;
      double actual = 0;
      for (int run = 0; run < kRuns; ++run) {
        const Film film = render(scene, GetParam(), settings, 20, run);
        estimated += estimated_error(film);
        actual += sqr(rms_difference(film.develop(Layer::Beauty), truth));
      }
      const double ratio = std::sqrt(estimated / actual);
      EXPECT_GT(ratio, 0.7) << shadow << " " << radius;
      EXPECT_LT(ratio, 1.4) << shadow << " " << radius;
      RecordProperty(fmt::format("ratio_{}_{}", shadow, radius), fmt::format("{:.2f}", ratio));
    }
  }
}

TEST_P(ProgressivePhotons, history_follows_the_picked_pixels) {
  const auto scene = build(testing::room());
  PixelHistory history;
  const PixelHistory::Pixel picked{5, 6};
  history.watch({picked, {-1, 0}});
  Film film = film_of(*scene);
  render(*make(scene, GetParam(), {{"scene_radius", "10"}}), film, 0, 10, {.history = &history});
  const auto entries = history.of(picked);
  ASSERT_EQ(entries.size(), 10u);
  for (size_t i = 0; i < entries.size(); ++i) {
    EXPECT_EQ(entries[i].emitted, 256.0 * static_cast<double>(i + 1));
    if (i == 0) continue;
    EXPECT_GE(entries[i].count, entries[i - 1].count);
    EXPECT_LE(entries[i].radius, entries[i - 1].radius);
  }
  EXPECT_LT(entries.back().radius, entries.front().radius);
  EXPECT_GT(entries.back().count, 2);
  EXPECT_EQ(entries.back().estimate, film.develop(Layer::Beauty).color(5, 6));
  EXPECT_EQ(entries.back().error, std::sqrt(*film.develop(Layer::Variance).pixel(5, 6)));
  EXPECT_TRUE(history.of({1, 1}).empty());
  history.watch({});
  EXPECT_TRUE(history.of(picked).empty());
}

TEST(PixelHistory, is_thinned_out_and_may_be_asked_while_it_grows) {
  Film film(1, 1);
  film.prepare_density_estimates(1);
  PixelHistory history;
  history.watch({{0, 0}});
  std::jthread reader([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) EXPECT_LE(history.of({0, 0}).size(), 4096u);
  });
  for (int pass = 0; pass < 10000; ++pass) {
    film.density_estimates(0, 0)[0].emitted += 1;
    history.record(film);
  }
  const auto entries = history.of({0, 0});
  EXPECT_GT(entries.size(), 2000u);
  const double step = entries[1].emitted - entries[0].emitted;
  for (size_t i = 1; i < entries.size(); ++i) {
    EXPECT_EQ(entries[i].emitted - entries[i - 1].emitted, step);
  }
}

// -- Replay.

TEST_P(ProgressivePhotons, threads_do_not_matter) {
  const auto scene = build(testing::room());
  std::vector<Film> films;
  for (const int threads : {1, 2}) {
    Parallel parallel(threads);
    films.push_back(film_of(*scene));
    render(*make(scene, GetParam()), films.back(), 0, 5, {.seed = 1, .parallel = &parallel});
  }
  EXPECT_EQ(films[0].state(), films[1].state());
}

TEST_P(ProgressivePhotons, goes_on_from_a_saved_film) {
  const auto scene = build(testing::room());
  const Film whole = render(scene, GetParam(), {}, 6);
  const Film half = render(scene, GetParam(), {}, 3);
  Film resumed = film_of(*scene);
  resumed.restore(half.state());
  render(*make(scene, GetParam()), resumed, 3, 3, {.seed = 1});
  EXPECT_EQ(resumed.state(), whole.state());
}

TEST_P(ProgressivePhotons, a_region_shows_what_the_whole_picture_does) {
  const auto scene = build(testing::room(40, 40));
  const PixelRegion region{5, 10, 30, 33};
  const Settings settings = {{"scene_radius", "5"}};
  const Film whole = render(scene, GetParam(), settings, 4);
  Film part = film_of(*scene);
  render(*make(scene, GetParam(), settings), part, 0, 4, {.seed = 1, .region = region});
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      const bool inside = x >= region.x0 && x < region.x1 && y >= region.y0 && y < region.y1;
      const float expected = inside ? whole.develop_pixel(Layer::Beauty, x, y).r : 0.0f;
      EXPECT_NEAR(part.develop_pixel(Layer::Beauty, x, y).r, expected, 1e-5f + 1e-4f * expected);
    }
  }
}

TEST_P(ProgressivePhotons, a_pass_that_is_given_up_leaves_a_right_picture) {
  // Stopped again and again at different places: pixels then have different numbers of passes.
  const auto scene = build(glowing_sphere());
  const auto integrator = make(scene, GetParam(), {{"scene_radius", "5"}, {"light_paths", "100"}});
  Film film = film_of(*scene);
  int stopped = 0;
  for (uint32_t pass = 0; pass < 30; ++pass) {
    WorkControl control;
    Parallel parallel(2, &control);
    std::jthread stopper;
    if (pass % 3 != 0) {
      stopper = std::jthread([&, pass] {
        std::this_thread::sleep_for(std::chrono::microseconds(400 * pass));
        control.request_stop();
      });
    }
    try {
      integrator->render_pass(pass, film, {1, &parallel, {}});
    } catch (const Stopped&) {
      ++stopped;
    }
  }
  EXPECT_GT(stopped, 0);
  EXPECT_NEAR(mean_color(film.develop(Layer::Beauty)).r, 2.5f, 0.03 * 2.5);
}

// -- Scenes that have nothing to give.

TEST_P(ProgressivePhotons, darkness_is_black) {
  SceneDescription no_light = testing::room();
  no_light.shapes.back().radiance.reset();
  SceneDescription no_power = testing::room();
  no_power.shapes.back().radiance = ColorInput{Color(0)};
  SceneDescription empty = testing::empty_scene();
  for (const SceneDescription& description : {no_light, no_power, empty}) {
    const Film film = render(build(description), GetParam(), {}, 3);
    EXPECT_EQ(mean_color(film.develop(Layer::Beauty)), Color(0));
    EXPECT_EQ(film.estimated_relative_error(), 0);
    EXPECT_EQ(film.rejected(), 0u);
  }
}

SceneDescription room_with_lamp_in_view() {
  SceneDescription scene = testing::room();
  testing::look_at(scene, {0, 0, 0.95f}, {0, 0.9f, -0.2f}, 70);
  return scene;
}

TEST_P(ProgressivePhotons, black_surfaces_show_the_lamp_alone) {
  SceneDescription description = room_with_lamp_in_view();
  for (BsdfDescription& bsdf : description.bsdfs) bsdf.model = DiffuseBsdf{{Color(0)}};
  const auto scene = build(description);
  const Color lamp = mean_color(render(scene, "path", {}, 64).develop(Layer::Beauty));
  const Film film = render(scene, GetParam(), {}, 64);
  EXPECT_EQ(mean_color(film.develop(Layer::Merging)), Color(0));
  EXPECT_GT(lamp.r, 0.1f);
  EXPECT_NEAR(mean_color(film.develop(Layer::Beauty)).r, lamp.r, 0.1f * lamp.r);
}

TEST_P(ProgressivePhotons, path_length_1_shows_the_lamp_alone) {
  const auto scene = build(room_with_lamp_in_view());
  const Film film = render(scene, GetParam(), {{"max_length", "1"}}, 64);
  EXPECT_EQ(mean_color(film.develop(Layer::Merging)), Color(0));
  EXPECT_GT(mean_color(film.develop(Layer::Direct)).r, 0);
}

TEST_P(ProgressivePhotons, rejects_a_radius_of_0) {
  const auto scene = build(testing::room());
  EXPECT_THROW(make(scene, GetParam(), {{"scene_radius", "0"}}), Error);
  EXPECT_THROW(make(scene, GetParam(), {{"radius_from", "pixel"}, {"pixel_radius", "0"}}), Error);
  EXPECT_NO_THROW(make(scene, GetParam(), {{"radius_from", "pixel"}, {"scene_radius", "0"}}));
}

}  // namespace
}  // namespace guidelight
