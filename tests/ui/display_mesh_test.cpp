#include "ui/scout/display_mesh.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/scene/shape.h"

namespace guidelight {
namespace {

TEST(DisplayMesh, TooManyTrianglesOfInstancesBecomeBoxesTheHeaviestGroupsFirst) {
  SceneDescription scene;
  auto quad = std::make_shared<Mesh>();
  quad->positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  quad->triangles = {{0, 1, 2}, {0, 2, 3}};
  auto heavy = std::make_shared<Mesh>(*quad);
  heavy->positions = {{0, 0, 0}, {2, 0, 0}, {2, 3, 4}, {0, 3, 4}};
  for (int i = 0; i < 99; ++i) heavy->triangles.push_back({0, 1, 2});
  for (const auto& mesh : {quad, heavy}) {
    ShapeDescription shape;
    shape.geometry = MeshShape{mesh};
    scene.groups.push_back({"", 0, {shape}});
  }
  ShapeDescription copy;
  copy.to_world = glm::translate(Mat4(1), Vec3(10, 0, 0));
  for (int i = 0; i < 10; ++i) {
    copy.geometry = InstanceShape{i % 2};
    scene.shapes.push_back(copy);
  }
  const size_t all = 5 * 2 + 5 * 101;
  EXPECT_EQ(make_display_mesh(scene, all).vertices.size(), 3 * all);
  EXPECT_EQ(make_display_mesh(scene, all).boxes, 0u);
  const DisplayMesh mesh = make_display_mesh(scene, all - 1);
  EXPECT_EQ(mesh.boxes, 5u);
  EXPECT_EQ(mesh.vertices.size(), 3u * (5 * 2 + 5 * 12));
  Bounds bounds;
  for (const auto& vertex : mesh.vertices) bounds.extend(vertex.position);
  EXPECT_EQ(bounds.lower, Vec3(10, 0, 0));
  EXPECT_EQ(bounds.upper, Vec3(12, 3, 4)) << "a box is as large as what it stands for";
}

TEST(DisplayMesh, InstancesAndAnalyticShapesStandWhereTheyAre) {
  SceneDescription scene;
  ShapeGroup group;
  ShapeDescription ball;
  ball.geometry = SphereShape{};
  ball.to_world = glm::translate(Mat4(1), Vec3(10, 0, 0));
  group.shapes.push_back(ball);
  scene.groups.push_back(group);
  ShapeDescription copy;
  copy.geometry = InstanceShape{0};
  copy.to_world = glm::translate(Mat4(1), Vec3(0, 5, 0));
  scene.shapes.push_back(copy);

  const DisplayMesh mesh = make_display_mesh(scene);
  ASSERT_GT(mesh.vertices.size(), 300u);
  EXPECT_EQ(mesh.vertices.size() % 3, 0u);
  for (const auto& vertex : mesh.vertices) {
    EXPECT_NEAR(glm::length(vertex.position - Vec3(10, 5, 0)), 1, 1e-4f);
  }
}

TEST(DisplayMesh, LightsAndGlassAreMarked) {
  SceneDescription scene;
  scene.bsdfs.push_back({"glass", 0, DielectricBsdf{}});
  ShapeDescription disk;
  disk.geometry = DiskShape{};
  disk.bsdf = 0;
  scene.shapes.push_back(disk);
  disk.radiance = ColorInput{};
  scene.shapes.push_back(disk);
  const DisplayMesh mesh = make_display_mesh(scene);
  EXPECT_EQ(mesh.vertices.front().color >> 24, 0u);
  EXPECT_EQ(mesh.vertices.back().color >> 24, 255u);
}

TEST(DisplayMaterial, TakesTheMeanOfAPicture) {
  SceneDescription scene;
  auto image = std::make_shared<Image>(2, 1, 3);
  for (int i = 0; i < 3; ++i) image->pixel(0, 0)[i] = 1;
  BitmapTexture bitmap;
  bitmap.image = image;
  scene.textures.push_back({"half", 0, bitmap});
  DiffuseBsdf diffuse;
  diffuse.reflectance = {Color(1), 0};
  scene.bsdfs.push_back({"diffuse", 0, diffuse});
  EXPECT_NEAR(display_material(scene, 0).color.r, 0.735f, 0.01f) << "0.5 in sRGB";
}

}  // namespace
}  // namespace guidelight
