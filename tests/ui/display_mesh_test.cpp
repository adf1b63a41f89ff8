#include "ui/scout/display_mesh.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace guidelight {
namespace {

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
