// Scenes whose radiance is known in closed form.

#include "renderer/integrators/path_tracer.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/error.h"
#include "renderer/image/metrics.h"
#include "tests/renderer/test_scenes.h"

namespace guidelight {
namespace {

using testing::build;
using testing::render;

void add_constant_light(SceneDescription& scene, Color radiance) {
  scene.emitters.push_back({"environment", 0, ConstantEmitter{radiance}});
}

Color mean_beauty(SceneDescription scene, uint32_t passes) {
  return mean_color(render(build(std::move(scene)), passes).develop(Layer::Beauty));
}

/// The standard error of each mean below is at most a tenth of the tolerance (measured over seeds).
void expect_color(Color actual, Color expected, float relative) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], relative * expected[c]);
}

TEST(PathTracer, white_furnace_stays_white) {
  // A white diffuse ball under uniform radiance 1: L = 1 + (ρ-1)·… = 1 wherever the ray ends.
  SceneDescription scene = testing::empty_scene();
  testing::add_sphere(scene, Vec3(0), 1, testing::add_diffuse(scene, Color(1)));
  testing::look_at(scene, {0, 0, 3}, Vec3(0), 50);
  add_constant_light(scene, Color(1));
  expect_color(mean_beauty(scene, 64), Color(1), 0.01f);
}

TEST(PathTracer, diffuse_ball_under_uniform_sky_shows_its_albedo) {
  // A convex diffuse body sees all its irradiance from the sky: E = πL, so L_out = ρ·E/π = ρL.
  SceneDescription scene = testing::empty_scene();
  const Color albedo(0.8f, 0.5f, 0.2f);
  testing::add_sphere(scene, Vec3(0), 1, testing::add_diffuse(scene, albedo));
  testing::look_at(scene, {0, 0, 3}, Vec3(0), 10);  // the picture lies inside the ball's outline
  add_constant_light(scene, Color(2));
  expect_color(mean_beauty(scene, 64), 2.0f * albedo, 0.01f);
}

TEST(PathTracer, glowing_sphere_seen_from_inside_sums_the_geometric_series) {
  // Inside a sphere that emits Le and reflects ρ everywhere, L = Le + ρL, so L = Le/(1-ρ); with at
  // most n segments L = Le (1-ρⁿ)/(1-ρ).
  for (const int max_depth : {1, 2, 3, -1}) {
    SceneDescription scene = testing::empty_scene();
    auto& sphere = testing::add_sphere(scene, Vec3(0), 2, testing::add_diffuse(scene, Color(0.6f)));
    sphere.flip_normals = true;
    sphere.radiance = ColorInput{Color(1, 2, 3)};
    testing::look_at(scene, {0.5f, 0.2f, 0}, {1, 0, 1});
    scene.hints.max_depth = max_depth;
    const float sum = max_depth < 0 ? 2.5f : (1 - std::pow(0.6f, max_depth)) / 0.4f;
    expect_color(mean_beauty(scene, 256), sum * Color(1, 2, 3), 0.01f);
  }
}

TEST(PathTracer, point_light_follows_cosine_and_inverse_square) {
  // Diffuse plane under a point light at height h: at horizontal distance x, cosθ = h/d, d² =
  // x²+h², L = ρ/π · I·cosθ/d². The camera looks at a small spot with x = 1, h = 2.
  SceneDescription scene = testing::empty_scene(4, 4);
  testing::add_rectangle(scene, glm::scale(Mat4(1), Vec3(10)),
                         testing::add_diffuse(scene, Color(0.5f)));
  scene.emitters.push_back({"bulb", 0, PointEmitter{{0, 0, 2}, Color(10, 20, 30)}});
  testing::look_at(scene, {1, 0, 5}, {1, 0, 0}, 0.2f);
  const float d = std::sqrt(5.0f);
  expect_color(mean_beauty(scene, 4), 0.5f * kInvPi * Color(10, 20, 30) * (2 / d) / (d * d), 1e-3f);
}

TEST(PathTracer, disk_light_on_the_axis) {
  // Irradiance below the centre of a disk light of radius r at height h: E = πL r²/(r²+h²).
  SceneDescription scene = testing::empty_scene(4, 4);
  testing::add_rectangle(scene, glm::scale(Mat4(1), Vec3(10)),
                         testing::add_diffuse(scene, Color(1)));
  ShapeDescription disk;
  disk.geometry = DiskShape{};
  disk.to_world = glm::translate(Mat4(1), Vec3(0, 0, 2)) *
                  glm::rotate(Mat4(1), kPi, Vec3(1, 0, 0));  // faces down
  disk.radiance = ColorInput{Color(3)};
  disk.bsdf = testing::add_diffuse(scene, Color(0));
  scene.shapes.push_back(disk);
  testing::look_at(scene, {0.2f, 0, 1}, {0, 0, 0}, 0.1f);
  expect_color(mean_beauty(scene, 1024), Color(3.0f * 1 / 5), 0.01f);
}

TEST(PathTracer, one_bright_texel_lights_by_its_solid_angle) {
  // A floor under an environment of 100×50 texels, black but for one of radiance 100 in row 13:
  // with θ = π·13.5/50, E = 100·cosθ·(sinθ·π/50·2π/100) and L = ρE/π. Bilinear interpolation
  // spreads the texel over its neighbours, which changes E by less than 0.5 %.
  SceneDescription scene = testing::empty_scene(4, 4);
  const Mat4 flat = glm::rotate(Mat4(1), -kPi / 2, Vec3(1, 0, 0));  // normal +y
  testing::add_rectangle(scene, flat, testing::add_diffuse(scene, Color(0.5f)));
  auto image = std::make_shared<Image>(100, 50, 3);
  for (int c = 0; c < 3; ++c) image->pixel(20, 13)[c] = 1;
  EnvironmentEmitter sky;
  sky.image = image;
  sky.scale = 100;
  scene.emitters.push_back({"sky", 0, sky});
  testing::look_at(scene, {0, 3, 0.1f}, Vec3(0), 0.2f);
  const float theta = kPi * 13.5f / 50;
  const float irradiance = 100 * std::cos(theta) * std::sin(theta) * (kPi / 50) * (2 * kPi / 100);
  expect_color(mean_beauty(scene, 4096), Color(0.5f * kInvPi * irradiance), 0.02f);
}

TEST(PathTracer, mirror_and_glass_pass_the_sky_on) {
  // A lossless mirror or glass ball under uniform radiance is invisible: every path ends in the sky
  // with throughput 1 (the η² of entering and leaving cancel).
  for (const bool glass : {false, true}) {
    SceneDescription scene = testing::empty_scene();
    if (glass) {
      scene.bsdfs.push_back({"glass", 0, DielectricBsdf{}});
    } else {
      scene.bsdfs.push_back({"mirror", 0, ConductorBsdf{}});
    }
    testing::add_sphere(scene, Vec3(0), 1, 0);
    testing::look_at(scene, {0, 0, 3}, Vec3(0), 30);
    add_constant_light(scene, Color(1));
    expect_color(mean_beauty(scene, 64), Color(1), 0.005f);
  }
}

TEST(PathTracer, absorbing_medium_follows_beer_lambert) {
  // An index-matched slab of thickness 2 in front of a uniform sky: L = L₀ exp(-σ·2) straight
  // through.
  SceneDescription scene = testing::empty_scene(4, 4);
  scene.bsdfs.push_back({"boundary", 0, NullBsdf{}});
  scene.media.push_back({"ink", 0, Color(0.1f, 0.5f, 1.0f)});
  for (const float z : {-1.0f, 1.0f}) {
    Mat4 place = glm::translate(Mat4(1), Vec3(0, 0, z));
    if (z < 0) place = glm::rotate(place, kPi, Vec3(1, 0, 0));  // normals point out of the slab
    auto& side = testing::add_rectangle(scene, glm::scale(place, Vec3(5)), 0);
    side.is_medium_boundary = true;
    side.interior = 0;
  }
  testing::look_at(scene, {0, 0, 4}, Vec3(0), 0.1f);
  add_constant_light(scene, Color(1));
  expect_color(mean_beauty(scene, 4), glm::exp(-2.0f * Color(0.1f, 0.5f, 1.0f)), 1e-3f);
}

TEST(PathTracer, layers_add_up) {
  const Film film = render(build(testing::room()), 16);
  const Image beauty = film.develop(Layer::Beauty);
  const Image direct = film.develop(Layer::Direct);
  const Image indirect = film.develop(Layer::Indirect);
  for (size_t i = 0; i < beauty.data().size(); ++i) {
    EXPECT_NEAR(beauty.data()[i], direct.data()[i] + indirect.data()[i],
                1e-5f * (1 + beauty.data()[i]));
  }
  EXPECT_GT(luminance(mean_color(indirect)), 0.01f);
  const Image albedo = film.develop(Layer::Albedo);
  EXPECT_NEAR(albedo.color(8, 12).g, 0.7f, 0.05f);  // the floor
}

TEST(PathTracer, a_mirror_throws_a_caustic_like_a_second_lamp) {
  // A glowing ball of radius r at distance d gives E = πL cosθ r²/d². A mirror in the plane x = 1.5
  // doubles the ball at (0, 0, 2) by one at (3, 0, 2), whose light is the caustic.
  SceneDescription scene = testing::empty_scene();
  testing::add_rectangle(scene, glm::scale(Mat4(1), Vec3(10)),
                         testing::add_diffuse(scene, Color(0.5f)));
  testing::add_sphere(scene, {0, 0, 2}, 1, testing::add_diffuse(scene, Color(0))).radiance =
      ColorInput{Color(1, 2, 3)};
  scene.bsdfs.push_back({"mirror", 0, ConductorBsdf{}});
  const Mat4 place =
      glm::rotate(glm::translate(Mat4(1), Vec3(1.5f, 0, 0)), -kPi / 2, Vec3(0, 1, 0));
  testing::add_rectangle(scene, glm::scale(place, Vec3(10)), 2);
  testing::look_at(scene, {0.2f, 0, 0.5f}, Vec3(0), 0.1f);
  scene.hints.max_depth = 3;
  const Film film = render(build(std::move(scene)), 4096);
  const Color radiance = 0.5f * Color(1, 2, 3);  // ρ L
  const float cosine = 2 / std::sqrt(13.0f);
  expect_color(mean_color(film.develop(Layer::Direct)), radiance / 4.0f, 0.01f);
  expect_color(mean_color(film.develop(Layer::Caustic)), radiance * cosine / 13.0f, 0.05f);
}

TEST(PathTracer, caustics_need_something_specular_and_are_a_part_of_indirect_light) {
  for (const bool glass : {false, true}) {
    SceneDescription scene = testing::room(32, 32);
    if (glass) {
      scene.bsdfs.push_back({"glass", 0, DielectricBsdf{}});
      testing::add_sphere(scene, Vec3(0), 0.3f, static_cast<int>(scene.bsdfs.size()) - 1);
    }
    const Film film = render(build(std::move(scene)), 64);
    const Image caustic = film.develop(Layer::Caustic);
    const Image indirect = film.develop(Layer::Indirect);
    for (size_t i = 0; i < caustic.data().size(); ++i) {
      EXPECT_LE(caustic.data()[i], indirect.data()[i] * (1 + 1e-5f));
    }
    EXPECT_EQ(luminance(mean_color(caustic)) > 0.001f, glass);
    EXPECT_EQ(mean_color(caustic) == Color(0), !glass);
    EXPECT_EQ(mean_color(film.develop(Layer::Merging)), Color(0));
    EXPECT_EQ(mean_color(film.develop(Layer::Connection)), mean_color(film.develop(Layer::Beauty)));
  }
}

TEST(PathTracer, is_the_same_on_one_and_two_threads_and_differs_by_seed) {
  const auto scene = build(testing::room(40, 24));
  const Image one = render(scene, 4, 1, 7).develop(Layer::Beauty);
  const Image two = render(scene, 4, 2, 7).develop(Layer::Beauty);
  const Image other = render(scene, 4, 2, 8).develop(Layer::Beauty);
  for (size_t i = 0; i < one.data().size(); ++i) {
    ASSERT_NEAR(one.data()[i], two.data()[i], 1e-6f * std::abs(one.data()[i]));
  }
  EXPECT_NE(mean_color(one), mean_color(other));
}

TEST(PathTracer, a_region_holds_the_same_samples_as_the_whole_picture) {
  const auto scene = build(testing::room(40, 24));
  const Image whole = render(scene, 2).develop(Layer::Beauty);
  Film film(40, 24, scene->camera().film().filter);
  const auto integrator = path_tracer_info().create(scene, *path_tracer_info().make_settings({}));
  Parallel parallel(2);
  const PixelRegion region{5, 3, 30, 20};
  for (uint32_t pass = 0; pass < 2; ++pass)
    integrator->render_pass(pass, film, {1, &parallel, region});
  const Image part = film.develop(Layer::Beauty);
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 40; ++x) {
      const bool inside = x >= 5 && x < 30 && y >= 3 && y < 20;
      EXPECT_EQ(part.color(x, y), inside ? whole.color(x, y) : Color(0)) << x << " " << y;
    }
  }
}

TEST(PathTracer, a_scene_without_lights_is_black) {
  SceneDescription scene = testing::empty_scene();
  testing::add_sphere(scene, Vec3(0), 1);
  testing::look_at(scene, {0, 0, 3}, Vec3(0));
  EXPECT_EQ(mean_beauty(scene, 2), Color(0));
  EXPECT_EQ(mean_beauty(testing::empty_scene(), 1), Color(0)) << "an empty scene renders, too";
}

TEST(Parameters, are_set_from_text_and_checked) {
  PathTracerSettings settings;
  set_parameter(settings, "max_depth", "7");
  EXPECT_EQ(settings.max_depth, 7);
  EXPECT_EQ(parameter_text(settings.parameters()[0]), "7");
  EXPECT_THROW(set_parameter(settings, "max_depth", "7x"), Error);
  EXPECT_THROW(set_parameter(settings, "max_depth", "-2"), Error);
  EXPECT_THROW(set_parameter(settings, "max_depth", ""), Error);
  EXPECT_THROW(set_parameter(settings, "depth", "7"), Error);
  EXPECT_EQ(settings.max_depth, 7);
  EXPECT_THROW(find_integrator("none"), Error);
}

}  // namespace
}  // namespace guidelight
