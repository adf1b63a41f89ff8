// Photons on coarse facets that are shaded as if they were round. A photon and the point that finds
// it may lie on facets whose true cosines have nothing to do with each other.

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/image/metrics.h"
#include "tests/renderer/integrators/independent_runs.h"
#include "tests/renderer/test_scenes.h"

namespace guidelight {
namespace {

constexpr int kFacetSide = 48;

/// A unit sphere of few facets, with the normals of a round one at its vertices.
std::shared_ptr<const Mesh> faceted_sphere(int columns, int rows) {
  auto mesh = std::make_shared<Mesh>();
  for (int row = 0; row <= rows; ++row) {
    const float theta = kPi * static_cast<float>(row) / static_cast<float>(rows);
    for (int column = 0; column < columns; ++column) {
      const float phi = 2 * kPi * static_cast<float>(column) / static_cast<float>(columns);
      mesh->positions.emplace_back(std::sin(theta) * std::cos(phi), std::cos(theta),
                                   -std::sin(theta) * std::sin(phi));
    }
  }
  mesh->normals = mesh->positions;
  const auto at = [&](int row, int column) {
    return static_cast<uint32_t>(row * columns + column % columns);
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const uint32_t corner = at(row, column), right = at(row, column + 1);
      const uint32_t below = at(row + 1, column), opposite = at(row + 1, column + 1);
      if (row + 1 < rows) mesh->triangles.push_back({corner, below, opposite});
      if (row > 0) mesh->triangles.push_back({corner, opposite, right});
    }
  }
  return mesh;
}

/// The ball on a floor beside a lamp.
std::shared_ptr<const Scene> ball_beside_lamp() {
  SceneDescription scene = testing::empty_scene(kFacetSide, kFacetSide);
  const int white = testing::add_diffuse(scene, Color(0.7f));
  ShapeDescription ball;
  ball.name = "ball";
  ball.geometry = MeshShape{faceted_sphere(8, 6)};
  ball.bsdf = white;
  scene.shapes.push_back(ball);
  const Mat4 floor =
      glm::rotate(glm::translate(Mat4(1), Vec3(0, -1, 0)), glm::radians(-90.0f), Vec3(1, 0, 0));
  testing::add_rectangle(scene, glm::scale(floor, Vec3(2)), white);
  testing::add_sphere(scene, {2.5f, 1.5f, 0.5f}, 0.2f).radiance = ColorInput{Color(60)};
  testing::look_at(scene, {0, 1.5f, 5}, {0, -0.1f, 0}, 32);
  scene.hints.max_depth = 4;
  return testing::build(std::move(scene));
}

Image render(const std::shared_ptr<const Scene>& scene, const std::string& name, uint32_t passes,
             const std::vector<std::pair<std::string, std::string>>& values) {
  const auto settings = find_integrator(name).make_settings(scene->description().hints);
  for (const auto& [key, value] : values) set_parameter(*settings, key, value);
  Film film(kFacetSide, kFacetSide, scene->camera().film().filter);
  const auto integrator = find_integrator(name).create(scene, *settings);
  Parallel parallel(2);
  for (uint32_t pass = 0; pass < passes; ++pass) {
    integrator->render_pass(pass, film, {.seed = 1, .parallel = &parallel});
  }
  return film.develop(Layer::Beauty);
}

double brightest(const Image& picture) {
  double result = 0;
  for (int y = 0; y < kFacetSide; ++y) {
    for (int x = 0; x < kFacetSide; ++x) {
      result = std::max<double>(result, luminance(picture.color(x, y)));
    }
  }
  return result;
}

TEST(ShadingNormals, make_no_fireflies_of_photons_from_other_facets) {
  const auto scene = ball_beside_lamp();
  const Image expected = render(scene, "path", 512, {});
  using Values = std::vector<std::pair<std::string, std::string>>;
  const std::vector<std::pair<const char*, Values>> methods = {
      {"sppm", {{"scene_radius", "4"}}},
      {"vcm", {{"scene_radius", "4"}, {"merge_direct", "true"}}},
      {"bdpm", {{"neighbors", "100"}}},
  };
  for (auto [name, values] : methods) {
    values.emplace_back("light_paths", "16");
    const Image found = render(scene, name, 16, values);
    // Wide estimates blur what is bright.
    EXPECT_LT(brightest(found), 1.2 * brightest(expected)) << name;
    EXPECT_LT(compare_images(found, expected).relative_mse.robust, 0.1) << name;
  }
}

/// The discs are narrow, but not infinitely so.
TEST(ShadingNormals, agree_with_the_path_tracer_where_photons_are_looked_for_near) {
  const auto scene = ball_beside_lamp();
  const testing::Runs runs{.count = 8, .first_seed = 1, .block = 16};
  constexpr double kBias = 0.01;
  const auto expected = measure(scene, {"path", "", 64}, runs);
  const std::vector<testing::Method> methods = {
      {"sppm", "scene_radius=0.5,light_paths=8", 4},
      {"vcm", "scene_radius=0.5,light_paths=8,merge_direct=true", 4},
      {"bdpm", "neighbors=10,light_paths=16", 4},
  };
  // Chance of a false alarm: 1e-3.
  const double level = statistics::sidak_level(1e-3, methods.size() * expected.size());
  for (const testing::Method& method : methods) {
    const auto found = measure(scene, method, runs);
    for (size_t i = 0; i < found.size(); ++i) {
      EXPECT_GT(statistics::welch_test(found[i], expected[i], kBias * expected[i].mean()), level)
          << method.name << ", block " << i << ": " << testing::describe(found[i], expected[i]);
    }
  }
}

}  // namespace
}  // namespace guidelight
