#include <gtest/gtest.h>

#include <filesystem>

#include "renderer/io/image_file.h"
#include "renderer/io/scene_file.h"

/// Scenes that others made, where they are at hand.
namespace guidelight::test {
namespace {

namespace fs = std::filesystem;

class SharedScenes : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(folder_)) GTEST_SKIP() << "the shared scenes are not beside the checkout";
  }

  SceneDescription read(const std::string& name) { return read_scene((folder_ / name).string()); }

  static size_t triangles(const SceneDescription& scene) {
    size_t count = 0;
    for (const ShapeDescription& shape : scene.shapes) {
      const auto* mesh = std::get_if<MeshShape>(&shape.geometry);
      if (mesh) count += mesh->mesh->triangles.size();
    }
    return count;
  }

  const fs::path folder_ = GUIDELIGHT_SHARED_SCENES;
};

TEST_F(SharedScenes, AllOpenWithoutAnError) {
  int opened = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_)) {
    const std::string extension = entry.path().extension().string();
    const std::string parent = entry.path().parent_path().filename().string();
    if (extension != ".xml" && extension != ".gltf" && extension != ".glb") continue;
    if (parent == "include" || parent == "fragments") continue;  // parts of other scenes
    SCOPED_TRACE(entry.path());
    SceneDescription scene;
    ASSERT_NO_THROW(scene = read_scene(entry.path().string()));
    EXPECT_FALSE(scene.shapes.empty());
    EXPECT_LE(scene.warnings.size(), 3u);
    for (size_t i = 0; i < scene.bsdfs.size(); ++i) {
      if (const auto* sides = std::get_if<TwoSidedBsdf>(&scene.bsdfs[i].model)) {
        EXPECT_LT(sides->front, static_cast<int>(i));
      }
    }
    ++opened;
  }
  EXPECT_GE(opened, 50);
}

TEST_F(SharedScenes, AllPicturesOpen) {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".exr" || extension == ".png" || extension == ".jpg" || extension == ".hdr") {
      EXPECT_NO_THROW(read_image(entry.path().string())) << entry.path();
    }
  }
}

TEST_F(SharedScenes, CoffeeSaysTheSameInBothDialects) {
  const SceneDescription old = read("bitterli/coffee/scene_v0.6.xml");
  const SceneDescription recent = read("bitterli/coffee/scene_v3.xml");
  EXPECT_EQ(triangles(old), 235271u);  // the sum of the face counts in its files
  EXPECT_EQ(triangles(recent), 235271u);
  EXPECT_EQ(old.bsdfs.size(), recent.bsdfs.size());
  EXPECT_EQ(old.hints.max_depth, 17);
  EXPECT_EQ(old.film.width, 800);
  EXPECT_EQ(old.film.filter.kind, FilterKind::Tent);
  for (int i = 0; i < 16; ++i) {
    EXPECT_FLOAT_EQ(old.camera.to_world[i / 4][i % 4], recent.camera.to_world[i / 4][i % 4]);
  }
}

TEST_F(SharedScenes, SerializedAndPlyMeshesAreTheSame) {
  // Both were converted from one source.
  for (const auto& [serialized, ply] : std::vector<std::pair<std::string, std::string>>{
           {"mitsuba06/torus-dpt/torus.xml", "mitsuba06/torus-dpt/torus_ply.xml"},
           {"mitsuba06/veach-lamp/scene.xml", "mitsuba06/veach-lamp/scene_ply.xml"}}) {
    const SceneDescription a = read(serialized), b = read(ply);
    ASSERT_EQ(a.shapes.size(), b.shapes.size());
    EXPECT_EQ(triangles(a), triangles(b));
    for (size_t i = 0; i < a.shapes.size(); ++i) {
      const Mesh& first = *std::get<MeshShape>(a.shapes[i].geometry).mesh;
      const Mesh& second = *std::get<MeshShape>(b.shapes[i].geometry).mesh;
      ASSERT_EQ(first.positions.size(), second.positions.size());
      EXPECT_LT(glm::length(first.positions.back() - second.positions.back()), 1e-4f);
    }
  }
}

TEST_F(SharedScenes, StaircaseHasAMediumAndTextures) {
  const SceneDescription scene = read("bitterli/staircase2/scene_v0.6.xml");
  EXPECT_EQ(scene.media.size(), 1u);
  EXPECT_EQ(scene.textures.size(), 3u);
  EXPECT_TRUE(scene.warnings.empty());
}

}  // namespace
}  // namespace guidelight::test
