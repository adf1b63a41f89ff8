#include "tests/renderer/test_scenes.h"

#include <glm/gtc/matrix_transform.hpp>

namespace guidelight::testing {

SceneDescription empty_scene(int width, int height) {
  SceneDescription scene;
  scene.name = "test";
  scene.film.width = width;
  scene.film.height = height;
  scene.film.filter.kind = FilterKind::Box;
  return scene;
}

int add_diffuse(SceneDescription& scene, Color reflectance) {
  scene.bsdfs.push_back({"diffuse", 0, DiffuseBsdf{{reflectance}}});
  return static_cast<int>(scene.bsdfs.size()) - 1;
}

ShapeDescription& add_rectangle(SceneDescription& scene, const Mat4& to_world, int bsdf) {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh->uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
  ShapeDescription shape;
  shape.name = "rectangle";
  shape.geometry = MeshShape{mesh};
  shape.to_world = to_world;
  shape.bsdf = bsdf;
  return scene.shapes.emplace_back(shape);
}

ShapeDescription& add_sphere(SceneDescription& scene, Vec3 center, float radius, int bsdf) {
  ShapeDescription shape;
  shape.name = "sphere";
  shape.geometry = SphereShape{};
  shape.to_world = glm::scale(glm::translate(Mat4(1), center), Vec3(radius));
  shape.bsdf = bsdf;
  return scene.shapes.emplace_back(shape);
}

void look_at(SceneDescription& scene, Vec3 origin, Vec3 target, float fov_degrees) {
  const Vec3 forward = glm::normalize(target - origin);
  const Vec3 up = std::abs(forward.y) < 0.99f ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
  const Vec3 left = glm::normalize(glm::cross(up, forward));
  scene.camera.to_world =
      Mat4(Vec4(left, 0), Vec4(glm::cross(forward, left), 0), Vec4(forward, 0), Vec4(origin, 1));
  scene.camera.fov = fov_degrees;
}

SceneDescription room(int width, int height) {
  SceneDescription scene = empty_scene(width, height);
  const int white = add_diffuse(scene, Color(0.7f));
  const int red = add_diffuse(scene, Color(0.6f, 0.1f, 0.1f));
  const auto wall = [&](Vec3 axis, float degrees, int bsdf) {
    const Mat4 turned = glm::rotate(Mat4(1), glm::radians(degrees), axis);
    add_rectangle(scene, turned * glm::translate(Mat4(1), Vec3(0, 0, -1)), bsdf);
  };
  wall({1, 0, 0}, 0, white);
  wall({1, 0, 0}, 90, white);
  wall({1, 0, 0}, 180, white);
  wall({1, 0, 0}, 270, white);
  wall({0, 1, 0}, 90, red);
  wall({0, 1, 0}, 270, red);
  Mat4 lamp = glm::translate(Mat4(1), Vec3(0, 0.99f, 0));
  lamp = glm::rotate(lamp, glm::radians(90.0f), Vec3(1, 0, 0));
  add_rectangle(scene, glm::scale(lamp, Vec3(0.3f)), white).radiance = ColorInput{Color(10, 9, 8)};
  look_at(scene, {0, 0, 0.95f}, {0, -0.2f, -1}, 70);
  return scene;
}

std::shared_ptr<const Scene> build(SceneDescription description) {
  return Scene::build(std::make_shared<SceneDescription>(std::move(description)));
}

Film render(std::shared_ptr<const Scene> scene, uint32_t passes, int threads, uint64_t seed,
            const std::string& integrator) {
  const Camera& camera = scene->camera();
  Film film(camera.width(), camera.height(), camera.film().filter);
  const IntegratorInfo& info = find_integrator(integrator);
  const auto algorithm = info.create(scene, *info.make_settings(scene->description().hints));
  Parallel parallel(threads);
  for (uint32_t pass = 0; pass < passes; ++pass) {
    algorithm->render_pass(pass, film, {seed, &parallel, {}});
    film.finish_pass();
  }
  return film;
}

}  // namespace guidelight::testing
