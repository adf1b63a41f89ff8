#include "ui/camera_controller.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace guidelight {
namespace {

/// At (0, 0, 10), looking along -z with +y up: local +z is -z of the world, local +x is -x.
Camera camera_on_z(CameraModel model = CameraModel::Perspective, bool mirrored = false) {
  CameraDescription description;
  description.model = model;
  description.fov = 40;
  description.to_world = glm::translate(Mat4(1), Vec3(0, 0, 10)) *
                         glm::rotate(Mat4(1), kPi, Vec3(0, 1, 0)) *
                         glm::scale(Mat4(1), Vec3(mirrored ? -1 : 1, 1, 1));
  FilmDescription film;
  film.width = 200;
  film.height = 100;
  return Camera(description, film);
}

/// Raster position of a point in the picture of the moved camera.
Vec2 raster_of(const Camera& camera, const CameraController& controller, Vec3 point) {
  const Camera moved = camera.with_transform(controller.to_world());
  return moved.connect(point, Vec2(0.5f)).value().raster;
}

void expect_near(Vec3 a, Vec3 b, float tolerance = 1e-4f) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(CameraController, TakesOverTheAxesOfTheCamera) {
  const CameraController controller(camera_on_z(), 10);
  expect_near(controller.position(), {0, 0, 10});
  expect_near(controller.forward(), {0, 0, -1});
  expect_near(controller.right(), {1, 0, 0});
  expect_near(controller.up(), {0, 1, 0});
  expect_near(controller.pivot(), {0, 0, 0});
}

TEST(CameraController, OrbitKeepsThePivotInTheMiddleAndTheDistance) {
  const Camera camera = camera_on_z();
  CameraController controller(camera, 10);
  for (int i = 0; i < 20; ++i) controller.orbit({0.17f, i < 10 ? 0.05f : -0.08f});
  const Vec2 middle = raster_of(camera, controller, Vec3(0));
  EXPECT_NEAR(middle.x, 100, 0.01f);
  EXPECT_NEAR(middle.y, 50, 0.01f);
  EXPECT_NEAR(glm::length(controller.position()), 10, 1e-3f);
}

TEST(CameraController, WhatIsDraggedFollowsTheMouse) {
  for (const bool mirrored : {false, true}) {
    const Camera camera = camera_on_z(CameraModel::Perspective, mirrored);
    const Vec3 near_point(0, 0, 1);  // between the camera and the pivot
    CameraController controller(camera, 10);
    controller.orbit({0.1f, 0});
    EXPECT_GT(raster_of(camera, controller, near_point).x, 100.5f) << "mirrored " << mirrored;
    controller = CameraController(camera, 10);
    controller.orbit({0, 0.1f});
    EXPECT_GT(raster_of(camera, controller, near_point).y, 50.5f) << "mirrored " << mirrored;
  }
}

TEST(CameraController, LookingRightMovesThingsLeftAndKeepsThePosition) {
  for (const bool mirrored : {false, true}) {
    const Camera camera = camera_on_z(CameraModel::Perspective, mirrored);
    CameraController controller(camera, 10);
    controller.look({0.1f, 0.05f});
    const Vec2 raster = raster_of(camera, controller, Vec3(0));
    EXPECT_LT(raster.x, 99) << "mirrored " << mirrored;
    EXPECT_LT(raster.y, 49) << "mirrored " << mirrored;
    expect_near(controller.position(), {0, 0, 10});
  }
}

TEST(CameraController, TurnsNeverPassThePoles) {
  CameraController controller(camera_on_z(), 10);
  for (const float step : {1.0f, -1.0f}) {
    for (int i = 0; i < 10; ++i) controller.orbit({0.3f, step});
    EXPECT_GT(controller.up().y, 0.01f);
    EXPECT_LT(std::abs(controller.forward().y), 0.9999f);
    EXPECT_NEAR(controller.right().y, 0, 1e-4f) << "the horizon stays level";
  }
}

TEST(CameraController, PanMovesThePivotsPlaneWithTheMouse) {
  for (const CameraModel model : {CameraModel::Perspective, CameraModel::Orthographic}) {
    const Camera camera = camera_on_z(model);
    CameraController controller(camera, 10);
    controller.pan({0.2f, -0.1f});
    const Vec2 raster = raster_of(camera, controller, Vec3(0));
    EXPECT_NEAR(raster.x, 100 + 0.2f * 100, 0.1f);
    EXPECT_NEAR(raster.y, 50 - 0.1f * 100, 0.1f);
  }
}

TEST(CameraController, PanFollowsTheMouseInAnEnlargedOrthographicView) {
  const Camera plain = camera_on_z(CameraModel::Orthographic);
  const Camera camera =
      plain.with_transform(plain.description().to_world * glm::scale(Mat4(1), Vec3(3)));
  CameraController controller(camera, 10);
  controller.pan({0.2f, -0.1f});
  const Vec2 raster = raster_of(camera, controller, Vec3(0));
  EXPECT_NEAR(raster.x, 100 + 0.2f * 100, 0.1f);
  EXPECT_NEAR(raster.y, 50 - 0.1f * 100, 0.1f);
}

TEST(CameraController, DollyNearsButNeverReachesThePivot) {
  CameraController controller(camera_on_z(), 10);
  controller.dolly(1);
  expect_near(controller.position(), {0, 0, 9});
  for (int i = 0; i < 50; ++i) controller.dolly(1);
  EXPECT_GT(controller.position().z, 0);
  expect_near(controller.pivot(), {0, 0, 0});
}

TEST(CameraController, DollyEnlargesAnOrthographicView) {
  const Camera camera = camera_on_z(CameraModel::Orthographic);
  CameraController controller(camera, 10);
  const float before = raster_of(camera, controller, Vec3(0.2f, 0, 0)).x - 100;
  controller.dolly(2);
  const float after = raster_of(camera, controller, Vec3(0.2f, 0, 0)).x - 100;
  EXPECT_NEAR(after / before, 1 / 0.81f, 1e-3f);
}

TEST(CameraController, FlyMovesAlongItsOwnAxes) {
  CameraController controller(camera_on_z(), 10);
  controller.fly({1, 2, 3});
  expect_near(controller.position(), {1, 2, 7});
}

TEST(CameraController, FrameShowsAllOfASphereAndFillsThePicture) {
  for (const CameraModel model : {CameraModel::Perspective, CameraModel::Orthographic}) {
    const Camera camera = camera_on_z(model);
    CameraController controller(camera, 10);
    controller.orbit({0.7f, 0.3f});
    Bounds bounds;
    bounds.extend(Vec3(3, 4, 5) - 2.0f / std::sqrt(3.0f));
    bounds.extend(Vec3(3, 4, 5) + 2.0f / std::sqrt(3.0f));  // radius 2
    controller.frame(bounds);
    const Vec2 center = raster_of(camera, controller, bounds.center());
    EXPECT_NEAR(center.x, 100, 0.01f);
    EXPECT_NEAR(center.y, 50, 0.01f);
    // The upper side of the sphere's outline touches the upper edge of the picture.
    const float distance = glm::length(bounds.center() - controller.position());
    const float angle = model == CameraModel::Perspective ? std::asin(2 / distance) : 0;
    const Vec3 outward = std::cos(angle) * controller.up() - std::sin(angle) * controller.forward();
    const Vec3 touching = bounds.center() + 1.998f * outward;
    EXPECT_NEAR(raster_of(camera, controller, touching).y, 0, 0.3f);
  }
}

TEST(CameraController, FramesNothingWithoutBounds) {
  CameraController controller(camera_on_z(), 10);
  controller.frame(Bounds());
  expect_near(controller.position(), {0, 0, 10});
}

TEST(CameraController, NoAmountOfDollyingMakesTheCameraUnusable) {
  for (const CameraModel model : {CameraModel::Perspective, CameraModel::Orthographic}) {
    const Camera camera = camera_on_z(model);
    for (const float step : {1.0f, -1.0f}) {
      CameraController controller(camera, 10, 5);
      for (int i = 0; i < 3000; ++i) controller.dolly(step);
      const Camera moved = camera.with_transform(controller.to_world());
      EXPECT_LT(glm::length(moved.position()), 1e6f);
      EXPECT_GT(moved.pixel_size_at_unit_distance(), 1e-9f);
      EXPECT_LT(moved.pixel_size_at_unit_distance(), 1e6f);
      for (int i = 0; i < 3000; ++i) controller.dolly(-step);
      for (int i = 0; i < 40; ++i) controller.dolly(step);
      EXPECT_TRUE(is_finite(controller.pivot())) << "there is a way back";
    }
  }
}

TEST(CameraController, ACameraFarAwayDolliesNoFartherAndComesBack) {
  CameraController controller(camera_on_z(), 1e6f, 1);
  controller.dolly(-1);
  EXPECT_FLOAT_EQ(controller.pivot_distance(), 1e6f);
  controller.dolly(1);
  EXPECT_FLOAT_EQ(controller.pivot_distance(), 0.9e6f);
}

TEST(CameraController, StaysWhereItIsRatherThanWhereNoCameraCanBe) {
  CameraController controller(camera_on_z(), 10);
  const Mat4 before = controller.to_world();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  controller.move([&](CameraController& camera) { camera.fly({nan, 0, 0}); });
  controller.move([](CameraController& camera) { camera.fly({0, 0, 1e12f}); });
  controller.move([](CameraController& camera) { camera.set_to_world(Mat4(0.0f)); });
  EXPECT_EQ(controller.to_world(), before);
  controller.move([](CameraController& camera) { camera.fly({0, 0, 1}); });
  expect_near(controller.position(), {0, 0, 9});
}

TEST(CameraController, KeepsAMirroredCameraMirrored) {
  const Camera camera = camera_on_z(CameraModel::Perspective, true);
  CameraController controller(camera, 10);
  controller.orbit({0.4f, 0.2f});
  controller.look({0.1f, 0.1f});
  EXPECT_LT(glm::determinant(Mat3(controller.to_world())) *
                glm::determinant(Mat3(camera_on_z().description().to_world)),
            0);
}

}  // namespace
}  // namespace guidelight
