#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "renderer/sampling/distribution.h"
#include "renderer/scene/bsdf/bsdf.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/description.h"
#include "renderer/scene/light/light.h"
#include "renderer/scene/medium.h"
#include "renderer/scene/shape.h"

namespace guidelight {

class Accelerator;
class RayLog;
class WorkerCounter;

/// The immutable run-time form of a SceneDescription: everything an integrator asks of a scene.
/// Shared by shared_ptr<const Scene>; an edit makes a new one that shares what did not change.
class Scene {
 public:
  /// Throws Error for a description that cannot be rendered.
  static std::shared_ptr<const Scene> build(std::shared_ptr<const SceneDescription> description);

  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// The same scene through another camera; shares everything else.
  std::shared_ptr<const Scene> with_camera(const Camera& camera) const;

  /// The same scene that writes down every ray; `log` must outlive it.
  std::shared_ptr<const Scene> with_ray_log(RayLog& log) const;

  /// The same scene that counts its rays; `counter` must outlive it.
  std::shared_ptr<const Scene> with_ray_counter(WorkerCounter& counter) const;

  const SceneDescription& description() const { return *content_->description; }
  const Camera& camera() const { return camera_; }
  Bounds bounds() const { return content_->bounds; }

  // -- Geometry. Rays are traced against everything but the camera; invalid hits are misses.
  Hit intersect(const Ray& ray) const;
  bool occluded(const Ray& ray) const;
  /// Batches, faster than one by one; `hits`/`blocked` have the size of `rays`.
  void intersect(std::span<const Ray> rays, std::span<Hit> hits) const;
  void occluded(std::span<const Ray> rays, std::span<uint8_t> blocked) const;
  /// The full surface record of a valid hit, with normal maps applied.
  SurfacePoint surface_point(const Ray& ray, const Hit& hit) const;
  /// Derivative of the unit normal that a shape is shaded with, without normal maps, by a
  /// displacement within the surface; `position` and `normal` are those of the hit.
  Vec3 normal_derivative(const Hit& hit, Vec3 position, Vec3 normal, Vec3 displacement) const;

  // -- Lights. Every light is chosen by a fixed probability.
  std::span<const std::unique_ptr<Light>> lights() const { return content_->lights; }
  /// Those at infinity; escaped rays see the sum of them.
  std::span<const Light* const> infinite_lights() const { return content_->infinite_lights; }
  struct LightChoice {
    const Light* light;
    float probability;
    float remapped;  // u, free to be used again
  };
  /// Empty if the scene has no light.
  std::optional<LightChoice> choose_light(float u) const;
  float light_probability(const Light& light) const;

  /// The medium that the camera is in, nullptr for vacuum.
  const Medium* camera_medium() const;

  /// Names for people, of a SurfacePoint's shape.
  const std::string& shape_name(uint32_t shape) const;
  const std::string& bsdf_name(uint32_t shape) const;

  struct Statistics {
    size_t shapes = 0;
    size_t triangles = 0;
    size_t instances = 0;
    size_t lights = 0;
    size_t bytes = 0;  // geometry, BVH and textures, approximate
  };
  Statistics statistics() const;

 private:
  struct ShapeBinding {
    std::unique_ptr<Shape> shape;
    std::shared_ptr<const Bsdf> bsdf;
    const Light* light = nullptr;
    const Medium* interior = nullptr;
    const Medium* exterior = nullptr;
    bool is_medium_boundary = false;
    bool perturbs_normal = false;
    std::string name;
    std::string bsdf_name;
  };
  struct InstanceBinding {
    Mat4 to_world{1.0f};
    Mat4 to_local{1.0f};
    float scale = 1;  // largest stretch of to_world

    /// Takes a point from the group's space to the world.
    void apply(SurfacePoint& point) const;
  };
  struct Content {
    std::shared_ptr<const SceneDescription> description;
    TextureList textures;
    BsdfList bsdfs;
    std::vector<Medium> media;
    std::vector<ShapeBinding> shapes;
    std::vector<InstanceBinding> instances;
    std::vector<std::unique_ptr<Light>> lights;
    std::vector<const Light*> infinite_lights;
    DiscreteDistribution light_distribution;

    Bounds bounds;
    std::unique_ptr<Accelerator> accelerator;
    ~Content();
  };
  class Builder;

  Scene(std::shared_ptr<const Content> content, const Camera& camera);
  void count_rays(size_t count) const;

  std::shared_ptr<const Content> content_;
  Camera camera_;
  RayLog* log_ = nullptr;
  WorkerCounter* counter_ = nullptr;
};

}  // namespace guidelight
