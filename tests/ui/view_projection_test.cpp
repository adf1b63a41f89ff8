#include "ui/view_projection.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace guidelight {
namespace {

Camera turned_camera(CameraModel model, bool mirrored) {
  CameraDescription description;
  description.model = model;
  description.fov = 55;
  description.to_world = glm::translate(Mat4(1), Vec3(1, 2, 3)) *
                         glm::rotate(Mat4(1), 0.7f, glm::normalize(Vec3(1, 2, -0.5f))) *
                         glm::scale(Mat4(1), Vec3(mirrored ? -1 : 1, 1, 1));
  FilmDescription film;
  film.width = 320;
  film.height = 200;
  return Camera(description, film);
}

class AllCameras : public ::testing::TestWithParam<std::tuple<CameraModel, bool>> {
 protected:
  const Camera camera =
      turned_camera(std::get<CameraModel>(GetParam()), std::get<bool>(GetParam()));
  const Vec2 origin{40, 30};
  const float scale = 2;
  const ViewProjection projection{camera, origin, scale, 0.01f, 100};

  /// What the camera sees at a raster position, some way off.
  Vec3 point_at(Vec2 raster, float distance) const {
    const Ray ray = camera.sample_ray(raster, Vec2(0.5f)).ray;
    return ray.origin + distance * ray.direction;
  }
};

TEST_P(AllCameras, PointsAreWhereTheCameraSeesThem) {
  for (const Vec2 raster : {Vec2(0, 0), Vec2(160, 100), Vec2(300, 20), Vec2(10, 190)}) {
    const auto screen = projection.to_screen(point_at(raster, 4));
    ASSERT_TRUE(screen);
    EXPECT_NEAR(screen->x, origin.x + scale * raster.x, 0.02f);
    EXPECT_NEAR(screen->y, origin.y + scale * raster.y, 0.02f);
  }
}

TEST_P(AllCameras, RaysGoThroughThePointsOnTheScreen) {
  const Vec3 point = point_at({77, 120}, 3);
  const Ray ray = projection.ray_through(*projection.to_screen(point));
  const Vec3 towards = point - ray.origin;
  EXPECT_LT(glm::length(towards - glm::dot(towards, ray.direction) * ray.direction), 1e-4f);
  EXPECT_GT(glm::dot(towards, ray.direction), 0);
}

TEST_P(AllCameras, OpenGlAgrees) {
  const Vec2 corner(10, 20), size(700, 500);
  const Mat4 matrix = projection.clip_from_world(corner, size);
  for (const float distance : {0.5f, 5.0f, 50.0f}) {
    const Vec3 point = point_at({250, 60}, distance);
    const Vec4 clip = matrix * Vec4(point, 1);
    const Vec2 screen = corner + (Vec2(clip) / clip.w * 0.5f + 0.5f) * size;
    const Vec2 expected = *projection.to_screen(point);
    EXPECT_NEAR(screen.x, expected.x, 0.05f);
    EXPECT_NEAR(screen.y, expected.y, 0.05f);
    EXPECT_LT(std::abs(clip.z / clip.w), 1);
  }
}

TEST_P(AllCameras, LinesEndAtTheEye) {
  const Vec3 seen = point_at({160, 100}, 2);
  const Vec3 behind = camera.position() - 2.0f * camera.forward();
  const auto line = projection.to_screen(seen, behind);
  ASSERT_TRUE(line);
  EXPECT_EQ(line->from, 0);
  EXPECT_GT(line->to, 0.3f);
  EXPECT_LT(line->to, 0.7f);
  EXPECT_FALSE(projection.to_screen(behind, behind - camera.forward()));
}

std::string camera_name(const ::testing::TestParamInfo<AllCameras::ParamType>& test) {
  const auto& [model, mirrored] = test.param;
  const std::string name = model == CameraModel::Perspective ? "perspective" : "orthographic";
  return name + (mirrored ? "_mirrored" : "");
}

INSTANTIATE_TEST_SUITE_P(Models, AllCameras,
                         ::testing::Combine(::testing::Values(CameraModel::Perspective,
                                                              CameraModel::Orthographic),
                                            ::testing::Bool()),
                         camera_name);

}  // namespace
}  // namespace guidelight
