#include "renderer/io/framing.h"

#include <algorithm>

namespace guidelight {
namespace {

struct Box {
  Vec3 lower{kInfinity};
  Vec3 upper{-kInfinity};

  void extend(Vec3 p) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  bool empty() const { return !(lower.x <= upper.x); }
};

void extend(Box& box, const SceneDescription& scene, const ShapeDescription& shape,
            const Mat4& parent) {
  const Mat4 to_world = parent * shape.to_world;
  if (const auto* mesh = std::get_if<MeshShape>(&shape.geometry)) {
    for (const Vec3 p : mesh->mesh->positions) box.extend(transform_point(to_world, p));
  } else if (const auto* instance = std::get_if<InstanceShape>(&shape.geometry)) {
    for (const ShapeDescription& part : scene.groups[instance->group].shapes) {
      extend(box, scene, part, to_world);
    }
  } else {  // the box [-1,1]³ around the analytic shapes
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 p(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      box.extend(transform_point(to_world, p));
    }
  }
}

}  // namespace

CameraDescription framing_camera(const SceneDescription& scene) {
  Box box;
  for (const ShapeDescription& shape : scene.shapes) extend(box, scene, shape, Mat4(1));
  if (box.empty()) box = {Vec3(-1), Vec3(1)};
  const Vec3 center = 0.5f * (box.lower + box.upper);
  const float radius = std::max(0.5f * glm::length(box.upper - box.lower), 1e-6f);

  CameraDescription camera;
  camera.fov = 40;
  camera.fov_axis = FovAxis::Smaller;
  const float distance = radius / std::sin(0.5f * camera.fov * kPi / 180);
  const Vec3 forward = glm::normalize(Vec3(-0.5f, -0.35f, -1));
  const Vec3 left = glm::normalize(glm::cross(Vec3(0, 1, 0), forward));
  camera.to_world = Mat4(Vec4(left, 0), Vec4(glm::cross(forward, left), 0), Vec4(forward, 0),
                         Vec4(center - distance * forward, 1));
  camera.near_clip = distance * 1e-4f;
  camera.far_clip = distance * 100;
  return camera;
}

}  // namespace guidelight
