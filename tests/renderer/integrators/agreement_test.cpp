// All integrators show the same picture: independent runs of each against independent runs of the
// path tracer, by Welch's t-test of the means of 32×32 blocks and of the whole picture. The seeds
// are fixed; a correct renderer would fail any of the tests of this file with probability 1e-3.

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/io/scene_file.h"
#include "tests/renderer/test_scenes.h"
#include "tests/statistics/hypothesis_tests.h"

namespace guidelight {
namespace {

using statistics::Moments;

constexpr int kSide = 64;
constexpr int kBlock = 32;
constexpr int kRuns = 10;
constexpr double kFalseAlarms = 1e-3;

/// Means over blocks, and last over the picture, of one run.
std::vector<double> block_means(const Film& film) {
  const Image picture = film.develop(Layer::Beauty);
  std::vector<double> means;
  double total = 0;
  for (int y0 = 0; y0 < kSide; y0 += kBlock) {
    for (int x0 = 0; x0 < kSide; x0 += kBlock) {
      double sum = 0;
      for (int y = y0; y < y0 + kBlock; ++y) {
        for (int x = x0; x < x0 + kBlock; ++x) sum += luminance(picture.color(x, y));
      }
      means.push_back(sum / (kBlock * kBlock));
      total += sum;
    }
  }
  means.push_back(total / (kSide * kSide));
  return means;
}

struct Method {
  std::string name;        // of the integrator
  std::string parameters;  // key=value,key=value
  uint32_t passes;
};

/// What independent runs of a method say about each block.
std::vector<Moments> measure(std::shared_ptr<const Scene> scene, const Method& method, int runs) {
  const IntegratorInfo& info = find_integrator(method.name);
  const auto settings = info.make_settings(scene->description().hints);
  for (size_t begin = 0; begin < method.parameters.size();) {
    const size_t equals = method.parameters.find('=', begin);
    const size_t end = std::min(method.parameters.find(',', equals), method.parameters.size());
    set_parameter(*settings, method.parameters.substr(begin, equals - begin),
                  method.parameters.substr(equals + 1, end - equals - 1));
    begin = end + 1;
  }
  std::vector<Moments> blocks(kSide / kBlock * (kSide / kBlock) + 1);
  Parallel parallel(2);
  const FilterSettings& filter = scene->camera().film().filter;
  for (int run = 0; run < runs; ++run) {
    Film film(kSide, kSide, filter);
    const auto integrator = info.create(scene, *settings);
    for (uint32_t pass = 0; pass < method.passes; ++pass) {
      integrator->render_pass(pass, film, {1000u + static_cast<uint64_t>(run), &parallel, {}});
    }
    EXPECT_EQ(film.rejected(), 0u);
    const std::vector<double> means = block_means(film);
    for (size_t i = 0; i < means.size(); ++i) blocks[i].add(means[i]);
  }
  return blocks;
}

// -- Scenes.

SceneDescription file(const std::string& name) {
  SceneDescription scene =
      read_scene(std::string(GUIDELIGHT_SOURCE_DIR "/scenes/") + name + "/scene.xml");
  scene.film.width = scene.film.height = kSide;
  scene.film.crop_width = scene.film.crop_height = 0;
  scene.hints.max_depth = 6;
  return scene;
}

SceneDescription room() {
  SceneDescription scene = testing::room(kSide, kSide);
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
  SceneDescription scene = room();
  scene.shapes.pop_back();
  std::erase_if(scene.shapes, [](const ShapeDescription& shape) {
    return (shape.to_world * Vec4(0, 0, 0, 1)).y > 0.9f;
  });
  return scene;
}

SceneDescription environment_room() {
  SceneDescription scene = open_room();
  add_emitter(scene, ConstantEmitter{Color(1, 1.2f, 1.5f)});
  testing::add_sphere(scene, {0.3f, -0.6f, -0.3f}, 0.4f, testing::add_diffuse(scene, Color(0.8f)));
  return scene;
}

SceneDescription sunny_room() {
  SceneDescription scene = open_room();
  add_emitter(scene, DirectionalEmitter{{0.3f, -1, -0.4f}, Color(3, 2.8f, 2.5f)});
  return scene;
}

SceneDescription point_light_room() {
  SceneDescription scene = room();
  scene.shapes.pop_back();
  add_emitter(scene, PointEmitter{{0.2f, 0.6f, 0}, Color(1, 0.9f, 0.8f)});
  return scene;
}

SceneDescription frosted_room() {
  SceneDescription scene = room();
  DielectricBsdf frosted;
  frosted.alpha_u = frosted.alpha_v = FloatInput{0.35f};
  testing::add_sphere(scene, {0, -0.5f, -0.3f}, 0.45f, add_bsdf(scene, frosted));
  return scene;
}

int add_texture(SceneDescription& scene, Image image) {
  BitmapTexture texture;
  texture.image = std::make_shared<const Image>(std::move(image));
  scene.textures.push_back({.name = "", .line = 0, .model = texture});
  return static_cast<int>(scene.textures.size()) - 1;
}

SceneDescription textured_light_room() {
  SceneDescription scene = room();
  Image pattern(4, 4, 3);
  for (int i = 0; i < 48; ++i) pattern.data()[i] = 0.5f * static_cast<float>(i * i % 5);
  const int texture = add_texture(scene, pattern);
  scene.shapes.back().radiance = ColorInput{Color(10), texture};
  return scene;
}

SceneDescription normal_mapped_room() {
  SceneDescription scene = room();
  Image waves(16, 16, 3);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      const Vec3 n = glm::normalize(Vec3(0.5f * std::sin(0.8f * x), 0.5f * std::cos(1.1f * y), 1));
      for (int c = 0; c < 3; ++c) waves.pixel(x, y)[c] = 0.5f + 0.5f * n[c];
    }
  }
  const int texture = add_texture(scene, waves);
  const int plain = testing::add_diffuse(scene, Color(0.7f));
  const int mapped = add_bsdf(scene, NormalMapBsdf{texture, plain});
  for (ShapeDescription& shape : scene.shapes) {
    if (!shape.radiance) shape.bsdf = mapped;
  }
  return scene;
}

SceneDescription instanced_room() {
  SceneDescription scene = room();
  SceneDescription parts = testing::empty_scene();
  ShapeGroup group;
  testing::add_sphere(parts, {0, 0, 0}, 1);
  testing::add_rectangle(parts, glm::translate(Mat4(1), Vec3(0, 1.5f, 0)));
  group.shapes = parts.shapes;
  for (ShapeDescription& shape : group.shapes) {
    shape.bsdf = testing::add_diffuse(scene, Color(0.6f, 0.7f, 0.3f));
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
  SceneDescription scene = room();
  scene.camera.model = CameraModel::ThinLens;
  scene.camera.aperture_radius = 0.08f;
  scene.camera.focus_distance = 1.2f;
  return scene;
}

struct SceneCase {
  std::string name;
  SceneDescription (*make)();
  bool is_diffuse;  // light tracing sees all of it
};

const std::vector<SceneCase>& scenes() {
  static const std::vector<SceneCase> list = {
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

/// Methods without bias, and those whose radius is so small that their bias is far below the noise.
std::vector<Method> methods(const SceneCase& scene) {
  std::vector<Method> list = {
      {"bdpt", "", 6},
      {"bdpt", "connect_to=random_vertices", 6},
      {"vcm", "scene_radius=0.3,alpha=1", 6},
      {"vcm", "scene_radius=0.3,alpha=1,merge_direct=true", 6},
      {"vcm", "lean=true,radius_from=pixel,pixel_radius=1", 6},
      {"bpm", "scene_radius=0.5,alpha=1,light_paths=2", 6},
      {"bdpm", "scene_radius=1,neighbors=10,light_paths=2", 6},
      {"pppm", "scene_radius=0.5,alpha=1,light_paths=2", 6},
      {"ppm", "scene_radius=0.5,light_paths=2", 6},
      {"sppm", "scene_radius=0.5,light_paths=2", 6},
      {"photon_map", "light_paths=30000,neighbors=20,gather_rays=50", 3},
      {"photon_map", "light_paths=30000,neighbors=20,gather_rays=4,irradiance_cache=false", 3},
  };
  if (scene.is_diffuse) {
    list.push_back({"light", "", 8});
    list.push_back({"bdpt", "light_paths=0.5,emission=false", 6});
  }
  return list;
}

class Agreement : public ::testing::TestWithParam<SceneCase> {};

TEST_P(Agreement, WithThePathTracer) {
  const auto scene = testing::build(GetParam().make());
  const std::vector<Moments> expected = measure(scene, {"path", "", 32}, kRuns);
  const std::vector<Method> tried = methods(GetParam());
  const double level =
      statistics::sidak_level(kFalseAlarms, scenes().size() * tried.size() * expected.size());
  for (const Method& method : tried) {
    const std::vector<Moments> found = measure(scene, method, kRuns);
    for (size_t i = 0; i < found.size(); ++i) {
      EXPECT_GT(statistics::welch_test(found[i], expected[i]), level)
          << method.name << " " << method.parameters << ", block " << i << ": " << found[i].mean()
          << " +- " << found[i].standard_error() << " against " << expected[i].mean() << " +- "
          << expected[i].standard_error();
    }
    // A test that compares noise with noise proves nothing.
    EXPECT_LT(found.back().standard_error(), 0.02 * found.back().mean()) << method.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Agreement, ::testing::ValuesIn(scenes()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace guidelight
