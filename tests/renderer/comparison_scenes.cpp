#include "tests/renderer/comparison_scenes.h"

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/io/scene_file.h"
#include "tests/renderer/test_scenes.h"

namespace guidelight::testing {

namespace {

SceneDescription file(const std::string& name) {
  SceneDescription scene =
      read_scene(std::string(GUIDELIGHT_SOURCE_DIR "/scenes/") + name + "/scene.xml");
  scene.film.width = scene.film.height = kComparisonSide;
  scene.film.crop_width = scene.film.crop_height = 0;
  scene.hints.max_depth = 6;
  return scene;
}

SceneDescription plain_room() {
  SceneDescription scene = room(kComparisonSide, kComparisonSide);
  scene.hints.max_depth = 6;
  return scene;
}

template <typename Model>
int add_bsdf(SceneDescription& scene, Model model) {
  scene.bsdfs.push_back({.name = "", .line = 0, .model = model});
  return static_cast<int>(scene.bsdfs.size()) - 1;
}

template <typename Model>
void add_emitter(SceneDescription& scene, Model model) {
  scene.emitters.push_back({.name = "", .line = 0, .model = model});
}

/// A room whose ceiling is gone and whose lamp is out.
SceneDescription open_room() {
  SceneDescription scene = plain_room();
  scene.shapes.pop_back();
  std::erase_if(scene.shapes, [](const ShapeDescription& shape) {
    return (shape.to_world * Vec4(0, 0, 0, 1)).y > 0.9f;
  });
  return scene;
}

SceneDescription environment_room() {
  SceneDescription scene = open_room();
  add_emitter(scene, ConstantEmitter{Color(1, 1.2f, 1.5f)});
  add_sphere(scene, {0.3f, -0.6f, -0.3f}, 0.4f, add_diffuse(scene, Color(0.8f)));
  return scene;
}

SceneDescription sunny_room() {
  SceneDescription scene = open_room();
  add_emitter(scene, DirectionalEmitter{{0.3f, -1, -0.4f}, Color(3, 2.8f, 2.5f)});
  return scene;
}

SceneDescription point_light_room() {
  SceneDescription scene = plain_room();
  scene.shapes.pop_back();
  add_emitter(scene, PointEmitter{{0.2f, 0.6f, 0}, Color(1, 0.9f, 0.8f)});
  return scene;
}

SceneDescription frosted_room() {
  SceneDescription scene = plain_room();
  DielectricBsdf frosted;
  frosted.alpha_u = frosted.alpha_v = FloatInput{0.35f};
  add_sphere(scene, {0, -0.5f, -0.3f}, 0.45f, add_bsdf(scene, frosted));
  return scene;
}

int add_texture(SceneDescription& scene, Image image) {
  BitmapTexture texture;
  texture.image = std::make_shared<const Image>(std::move(image));
  scene.textures.push_back({.name = "", .line = 0, .model = texture});
  return static_cast<int>(scene.textures.size()) - 1;
}

SceneDescription textured_light_room() {
  SceneDescription scene = plain_room();
  Image pattern(4, 4, 3);
  for (int i = 0; i < 48; ++i) pattern.data()[i] = 0.5f * static_cast<float>(i * i % 5);
  const int texture = add_texture(scene, pattern);
  scene.shapes.back().radiance = ColorInput{Color(10), texture};
  scene.film.filter = {.kind = FilterKind::Gaussian, .stddev = 1.5f};  // far beyond the edges
  return scene;
}

SceneDescription normal_mapped_room() {
  SceneDescription scene = plain_room();
  Image waves(16, 16, 3);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      const Vec3 n = glm::normalize(Vec3(0.5f * std::sin(0.8f * x), 0.5f * std::cos(1.1f * y), 1));
      for (int c = 0; c < 3; ++c) waves.pixel(x, y)[c] = 0.5f + 0.5f * n[c];
    }
  }
  const int texture = add_texture(scene, waves);
  const int plain = add_diffuse(scene, Color(0.7f));
  const int mapped = add_bsdf(scene, NormalMapBsdf{texture, plain});
  for (ShapeDescription& shape : scene.shapes) {
    if (!shape.radiance) shape.bsdf = mapped;
  }
  return scene;
}

SceneDescription instanced_room() {
  SceneDescription scene = plain_room();
  SceneDescription parts = empty_scene();
  ShapeGroup group;
  add_sphere(parts, {0, 0, 0}, 1);
  add_rectangle(parts, glm::translate(Mat4(1), Vec3(0, 1.5f, 0)));
  group.shapes = parts.shapes;
  for (ShapeDescription& shape : group.shapes) {
    shape.bsdf = add_diffuse(scene, Color(0.6f, 0.7f, 0.3f));
  }
  scene.groups.push_back(group);
  for (const float x : {-0.4f, 0.4f}) {
    ShapeDescription instance;
    instance.geometry = InstanceShape{0};
    instance.to_world = glm::translate(Mat4(1), Vec3(x, -0.5f, -0.4f)) *
                        glm::rotate(Mat4(1), x, Vec3(0, 0, 1)) *
                        glm::scale(Mat4(1), Vec3(0.3f, 0.15f, 0.2f));
    scene.shapes.insert(scene.shapes.begin(), instance);
  }
  return scene;
}

SceneDescription thin_lens_room() {
  SceneDescription scene = plain_room();
  scene.camera.model = CameraModel::ThinLens;
  scene.camera.aperture_radius = 0.08f;
  scene.camera.focus_distance = 1.2f;
  return scene;
}

}  // namespace

const std::vector<ComparisonScene>& comparison_scenes() {
  static const std::vector<ComparisonScene> list = {
      {"cornell_box", [] { return file("cornell"); }, true},
      {"mirror_glass_box", [] { return file("mirror-glass-box"); }, false},
      {"environment", environment_room, true},
      {"sun", sunny_room, true},
      {"point_light", point_light_room, true},
      {"rough_dielectric", frosted_room, true},
      {"textured_light", textured_light_room, true},
      {"normal_map", normal_mapped_room, true},
      {"instances", instanced_room, true},
      {"thin_lens", thin_lens_room, true},
  };
  return list;
}

std::vector<ComparisonScene> comparison_scenes(const std::set<std::string>& names) {
  std::vector<ComparisonScene> some;
  for (const ComparisonScene& scene : comparison_scenes()) {
    if (names.count(scene.name)) some.push_back(scene);
  }
  return some;
}

}  // namespace guidelight::testing
