#include <gtest/gtest.h>

#include <thread>

#include "renderer/error.h"
#include "renderer/image/metrics.h"
#include "renderer/image/technique_images.h"
#include "renderer/photons/photon_cloud.h"
#include "renderer/session/stopwatch.h"
#include "tests/renderer/test_scenes.h"
#include "tests/statistics/hypothesis_tests.h"

namespace guidelight {
namespace {

using statistics::Moments;

using Values = std::vector<std::pair<std::string, std::string>>;

std::unique_ptr<IntegratorSettings> settings_for(const std::string& name,
                                                 const Values& values = {}) {
  auto settings = find_integrator(name).make_settings({});
  for (const auto& [key, value] : values) set_parameter(*settings, key, value);
  return settings;
}

Film render_with(std::shared_ptr<const Scene> scene, const std::string& name, const Values& values,
                 uint32_t passes, uint64_t seed = 1, int threads = 2,
                 TechniqueImages* techniques = nullptr) {
  const Camera& camera = scene->camera();
  Film film(camera.width(), camera.height(), camera.film().filter);
  const auto integrator = find_integrator(name).create(scene, *settings_for(name, values));
  Parallel parallel(threads);
  for (uint32_t pass = 0; pass < passes; ++pass) {
    integrator->render_pass(pass, film,
                            {.seed = seed, .parallel = &parallel, .techniques = techniques});
    film.finish_pass();
  }
  return film;
}

/// Counts of paths that are enough for a small picture, where their defaults are for a large one.
Values few_paths(const std::string& integrator) {
  if (integrator == "photon_map") return {{"light_paths", "5000"}, {"gather_rays", "25"}};
  if (integrator == "mlt" || integrator == "pssmlt") return {{"seed_paths", "4000"}};
  if (integrator != "mps") return {};
  return {{"seed_paths", "4000"},
          {"mutations", "5000"},
          {"light_paths", "5000"},
          {"importance_paths", "5000"},
          {"gather_rays", "25"}};
}

double mean(const Film& film, Layer layer = Layer::Beauty) {
  return luminance(mean_color(film.develop(layer)));
}

// -- Light that only merging finds.

/// A diffuse ball inside a glass ball: every path between it and camera or light is specular.
SceneDescription ball_in_glass() {
  SceneDescription scene = testing::empty_scene(24, 24);
  testing::add_sphere(scene, {0, 0, 0}, 0.5f, testing::add_diffuse(scene, Color(0.8f)));
  scene.bsdfs.push_back({.name = "glass", .line = 0, .model = DielectricBsdf{}});
  testing::add_sphere(scene, {0, 0, 0}, 1, static_cast<int>(scene.bsdfs.size()) - 1);
  testing::look_at(scene, {0, 0, 4}, {0, 0, 0}, 20);
  return scene;
}

constexpr Vec3 kLamp{1, 3, 3};

TEST(LightThroughGlass, of_a_point_is_found_by_merging_alone) {
  SceneDescription description = ball_in_glass();
  description.emitters.push_back({.name = "", .line = 0, .model = PointEmitter{kLamp, Color(20)}});
  const auto scene = testing::build(std::move(description));
  for (const char* name : {"path", "bdpt", "light"}) {
    EXPECT_EQ(mean(render_with(scene, name, {}, 4)), 0) << name;
  }
  // One photon in 75 meets the ball.
  const double expected =
      mean(render_with(scene, "vcm", {{"scene_radius", "4"}, {"light_paths", "100"}}, 48));
  EXPECT_GT(expected, 0.05);
  for (const char* name : {"pppm", "bpm", "ppm", "sppm", "bdpm"}) {
    const bool is_nearest = std::string(name) == "bdpm";
    const auto radius = is_nearest ? std::pair("neighbors", "20") : std::pair("scene_radius", "4");
    EXPECT_NEAR(mean(render_with(scene, name, {radius, {"light_paths", "100"}}, 48)), expected,
                0.03 * expected)
        << name;
  }
}

TEST(LightThroughGlass, of_a_small_lamp_agrees_with_the_path_tracer) {
  SceneDescription description = ball_in_glass();
  testing::add_sphere(description, kLamp, 0.3f).radiance = ColorInput{Color(60)};
  const auto scene = testing::build(std::move(description));
  Moments expected;
  for (uint64_t seed = 0; seed < 12; ++seed) {
    expected.add(mean(render_with(scene, "path", {}, 400, seed)));
  }
  // Chance of a false alarm: 1e-3 for all five. What remains of the radius makes up to 1 %.
  const double level = statistics::sidak_level(1e-3, 5);
  for (const char* name : {"vcm", "pppm", "bpm", "sppm", "ppm"}) {
    Moments found;
    for (uint64_t seed = 0; seed < 12; ++seed) {
      found.add(mean(render_with(scene, name, {{"scene_radius", "0.7"}}, 24, seed)));
    }
    EXPECT_GT(statistics::welch_test(found, expected, 0.01 * expected.mean()), level)
        << name << ": " << found.mean() << " against " << expected.mean() << " +- "
        << expected.standard_error();
  }
}

TEST(Merging, has_a_bias_that_shrinks_with_the_radius) {
  const auto scene = testing::build(testing::room(32, 32));
  constexpr int kBlock = 4;
  const auto blocks = [&](const Film& film) {
    const Image picture = film.develop(Layer::Beauty);
    std::vector<double> means(sqr(32 / kBlock));
    for (int y = 0; y < 32; ++y) {
      for (int x = 0; x < 32; ++x) {
        means[y / kBlock * (32 / kBlock) + x / kBlock] +=
            luminance(picture.color(x, y)) / sqr(kBlock);
      }
    }
    return means;
  };
  const auto expected = blocks(render_with(scene, "path", {{"max_depth", "5"}}, 1024));
  const auto error = [&](const char* name, const char* radius) {
    const auto found = blocks(render_with(
        scene, name,
        {{"max_length", "5"}, {"scene_radius", radius}, {"alpha", "1"}, {"light_paths", "16"}},
        16));
    double sum = 0;
    for (size_t i = 0; i < found.size(); ++i) sum += sqr(found[i] / expected[i] - 1);
    return std::sqrt(sum / static_cast<double>(found.size()));
  };
  // Inside a wall the bias goes with the square of the radius, at edges with the radius itself: at
  // a quarter of it, it is between a sixteenth and a quarter; the rest is noise.
  for (const char* name : {"pppm", "bpm"}) {
    const double wide = error(name, "20");
    EXPECT_GT(wide, 0.05) << name;
    EXPECT_LT(error(name, "5"), 0.4 * wide) << name;
  }
}

// -- Layers, techniques, photons.

TEST(Bidirectional, layers_add_up) {
  SceneDescription description = testing::room(16, 16);
  description.bsdfs.push_back({.name = "mirror", .line = 0, .model = ConductorBsdf{}});
  testing::add_sphere(description, {0.3f, -0.6f, -0.3f}, 0.3f,
                      static_cast<int>(description.bsdfs.size()) - 1);
  for (const char* name : {"bdpt", "vcm", "bpm", "bdpm", "light", "pppm"}) {
    Values values = {{"light_paths", "8"}};
    if (name != std::string("bdpt") && name != std::string("light")) {
      values.emplace_back("scene_radius", "5");
    }
    const Film film = render_with(testing::build(description), name, values, 8);
    const double beauty = mean(film);
    EXPECT_NEAR(mean(film, Layer::Direct) + mean(film, Layer::Indirect), beauty, 1e-4 * beauty);
    EXPECT_NEAR(mean(film, Layer::Connection) + mean(film, Layer::Merging), beauty, 1e-4 * beauty);
    EXPECT_GT(mean(film, Layer::Caustic), 0) << name;
    EXPECT_LT(mean(film, Layer::Caustic), mean(film, Layer::Indirect)) << name;
    EXPECT_EQ(mean(film, Layer::Merging) > 0,
              std::string(name) != "bdpt" && std::string(name) != "light");
  }
}

TEST(Techniques, weighted_ones_sum_to_the_picture_and_raw_ones_are_complete_alone) {
  const auto scene = testing::build(testing::room(16, 16));
  TechniqueImages techniques(16, 16);
  const Film film = render_with(
      scene, "vcm",
      {{"max_length", "4"}, {"merge_direct", "true"}, {"scene_radius", "2"}, {"alpha", "1"}}, 256,
      1, 2, &techniques);
  const auto images = techniques.develop();
  double sum = 0;
  std::map<int, std::vector<double>> raw_by_length;
  for (const auto& [technique, pair] : images) {
    sum += luminance(mean_color(pair.weighted));
    raw_by_length[technique.path_length()].push_back(luminance(mean_color(pair.raw)));
  }
  EXPECT_NEAR(sum, mean(film), 1e-3 * mean(film));
  // Paths of k segments: s from 0 to k by connection (t = 1 with s = 1 is left to emission), and
  // merging at k - 1 vertices.
  EXPECT_EQ(raw_by_length[2].size(), 3u + 1u);
  EXPECT_EQ(raw_by_length[4].size(), 5u + 3u);
  for (const int length : {2, 3}) {
    const double expected = raw_by_length[length][1];  // next-event estimation is the least noisy
    for (const double raw : raw_by_length[length]) {
      // Close vertices connected give raw ones a few huge values.
      EXPECT_NEAR(raw, expected, 0.1 * expected) << "length " << length;
    }
  }
}

TEST(Techniques, sum_to_the_picture_of_a_pass_that_is_given_up) {
  const auto scene = testing::build(testing::room(128, 128));
  for (const char* name : {"bdpt", "vcm"}) {
    Film film(128, 128, scene->camera().film().filter);
    TechniqueImages techniques(128, 128);
    WorkControl control;
    Parallel parallel(2, &control);
    const PassContext context{.seed = 1, .parallel = &parallel, .techniques = &techniques};
    const auto integrator =
        find_integrator(name).create(scene, *settings_for(name, {{"max_length", "9"}}));
    const Stopwatch watch;
    integrator->render_pass(0, film, context);
    const std::chrono::duration<double> midway(0.7 * watch.seconds());
    std::thread stopper([&] {
      std::this_thread::sleep_for(midway);
      control.request_stop();
    });
    EXPECT_THROW(
        {
          for (uint32_t pass = 1;; ++pass) integrator->render_pass(pass, film, context);
        },
        Stopped);
    stopper.join();
    double sum = 0;
    for (const auto& [technique, pair] : techniques.develop()) {
      sum += luminance(mean_color(pair.weighted));
    }
    EXPECT_NEAR(sum, mean(film), 1e-3 * mean(film)) << name;
  }
}

TEST(Photons, of_the_first_bounce_carry_the_light_that_is_emitted) {
  // A closed room catches all of it: π · area · radiance.
  const auto scene = testing::build(testing::room(64, 64));
  const double emitted = scene->lights().front()->power();
  for (const char* name : {"vcm", "bpm", "sppm", "bdpm", "photon_map"}) {
    Film film(64, 64);
    Parallel parallel(2);
    PhotonRequest request(1000000);
    auto settings = settings_for(name);
    if (std::string(name) == "vcm") set_parameter(*settings, "merge_direct", "true");
    find_integrator(name)
        .create(scene, *settings)
        ->render_pass(0, film, {.parallel = &parallel, .photons = &request});
    double power = 0;
    for (const auto& point : request.cloud().points) {
      EXPECT_NEAR(glm::length(point.direction), 1, 1e-3);
      if (point.bounce == 1) power += luminance(point.power);
    }
    EXPECT_GT(request.cloud().total, 1000u) << name;
    EXPECT_NEAR(power, emitted, 0.02 * emitted) << name;
  }
}

TEST(Photons, are_thinned_out_to_the_cap) {
  const auto scene = testing::build(testing::room(64, 64));
  Film film(64, 64);
  Parallel parallel(2);
  PhotonRequest request(100);
  find_integrator("sppm")
      .create(scene, *settings_for("sppm"))
      ->render_pass(0, film, {.parallel = &parallel, .photons = &request});
  EXPECT_GT(request.cloud().total, 1000u);
  EXPECT_LE(request.cloud().points.size(), 101u);
  EXPECT_GT(request.cloud().points.size(), 50u);
}

// -- Every integrator.

TEST(EveryIntegrator, is_the_same_on_one_and_two_threads) {
  const auto scene = testing::build(testing::room(40, 24));
  for (const IntegratorInfo& info : integrators()) {
    const Values values = few_paths(info.name);
    const Image one = render_with(scene, info.name, values, 2, 7, 1).develop(Layer::Beauty);
    const Image two = render_with(scene, info.name, values, 2, 7, 2).develop(Layer::Beauty);
    for (size_t i = 0; i < one.data().size(); ++i) {
      ASSERT_NEAR(one.data()[i], two.data()[i], 1e-6 + 1e-5 * one.data()[i]) << info.name;
    }
  }
}

TEST(EveryIntegrator, renders_scenes_that_are_hardly_any) {
  SceneDescription dark = testing::room(16, 16);
  dark.shapes.back().radiance.reset();
  SceneDescription powerless = testing::room(16, 16);
  powerless.shapes.back().radiance = ColorInput{Color(0)};
  const SceneDescription empty = testing::empty_scene(16, 16);
  for (const IntegratorInfo& info : integrators()) {
    for (const SceneDescription& description : {dark, powerless, empty}) {
      const Film film =
          render_with(testing::build(description), info.name, few_paths(info.name), 2);
      EXPECT_EQ(mean(film), 0) << info.name;
      EXPECT_EQ(film.rejected(), 0u) << info.name;
    }
  }
}

TEST(EveryIntegrator, of_a_black_room_shows_the_lamp_alone) {
  SceneDescription description = testing::room(16, 16);
  for (BsdfDescription& bsdf : description.bsdfs) bsdf.model = DiffuseBsdf{{Color(0)}};
  testing::look_at(description, {0, -0.5f, 0}, {0, 1, 0.01f}, 60);
  const auto scene = testing::build(description);
  const double expected = mean(render_with(scene, "path", {}, 4, 3));
  EXPECT_GT(expected, 0);
  for (const IntegratorInfo& info : integrators()) {
    EXPECT_NEAR(mean(render_with(scene, info.name, {}, 4, 3)), expected, 0.05 * expected)
        << info.name;
  }
}

TEST(EveryIntegrator, of_path_length_one_shows_emitters) {
  SceneDescription description = testing::room(16, 16);
  testing::look_at(description, {0, -0.5f, 0}, {0, 1, 0.01f}, 60);
  description.hints.max_depth = 1;
  const auto scene = testing::build(description);
  const auto mean_of = [&](const std::string& name) {
    return luminance(mean_color(testing::render(scene, 4, 2, 3, name).develop(Layer::Beauty)));
  };
  const double expected = mean_of("path");
  EXPECT_GT(expected, 0);
  for (const IntegratorInfo& info : integrators()) {
    EXPECT_NEAR(mean_of(info.name), expected, 0.05 * expected) << info.name;
  }
}

TEST(EveryIntegrator, of_chains_renders_a_single_pixel) {
  const auto scene = testing::build(testing::room(1, 1));
  for (const char* name : {"mlt", "pssmlt", "mps"}) {
    const Film film = render_with(scene, name, few_paths(name), 2);
    EXPECT_GT(mean(film), 0) << name;
    EXPECT_TRUE(std::isfinite(mean(film))) << name;
    EXPECT_EQ(film.rejected(), 0u) << name;
  }
}

TEST(EveryIntegrator, of_photons_from_chains_starts_them_anew_in_every_round) {
  const auto scene = testing::build(testing::room(4, 4));
  const auto settings = settings_for("mps", few_paths("mps"));
  set_parameter(*settings, "chains", "8");
  set_parameter(*settings, "mutations", "800");
  const auto mps = find_integrator("mps").create(scene, *settings);
  Film film(4, 4, scene->camera().film().filter);
  Parallel parallel(1);
  for (uint32_t pass = 0; pass < 3; ++pass) {
    mps->render_pass(pass, film, {.seed = 1, .parallel = &parallel});
  }
  const auto chains = mps->chain_statistics();
  ASSERT_TRUE(chains);
  EXPECT_EQ(chains->steps, 3u * 800);
  EXPECT_EQ(chains->restarts, 2u * 8);
}

TEST(EveryIntegrator, of_chains_has_a_shortest_and_a_longest_path) {
  const auto scene = testing::build(testing::room(16, 16));
  for (const char* name : {"mlt", "pssmlt", "mps"}) {
    const auto mean_of = [&](const char* shortest, const char* longest) {
      Values values = few_paths(name);
      values.insert(values.end(), {{"min_length", shortest}, {"max_length", longest}});
      return mean(render_with(scene, name, values, 2));
    };
    EXPECT_EQ(mean_of("4", "3"), 0) << name;
    EXPECT_GT(mean_of("4", "4"), 0) << name;
    EXPECT_GT(mean_of("1", "2"), 0) << name;
    EXPECT_TRUE(std::isfinite(mean_of("1", "64"))) << name;
  }
}

TEST(EveryIntegrator, sees_from_inside_glass) {
  SceneDescription description = testing::room(16, 16);
  description.bsdfs.push_back({.name = "glass", .line = 0, .model = DielectricBsdf{}});
  const int glass = static_cast<int>(description.bsdfs.size()) - 1;
  testing::add_sphere(description, {0, 0, 0.7f}, 0.25f, glass);
  testing::look_at(description, {0, 0, 0.7f}, {0, -0.2f, -1}, 70);
  const auto scene = testing::build(description);
  const double expected = mean(render_with(scene, "path", {{"max_depth", "6"}}, 1024));
  for (const IntegratorInfo& info : integrators()) {
    if (info.name == "path" || info.name == "light") continue;  // light meets no lens behind glass
    Values values = few_paths(info.name);
    values.emplace_back("max_length", "6");
    for (const Parameter& parameter : settings_for(info.name)->parameters()) {
      const bool counts_all = info.name == "photon_map" || info.name == "mps";
      if (parameter.key == "scene_radius" && info.name != "bdpm") {
        values.emplace_back("scene_radius", "2");
      }
      if (parameter.key == "light_paths" && !counts_all) values.emplace_back("light_paths", "16");
      if (parameter.key == "mutations" && !counts_all) values.emplace_back("mutations", "64");
    }
    EXPECT_NEAR(mean(render_with(scene, info.name, values, 24)), expected, 0.05 * expected)
        << info.name;
  }
}

TEST(Bidirectional, the_shortest_path_leaves_out_shorter_ones) {
  const auto scene = testing::build(testing::room(16, 16));
  for (const char* name : {"bdpt", "vcm", "bpm", "light"}) {
    const std::pair<std::string, std::string> radius = {"scene_radius", "3"};
    const bool merges = name == std::string("vcm") || name == std::string("bpm");
    const auto mean_of = [&](const char* shortest, const char* longest) {
      Values values = {{"min_length", shortest}, {"max_length", longest}, {"light_paths", "4"}};
      if (merges) values.push_back(radius);
      return mean(render_with(scene, name, values, 32));
    };
    const double all = mean_of("1", "5");
    EXPECT_NEAR(mean_of("1", "2") + mean_of("3", "5"), all, 0.02 * all) << name;
    EXPECT_EQ(mean_of("3", "2"), 0) << name;
  }
}

TEST(Bidirectional, radius_zero_is_refused_where_nothing_but_merging_is_left) {
  const auto scene = testing::build(testing::room(16, 16));
  for (const char* name : {"pppm", "bpm", "bdpm"}) {
    EXPECT_THROW(find_integrator(name).create(scene, *settings_for(name, {{"scene_radius", "0"}})),
                 Error)
        << name;
  }
  const double bdpt = mean(render_with(scene, "bdpt", {}, 32));
  EXPECT_NEAR(mean(render_with(scene, "vcm", {{"scene_radius", "0"}}, 32)), bdpt, 0.02 * bdpt);
}

TEST(Bidirectional, more_neighbors_than_photons_are_no_harm) {
  const auto scene = testing::build(testing::room(8, 8));
  const Film film =
      render_with(scene, "bdpm", {{"neighbors", "10000"}, {"scene_radius", "100"}}, 4);
  EXPECT_TRUE(std::isfinite(mean(film)));
  EXPECT_GT(mean(film), 0);
}

TEST(Bidirectional, a_pass_of_a_million_light_paths_stops_at_once) {
  const auto scene = testing::build(testing::room(64, 64));
  for (const char* name : {"vcm", "sppm", "bdpm"}) {
    Film film(64, 64);
    WorkControl control;
    Parallel parallel(2, &control);
    const auto integrator =
        find_integrator(name).create(scene, *settings_for(name, {{"light_paths", "100"}}));
    std::thread stopper([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      control.request_stop();
    });
    EXPECT_THROW(
        {
          for (uint32_t pass = 0;; ++pass) {
            integrator->render_pass(pass, film, {.parallel = &parallel});
          }
        },
        Stopped)
        << name;
    stopper.join();
    EXPECT_TRUE(std::isfinite(mean(film))) << name;
  }
}

}  // namespace
}  // namespace guidelight
