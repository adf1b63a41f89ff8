// The footprint of a camera ray against rays that are traced beside it.

#include "renderer/transport/ray_footprint.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/scene/bsdf/scattering.h"
#include "renderer/transport/subpath.h"
#include "tests/renderer/test_scenes.h"

namespace guidelight {
namespace {

/// Where a ray ends that goes through specular surfaces only.
struct End {
  Vec3 position;
  Vec3 direction;  // of the last segment
  int bounces = 0;
  float length = 0;
};

/// Follows a ray through mirrors and into and out of glass.
std::optional<End> follow(const Scene& scene, Ray ray, RayFootprint* footprint) {
  End end;
  Vec3 origin = ray.origin;
  for (;;) {
    const Hit hit = scene.intersect(ray);
    if (!hit.valid()) return std::nullopt;
    PathVertex vertex{};
    vertex.point = scene.surface_point(ray, hit);
    vertex.hit = hit;
    vertex.wo = -ray.direction;
    if (footprint) footprint->arrive(scene, origin, vertex);
    end.position = vertex.point.position;
    end.direction = ray.direction;
    end.length += glm::distance(origin, end.position);
    if (vertex.is_connectible()) return end;
    const Scattering scattering(vertex.point, vertex.wo, TransportMode::Radiance);
    auto event = scattering.specular(kLobeDeltaTransmission);
    if (!event) event = scattering.specular(kLobeDeltaReflection);
    if (!event) return std::nullopt;
    ++end.bounces;
    origin = end.position;
    ray = vertex.point.spawn_ray(event->wi);
  }
}

/// The same by the differences of rays that leave the lens in directions beside that of `ray`.
std::optional<float> spread_by_differences(const Scene& scene, const Ray& ray, const End& end) {
  constexpr float kStep = 1e-3f;
  const Frame frame = Frame::from_normal(ray.direction);
  Vec3 change[2];
  for (int i = 0; i < 2; ++i) {
    const Vec3 step = kStep * (i == 0 ? frame.s : frame.t);
    Vec3 across[2];
    for (int side = 0; side < 2; ++side) {
      Ray beside = ray;
      beside.direction = glm::normalize(ray.direction + (side == 0 ? step : -step));
      const auto other = follow(scene, beside, nullptr);
      if (!other || other->bounces != end.bounces) return std::nullopt;
      const Vec3 away = other->position - end.position;
      across[side] = away - other->direction * (glm::dot(away, end.direction) /
                                                glm::dot(other->direction, end.direction));
    }
    change[i] = (across[0] - across[1]) / (2 * kStep);
  }
  return std::sqrt(glm::length(glm::cross(change[0], change[1])));
}

/// A finely faceted ball that is shaded as if it were round.
ShapeDescription smooth_ball() {
  constexpr int kRows = 16, kColumns = 32;
  auto mesh = std::make_shared<Mesh>();
  for (int row = 0; row <= kRows; ++row) {
    for (int column = 0; column <= kColumns; ++column) {
      const float theta = kPi * static_cast<float>(row) / kRows;
      const float phi = 2 * kPi * static_cast<float>(column) / kColumns;
      mesh->positions.emplace_back(std::sin(theta) * std::cos(phi), std::cos(theta),
                                   -std::sin(theta) * std::sin(phi));
    }
  }
  mesh->normals = mesh->positions;
  for (uint32_t row = 0; row < kRows; ++row) {
    for (uint32_t column = 0; column < kColumns; ++column) {
      const uint32_t corner = row * (kColumns + 1) + column;
      const uint32_t below = corner + kColumns + 1;
      mesh->triangles.push_back({corner, below, below + 1});
      mesh->triangles.push_back({corner, below + 1, corner + 1});
    }
  }
  ShapeDescription shape;
  shape.geometry = MeshShape{mesh};
  return shape;
}

ShapeDescription cylinder() {
  ShapeDescription shape;
  shape.geometry = CylinderShape{};
  shape.to_world = glm::scale(
      glm::translate(glm::rotate(Mat4(1), 1.2f, Vec3(1, 0.2f, 0)), Vec3(0, 0, -1)), Vec3(1, 1, 2));
  return shape;
}

ShapeDescription ball() {
  ShapeDescription shape;
  shape.geometry = SphereShape{};
  return shape;
}

struct FootprintCase {
  const char* name;
  ShapeDescription (*make)();
  Mat4 to_world;
  bool is_glass;
  bool is_instance;
};

const Mat4 kStretch = glm::scale(glm::rotate(Mat4(1), 0.4f, Vec3(0, 0, 1)), Vec3(1.1f, 0.7f, 0.9f));

const FootprintCase kFootprintCases[] = {
    {"mirror ball", ball, Mat4(1), false, false},
    {"glass ball", ball, Mat4(1), true, false},
    {"mirror ellipsoid", ball, kStretch, false, false},
    {"glass ellipsoid, instance", ball, kStretch, true, true},
    {"mirror cylinder", cylinder, Mat4(1), false, false},
    {"glass cylinder", cylinder, Mat4(1), true, false},
    {"smooth mesh of mirror", smooth_ball, Mat4(1), false, false},
    {"smooth mesh of glass, instance", smooth_ball, kStretch, true, true},
};

std::shared_ptr<const Scene> scene_of(const FootprintCase& which) {
  SceneDescription scene = testing::empty_scene(64, 64);
  BsdfDescription bsdf{.name = "", .line = 0, .model = ConductorBsdf{}};
  if (which.is_glass) bsdf.model = DielectricBsdf{};
  scene.bsdfs.push_back(bsdf);
  ShapeDescription shape = which.make();
  shape.bsdf = 0;
  if (which.is_instance) {
    scene.groups.push_back({.name = "", .shapes = {shape}});
    shape = {};
    shape.geometry = InstanceShape{0};
    shape.to_world = which.to_world;
  } else {
    shape.to_world = which.to_world * shape.to_world;
  }
  scene.shapes.push_back(shape);
  testing::add_sphere(scene, {0, 0, 0}, 8, testing::add_diffuse(scene, Color(0.5f)));
  testing::look_at(scene, {0, 0.5f, 4}, {0, 0, 0}, 40);
  return testing::build(std::move(scene));
}

TEST(RayFootprint, is_that_of_rays_traced_beside) {
  for (const FootprintCase& which : kFootprintCases) {
    const auto scene = scene_of(which);
    int bent = 0, right = 0, changed = 0;
    for (int y = 0; y < 64; y += 3) {
      for (int x = 0; x < 64; x += 3) {
        const Ray ray = scene->camera().sample_ray(Vec2(x + 0.37f, y + 0.41f), {}).ray;
        RayFootprint footprint(ray.direction, false);
        const auto end = follow(*scene, ray, &footprint);
        if (!end) continue;
        const auto traced = spread_by_differences(*scene, ray, *end);
        // Beyond its bounds the footprint is cut off.
        if (!traced || *traced > 7 * end->length || *traced < end->length / 7) continue;
        if (end->bounces == 0) {
          EXPECT_NEAR(footprint.spread(), end->length, 1e-5f * end->length);
          continue;
        }
        ++bent;
        right += std::abs(footprint.spread() - *traced) < 0.03f * *traced;
        changed += std::abs(end->length - *traced) > 0.2f * *traced;
      }
    }
    EXPECT_GT(bent, 30) << which.name;
    EXPECT_GT(changed, bent / 2) << which.name << ": curvature would not matter";
    // Where a neighbour meets another facet there is no derivative.
    EXPECT_GE(right, 0.95 * bent) << which.name;
  }
}

TEST(RayFootprint, of_flat_mirrors_is_the_length_of_the_path) {
  SceneDescription description = testing::room(16, 16);
  for (BsdfDescription& bsdf : description.bsdfs) bsdf.model = ConductorBsdf{};
  const int floor = testing::add_diffuse(description, Color(0.5f));
  description.shapes[1].bsdf = floor;
  const auto scene = testing::build(std::move(description));
  int reflected = 0;
  for (int x = 0; x < 16; ++x) {
    const Ray ray = scene->camera().sample_ray(Vec2(x + 0.37f, 5.41f), {}).ray;
    RayFootprint footprint(ray.direction, false);
    const auto end = follow(*scene, ray, &footprint);
    if (!end) continue;
    reflected += end->bounces > 0;
    EXPECT_NEAR(footprint.spread(), end->length, 1e-4f * end->length);
  }
  EXPECT_GT(reflected, 8);
}

}  // namespace
}  // namespace guidelight
