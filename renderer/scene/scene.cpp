#include "renderer/scene/scene.h"

#include <set>

#include "renderer/parallel/worker_counter.h"
#include "renderer/scene/accelerator.h"
#include "renderer/scene/ray_log.h"
#include "renderer/scene/shape_transform.h"

namespace guidelight {

Scene::Content::~Content() = default;
Scene::~Scene() = default;

Scene::Scene(std::shared_ptr<const Content> content, const Camera& camera)
    : content_(std::move(content)), camera_(camera) {}

std::shared_ptr<const Scene> Scene::with_camera(const Camera& camera) const {
  return std::shared_ptr<const Scene>(new Scene(content_, camera));
}

std::shared_ptr<const Scene> Scene::with_ray_log(RayLog& log) const {
  const std::shared_ptr<Scene> scene(new Scene(content_, camera_));
  scene->log_ = &log;
  return scene;
}

std::shared_ptr<const Scene> Scene::with_ray_counter(WorkerCounter& counter) const {
  const std::shared_ptr<Scene> scene(new Scene(content_, camera_));
  scene->counter_ = &counter;
  return scene;
}

inline void Scene::count_rays(size_t count) const {
  if (counter_) counter_->add(count);
}

Hit Scene::intersect(const Ray& ray) const {
  if (log_) log_->add(false, ray);
  count_rays(1);
  return content_->accelerator->intersect(ray);
}

bool Scene::occluded(const Ray& ray) const {
  if (log_) log_->add(true, ray);
  count_rays(1);
  return content_->accelerator->occluded(ray);
}

void Scene::intersect(std::span<const Ray> rays, std::span<Hit> hits) const {
  if (log_) log_->add(false, rays);
  count_rays(rays.size());
  content_->accelerator->intersect(rays, hits);
}

void Scene::occluded(std::span<const Ray> rays, std::span<uint8_t> blocked) const {
  if (log_) log_->add(true, rays);
  count_rays(rays.size());
  content_->accelerator->occluded(rays, blocked);
}

void Scene::InstanceBinding::apply(SurfacePoint& point) const {
  const Mat3 normal_matrix = glm::transpose(Mat3(to_local));
  point.position = transform_point(to_world, point.position);
  point.geometric_normal = glm::normalize(normal_matrix * point.geometric_normal);
  point.dpdu = transform_vector(to_world, point.dpdu);
  point.dpdv = transform_vector(to_world, point.dpdv);
  point.frame = Frame::from_normal_and_tangent(glm::normalize(normal_matrix * point.frame.n),
                                               transform_vector(to_world, point.frame.s));
  // The transform's own rounding: three products and sums per coordinate.
  point.offset = scale * point.offset + 8 * kFloatEpsilon * max_component(glm::abs(point.position));
}

SurfacePoint Scene::surface_point(const Ray& ray, const Hit& hit) const {
  const ShapeBinding& binding = content_->shapes[hit.shape];
  SurfacePoint point;
  point.shape = hit.shape;
  point.primitive = hit.primitive;
  point.instance = hit.instance;
  point.bsdf = binding.bsdf.get();
  point.light = binding.light;
  point.interior = binding.interior;
  point.exterior = binding.exterior;
  point.is_medium_boundary = binding.is_medium_boundary;
  if (hit.instance == kInvalidIndex) {
    binding.shape->fill(ray, hit, point);
  } else {
    const InstanceBinding& instance = content_->instances[hit.instance];
    const Ray local{transform_point(instance.to_local, ray.origin),
                    transform_vector(instance.to_local, ray.direction), ray.t_max};
    binding.shape->fill(local, hit, point);
    instance.apply(point);
  }
  if (binding.perturbs_normal) point.frame = point.bsdf->shading_frame(point);
  return point;
}

Vec3 Scene::normal_derivative(const Hit& hit, Vec3 position, Vec3 normal, Vec3 displacement) const {
  const Shape& shape = *content_->shapes[hit.shape].shape;
  if (hit.instance == kInvalidIndex) return shape.normal_derivative(hit, position, displacement);
  const InstanceBinding& instance = content_->instances[hit.instance];
  const Vec3 local = shape.normal_derivative(hit, transform_point(instance.to_local, position),
                                             transform_vector(instance.to_local, displacement));
  // The world's normal is (A⁻ᵀ m)/|A⁻ᵀ m| for the group's unit normal m, which is Aᵀn/|Aᵀn|.
  const float scale = glm::length(glm::transpose(Mat3(instance.to_world)) * normal);
  const Vec3 change = scale * (glm::transpose(Mat3(instance.to_local)) * local);
  return derivative_of_unit(normal, change);
}

std::optional<Scene::LightChoice> Scene::choose_light(float u) const {
  if (content_->lights.empty()) return std::nullopt;
  const auto chosen = content_->light_distribution.sample(u);
  return LightChoice{content_->lights[chosen.index].get(), chosen.pmf, chosen.remapped};
}

float Scene::light_probability(const Light& light) const {
  return content_->light_distribution.pmf(light.index);
}

const Medium* Scene::camera_medium() const {
  const int medium = description().camera_medium;
  return medium == kNone ? nullptr : &content_->media[medium];
}

const std::string& Scene::shape_name(uint32_t shape) const { return content_->shapes[shape].name; }
const std::string& Scene::bsdf_name(uint32_t shape) const {
  return content_->shapes[shape].bsdf_name;
}

namespace {

/// Of the meshes of some shapes, each once.
size_t bytes_of_meshes(std::span<const ShapeDescription> shapes, std::set<const Mesh*>& counted) {
  size_t bytes = 0;
  for (const ShapeDescription& shape : shapes) {
    const auto* geometry = std::get_if<MeshShape>(&shape.geometry);
    if (!geometry || !counted.insert(geometry->mesh.get()).second) continue;
    const Mesh& mesh = *geometry->mesh;
    bytes += std::span(mesh.positions).size_bytes() + std::span(mesh.normals).size_bytes() +
             std::span(mesh.uvs).size_bytes() + std::span(mesh.colors).size_bytes() +
             std::span(mesh.triangles).size_bytes();
  }
  return bytes;
}

}  // namespace

Scene::Statistics Scene::statistics() const {
  Statistics result;
  result.shapes = content_->shapes.size();
  result.instances = content_->instances.size();
  result.lights = content_->lights.size();
  result.bytes = content_->accelerator->bytes();
  for (const ShapeBinding& binding : content_->shapes) {
    result.triangles += binding.shape->triangle_count();
    result.bytes += binding.shape->bytes();
  }
  std::set<const Mesh*> counted;
  result.bytes += bytes_of_meshes(description().shapes, counted);
  for (const ShapeGroup& group : description().groups) {
    result.bytes += bytes_of_meshes(group.shapes, counted);
  }
  for (const TextureDescription& texture : description().textures) {
    const auto* bitmap = std::get_if<BitmapTexture>(&texture.model);
    if (bitmap && bitmap->image) result.bytes += bitmap->image->data().size_bytes();
  }
  return result;
}

}  // namespace guidelight
