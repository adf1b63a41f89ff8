#include "renderer/scene/camera.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/error.h"
#include "renderer/math/frame.h"
#include "renderer/sampling/random.h"
#include "tests/statistics/hypothesis_tests.h"

namespace guidelight {
namespace {

constexpr float kDegrees = kPi / 180;

Mat4 tilted() {
  const Mat4 turn = glm::rotate(Mat4(1), 1.1f, glm::normalize(Vec3(1, 2, -0.5f)));
  return glm::translate(Mat4(1), Vec3(3, -2, 5)) * turn;
}

struct CameraCase {
  std::string name;
  CameraDescription camera;
  FilmDescription film;
};

std::vector<CameraCase> make_cases() {
  std::vector<CameraCase> cases;
  FilmDescription film;
  film.width = 120;
  film.height = 80;
  CameraDescription camera;
  camera.to_world = tilted();
  const auto add = [&](const char* name, const CameraDescription& c, const FilmDescription& f) {
    cases.push_back({name, c, f});
  };
  const std::pair<const char*, FovAxis> axes[] = {{"fov_x", FovAxis::X},
                                                  {"fov_y", FovAxis::Y},
                                                  {"fov_diagonal", FovAxis::Diagonal},
                                                  {"fov_smaller", FovAxis::Smaller},
                                                  {"fov_larger", FovAxis::Larger}};
  for (const auto& [name, axis] : axes) {
    CameraDescription c = camera;
    c.fov_axis = axis;
    add(name, c, film);
  }
  CameraDescription mirrored = camera;
  mirrored.to_world = tilted() * glm::scale(Mat4(1), Vec3(-1, 1, 1));
  add("mirrored", mirrored, film);
  CameraDescription stretched = camera;
  stretched.to_world = tilted() * glm::scale(Mat4(1), Vec3(2, 1, 0.5f));
  add("stretched", stretched, film);
  CameraDescription shifted = camera;
  shifted.principal_point_offset = {0.2f, -0.1f};
  add("principal_point", shifted, film);
  FilmDescription cropped = film;
  cropped.crop_x = 30, cropped.crop_y = 10, cropped.crop_width = 50, cropped.crop_height = 40;
  add("crop", camera, cropped);
  add("principal_point_and_crop", shifted, cropped);
  CameraDescription lens = camera;
  lens.model = CameraModel::ThinLens;
  lens.aperture_radius = 0.3f;
  lens.focus_distance = 4;
  add("thin_lens", lens, film);
  CameraDescription shifted_lens = lens;
  shifted_lens.principal_point_offset = {-0.1f, 0.3f};
  add("thin_lens_crop", shifted_lens, cropped);
  CameraDescription orthographic = camera;
  orthographic.model = CameraModel::Orthographic;
  add("orthographic", orthographic, film);
  orthographic.to_world = tilted() * glm::scale(Mat4(1), Vec3(-3, 2, 1));
  add("orthographic_mirrored_crop", orthographic, cropped);
  return cases;
}

class EveryCamera : public ::testing::TestWithParam<CameraCase> {
 protected:
  Camera camera_{GetParam().camera, GetParam().film};
  Vec2 size_{camera_.width(), camera_.height()};
  bool is_orthographic_ = GetParam().camera.model == CameraModel::Orthographic;
};

TEST_P(EveryCamera, ConnectionsFindTheRasterPositionOfTheirRay) {
  Rng rng(1, 0, 0);
  for (int i = 0; i < 2000; ++i) {
    const Vec2 raster = rng.next_vec2() * size_;
    const Vec2 u_lens = rng.next_vec2();
    const CameraSample sample = camera_.sample_ray(raster, u_lens);
    ASSERT_NEAR(glm::length(sample.ray.direction), 1, 1e-5f);
    ASSERT_EQ(sample.weight, Color(1));
    const auto seen = camera_.raster_of(sample.lens_position, sample.ray.direction);
    if (!seen) continue;  // on the border, by rounding
    ASSERT_NEAR(glm::length(*seen - raster), 0, 2e-3f);
    ASSERT_NEAR(
        camera_.pdf_direction(sample.lens_position, sample.ray.direction) / sample.pdf_direction, 1,
        1e-4f);

    const float distance = 0.5f + 20 * rng.next_float();
    const Vec3 point = sample.lens_position + distance * sample.ray.direction;
    const auto connection = camera_.connect(point, u_lens);
    if (!connection) continue;
    ASSERT_NEAR(glm::length(connection->raster - raster), 0, 5e-3f);
    ASSERT_NEAR(connection->distance, distance, 1e-4f * distance + 1e-5f);
    ASSERT_NEAR(glm::length(connection->lens_position - sample.lens_position), 0, 5e-5f);
    ASSERT_NEAR(glm::length(connection->direction + sample.ray.direction), 0, 1e-4f);
    ASSERT_NEAR(connection->pdf_direction / sample.pdf_direction, 1, 1e-3f);
    const float cosine = glm::dot(camera_.forward(), sample.ray.direction);
    ASSERT_NEAR(connection->cos_camera, cosine, 1e-4f);
    if (!is_orthographic_) {
      ASSERT_NEAR(
          connection->importance / camera_.importance(sample.lens_position, sample.ray.direction),
          1, 1e-3f);
    }
  }
}

TEST_P(EveryCamera, MostOfThePictureConnects) {
  Rng rng(2, 0, 0);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 raster = 0.01f + rng.next_vec2() * (size_ - 0.02f);
    const Vec2 u_lens = rng.next_vec2();
    const CameraSample sample = camera_.sample_ray(raster, u_lens);
    EXPECT_TRUE(camera_.connect(sample.lens_position + 3.0f * sample.ray.direction, u_lens));
  }
}

/// ∫ We dA cosθ dω = 1 over the picture, and as much per pixel in the margin: light from
/// everywhere, of radiance 1, gives the mean pixel the value 1. Points are drawn uniformly on a
/// sphere around the camera and connected, as a light tracer does.
TEST_P(EveryCamera, ImportanceIsNormalised) {
  const float radius = 40;
  const float area = 4 * kPi * sqr(radius);
  statistics::Moments contribution;
  Rng rng(3, 0, 0);
  for (int i = 0; i < 400000; ++i) {
    const float z = 2 * rng.next_float() - 1;
    const float phi = 2 * kPi * rng.next_float();
    const float r = safe_sqrt(1 - z * z);
    const Vec3 direction(r * std::cos(phi), r * std::sin(phi), z);
    const auto connection =
        camera_.connect(camera_.position() + radius * direction, rng.next_vec2());
    if (!connection) {
      contribution.add(0);
      continue;
    }
    const float cos_point = std::abs(glm::dot(connection->direction, direction));
    contribution.add(area * cos_point * connection->cos_camera * connection->importance /
                     (sqr(double(connection->distance)) * connection->pdf_lens));
  }
  static const double kLevel = statistics::sidak_level(1e-3, make_cases().size());
  EXPECT_GT(statistics::t_test(contribution, camera_.raster_excess(), 1e-4), kLevel)
      << contribution.mean();
}

/// The density of directions, integrated over the sphere by uniform directions, the margin too.
/// Orthographic cameras have none.
class ProjectiveCamera : public EveryCamera {};
TEST_P(ProjectiveCamera, DirectionDensityIntegratesToOne) {
  const Vec3 lens = camera_.sample_ray({1, 1}, {0.7f, 0.2f}).lens_position;
  statistics::Moments integral;
  Rng rng(4, 0, 0);
  for (int i = 0; i < 400000; ++i) {
    const float z = rng.next_float();  // forward hemisphere, density 1/2π
    const float phi = 2 * kPi * rng.next_float();
    const float r = safe_sqrt(1 - z * z);
    const Frame frame = Frame::from_normal(camera_.forward());
    const Vec3 w = frame.to_world({r * std::cos(phi), r * std::sin(phi), z});
    integral.add(2 * kPi * camera_.pdf_direction(lens, w));
  }
  static const double kLevel = statistics::sidak_level(1e-3, make_cases().size());
  EXPECT_GT(statistics::t_test(integral, camera_.raster_excess(), 1e-4), kLevel) << integral.mean();
}

std::vector<CameraCase> make_projective_cases() {
  std::vector<CameraCase> cases = make_cases();
  std::erase_if(cases,
                [](const CameraCase& c) { return c.camera.model == CameraModel::Orthographic; });
  return cases;
}

INSTANTIATE_TEST_SUITE_P(All, EveryCamera, ::testing::ValuesIn(make_cases()),
                         [](const auto& test) { return test.param.name; });
INSTANTIATE_TEST_SUITE_P(All, ProjectiveCamera, ::testing::ValuesIn(make_projective_cases()),
                         [](const auto& test) { return test.param.name; });

/// Angle of view between two raster positions, [degrees].
float view_angle(const Camera& camera, Vec2 a, Vec2 b) {
  const Vec3 u = camera.sample_ray(a, Vec2(0.5f)).ray.direction;
  const Vec3 v = camera.sample_ray(b, Vec2(0.5f)).ray.direction;
  return std::acos(glm::dot(u, v)) / kDegrees;
}

TEST(Camera, EveryFovAxisMeasuresWhatItNames) {
  FilmDescription film;
  film.width = 200;
  film.height = 100;
  const auto camera = [&](FovAxis axis) {
    CameraDescription description;
    description.fov = 60;
    description.fov_axis = axis;
    return Camera(description, film);
  };
  const auto across = [](const Camera& c) { return view_angle(c, {0, 50}, {200, 50}); };
  const auto down = [](const Camera& c) { return view_angle(c, {100, 0}, {100, 100}); };
  EXPECT_NEAR(across(camera(FovAxis::X)), 60, 0.01);
  EXPECT_NEAR(down(camera(FovAxis::Y)), 60, 0.01);
  EXPECT_NEAR(view_angle(camera(FovAxis::Diagonal), {0, 0}, {200, 100}), 60, 0.01);
  EXPECT_NEAR(down(camera(FovAxis::Smaller)), 60, 0.01);
  EXPECT_NEAR(across(camera(FovAxis::Larger)), 60, 0.01);
  std::swap(film.width, film.height);
  EXPECT_NEAR(view_angle(camera(FovAxis::Smaller), {0, 100}, {100, 100}), 60, 0.01);
  EXPECT_NEAR(view_angle(camera(FovAxis::Larger), {50, 0}, {50, 200}), 60, 0.01);
}

TEST(Camera, LeftOfThePictureIsLocalPlusX) {
  FilmDescription film;
  film.width = film.height = 10;
  CameraDescription description;
  EXPECT_GT(Camera(description, film).sample_ray({1, 5}, {}).ray.direction.x, 0.1f);
  EXPECT_GT(Camera(description, film).sample_ray({5, 1}, {}).ray.direction.y, 0.1f);
  EXPECT_NEAR(Camera(description, film).sample_ray({5, 5}, {}).ray.direction.z, 1, 1e-6f);
  description.to_world = glm::scale(Mat4(1), Vec3(-1, 1, 1));
  EXPECT_LT(Camera(description, film).sample_ray({1, 5}, {}).ray.direction.x, -0.1f);
}

TEST(Camera, PositivePrincipalPointOffsetSeesFurtherRightAndDown) {
  // Mitsuba 3 adds the offset to the film position before it looks up the direction.
  FilmDescription film;
  film.width = film.height = 100;
  CameraDescription description;
  description.principal_point_offset = {0.25f, 0.1f};
  const Camera camera(description, film);
  const Vec3 direction = camera.sample_ray({25, 40}, {}).ray.direction;
  EXPECT_NEAR(glm::length(direction - Vec3(0, 0, 1)), 0, 1e-6f);
}

TEST(Camera, RaysStartAtTheNearPlaneAndEndAtTheFarOne) {
  CameraDescription description;
  description.near_clip = 2;
  description.far_clip = 30;
  const Camera camera(description, FilmDescription());
  const Ray ray = camera.sample_ray({3, 700}, {}).ray;
  EXPECT_NEAR(ray.origin.z, 2, 1e-5f);
  EXPECT_NEAR((ray.origin + ray.t_max * ray.direction).z, 30, 1e-4f);
  EXPECT_FALSE(camera.connect({0, 0, 1.9f}, {}));
  EXPECT_TRUE(camera.connect({0, 0, 2.1f}, {}));
  EXPECT_FALSE(camera.connect({0, 0, 31}, {}));
  EXPECT_FALSE(camera.connect({0, 0, -5}, {}));
}

TEST(Camera, TheFocusPlaneIsSharp) {
  CameraDescription description;
  description.model = CameraModel::ThinLens;
  description.aperture_radius = 0.5f;
  description.focus_distance = 7;
  const Camera camera(description, FilmDescription());
  const auto at_focus = [&](Vec2 u) {
    const CameraSample s = camera.sample_ray({100, 200}, u);
    return s.lens_position + s.ray.direction * (7 / s.ray.direction.z);
  };
  EXPECT_NEAR(glm::length(at_focus({0.1f, 0.2f}) - at_focus({0.9f, 0.6f})), 0, 1e-5f);
}

TEST(Camera, ResolutionKeepsTheView) {
  FilmDescription film;
  film.width = 120;
  film.height = 80;
  film.crop_x = 30, film.crop_y = 20, film.crop_width = 60, film.crop_height = 40;
  const Camera camera({}, film);
  const Camera small = camera.with_resolution(30, 20);
  EXPECT_EQ(small.width(), 30);
  EXPECT_EQ(small.height(), 20);
  const Vec3 a = camera.sample_ray({20, 10}, {}).ray.direction;
  const Vec3 b = small.sample_ray({10, 5}, {}).ray.direction;
  EXPECT_NEAR(glm::length(a - b), 0, 1e-5f);
}

TEST(Camera, BrokenDescriptionsAreErrors) {
  FilmDescription film;
  film.width = 0;
  EXPECT_THROW(Camera({}, film), Error);
  film = {};
  film.crop_width = 10;
  film.crop_height = 10;
  film.crop_x = 760;
  EXPECT_THROW(Camera({}, film), Error);
  CameraDescription camera;
  camera.to_world[1] = camera.to_world[0];
  EXPECT_THROW(Camera(camera, {}), Error);
  camera = {};
  camera.fov = 180;
  EXPECT_THROW(Camera(camera, {}), Error);
  camera = {};
  camera.far_clip = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(Camera(camera, {}), Error);
}

TEST(Camera, WhatReachesTooFarIsAnError) {
  const auto expect_error = [](const auto& change) {
    CameraDescription camera;
    camera.model = CameraModel::ThinLens;
    camera.aperture_radius = 0.1f;
    EXPECT_NO_THROW(Camera(camera, {}));
    change(camera);
    EXPECT_THROW(Camera(camera, {}), Error);
  };
  expect_error([](CameraDescription& c) { c.to_world[3].x = 1e19f; });
  expect_error([](CameraDescription& c) { c.near_clip = 1e20f, c.far_clip = 1e21f; });
  expect_error([](CameraDescription& c) { c.aperture_radius = 1e30f, c.focus_distance = 1e30f; });
  expect_error([](CameraDescription& c) { c.focus_distance = 1e-30f; });
  expect_error([](CameraDescription& c) { c.principal_point_offset.x = 1e30f; });
  expect_error([](CameraDescription& c) { c.principal_point_offset.y = kInfinity; });
}

}  // namespace
}  // namespace guidelight
