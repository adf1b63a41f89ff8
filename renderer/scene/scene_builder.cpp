#include <map>
#include <type_traits>

#include "renderer/error.h"
#include "renderer/scene/accelerator.h"
#include "renderer/scene/reach.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/surface_needs.h"

namespace guidelight {

/// Assembles the content of a Scene, step by step in the order of build().
class Scene::Builder {
 public:
  explicit Builder(std::shared_ptr<const SceneDescription> description)
      : content_(std::make_shared<Content>()) {
    content_->description = std::move(description);
  }

  std::shared_ptr<const Scene> build() {
    make_materials();
    make_shapes();
    make_accelerator();
    make_all_lights();
    const Camera camera =
        naming_file([&] { return Camera(description().camera, description().film); });
    return std::shared_ptr<const Scene>(new Scene(content_, camera));
  }

 private:
  const SceneDescription& description() const { return *content_->description; }

  /// What `make` returns; its errors get the scene's file in front.
  template <typename Make>
  std::invoke_result_t<Make> naming_file(Make make) const {
    try {
      return make();
    } catch (const Error& error) {
      if (description().path.empty()) throw;
      throw Error("{}: {}", description().path, error.what());
    }
  }

  void make_materials() {
    content_->textures = make_textures(description());
    content_->bsdfs = make_bsdfs(description(), content_->textures);
    SceneDescription grey;
    grey.bsdfs.push_back({"grey", 0, DiffuseBsdf{}});
    default_bsdf_ = make_bsdfs(grey, {}).front();
    for (const MediumDescription& medium : description().media) {
      content_->media.push_back({medium.sigma_a});
    }
  }

  void make_shapes() {
    std::map<int, std::vector<uint32_t>> emitters_of_group;  // indices into the group's shapes
    for (size_t g = 0; g < description().groups.size(); ++g) {
      const ShapeGroup& group = description().groups[g];
      for (size_t i = 0; i < group.shapes.size(); ++i) {
        // A light must know its place in the world, so emitting shapes of a group are not instanced
        // but copied, below.
        if (group.shapes[i].radiance) {
          emitters_of_group[static_cast<int>(g)].push_back(static_cast<uint32_t>(i));
        } else {
          add_shape(group.shapes[i], Mat4(1), static_cast<int>(g));
        }
      }
    }
    for (const ShapeDescription& shape : description().shapes) {
      const auto* instance = std::get_if<InstanceShape>(&shape.geometry);
      if (!instance) {
        add_shape(shape, Mat4(1), kNone);
        continue;
      }
      add_instance(instance->group, shape);
      const ShapeGroup& group = description().groups.at(instance->group);
      for (const uint32_t i : emitters_of_group[instance->group]) {
        add_shape(group.shapes[i], shape.to_world, kNone);
      }
    }
  }

  void add_shape(const ShapeDescription& shape, const Mat4& parent, int group) {
    ShapeBinding binding;
    binding.shape = naming_file([&] { return make_shape(shape, parent); });
    binding.name = shape.name;
    const bool has_bsdf = shape.bsdf != kNone;
    binding.bsdf = has_bsdf ? content_->bsdfs.at(shape.bsdf) : default_bsdf_;
    binding.bsdf_name = has_bsdf ? description().bsdfs[shape.bsdf].name : "default grey";
    const SurfaceNeeds needs = needs_of_bsdf(description(), shape.bsdf);
    const bool light_is_textured = shape.radiance && shape.radiance->texture != kNone;
    binding.shape->is_parametrised = needs.parametrisation || light_is_textured;
    binding.perturbs_normal = needs.perturbed_normal;
    binding.is_medium_boundary = shape.is_medium_boundary;
    if (shape.interior != kNone) binding.interior = &content_->media.at(shape.interior);
    if (shape.exterior != kNone) binding.exterior = &content_->media.at(shape.exterior);
    content_->shapes.push_back(std::move(binding));
    sources_.push_back({&shape, group});
  }

  void add_instance(int group, const ShapeDescription& shape) {
    InstanceBinding instance;
    instance.to_world = shape.to_world;
    instance.to_local = glm::inverse(shape.to_world);
    if (!is_finite(Vec3(instance.to_local[0])) || !is_finite(Vec3(instance.to_local[3]))) {
      throw Error(
          "{}:{}: the transform of instance '{}' is singular: scale every axis by more than 0",
          description().path, shape.line, shape.name);
    }
    check_scale(instance, shape);
    for (int axis = 0; axis < 3; ++axis) {
      instance.scale = std::max(instance.scale, glm::length(Vec3(shape.to_world[axis])));
    }
    content_->instances.push_back(instance);
    instance_groups_.push_back(group);
  }

  /// Rays must stay rays in the space of the group.
  void check_scale(const InstanceBinding& instance, const ShapeDescription& shape) const {
    constexpr float kLargest = 1e18f;  // whose square is finite
    Vec3 reach = glm::abs(Vec3(instance.to_local[3]));
    for (int axis = 0; axis < 3; ++axis) {
      reach += kLargestRay * glm::abs(Vec3(instance.to_local[axis]));
    }
    if (is_within(reach, kLargest)) return;
    throw Error(
        "{}:{}: the instance '{}' is too small or too far away for rays: scale the shapes of its "
        "group",
        description().path, shape.line, shape.name);
  }

  void make_accelerator() {
    content_->accelerator =
        std::make_unique<Accelerator>(static_cast<uint32_t>(content_->shapes.size()));
    std::map<int, Bounds> group_bounds;
    for (uint32_t i = 0; i < content_->shapes.size(); ++i) {
      const Shape& shape = *content_->shapes[i].shape;
      const int group = sources_[i].group;
      content_->accelerator->add_shape(shape, i, group);
      (group == kNone ? content_->bounds : group_bounds[group]).extend(shape.bounds());
    }
    for (uint32_t i = 0; i < content_->instances.size(); ++i) {
      const Mat4& to_world = content_->instances[i].to_world;
      content_->accelerator->add_instance(instance_groups_[i], to_world, i);
      const Bounds& b = group_bounds[instance_groups_[i]];
      if (b.empty()) continue;
      for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p(corner & 1 ? b.upper.x : b.lower.x, corner & 2 ? b.upper.y : b.lower.y,
                     corner & 4 ? b.upper.z : b.lower.z);
        const Vec3 world = transform_point(to_world, p);
        if (!is_within(world, kLargestCoordinate)) {
          throw Error("{}: an instance of '{}' reaches farther than {} from the origin: move it",
                      description().path, description().groups[instance_groups_[i]].name,
                      kLargestCoordinate);
        }
        content_->bounds.extend(world);
      }
    }
    content_->accelerator->build();
  }

  void make_all_lights() {
    LightContext context;
    context.textures = &content_->textures;
    if (!content_->bounds.empty()) {
      context.scene_center = content_->bounds.center();
      context.scene_radius = std::max(content_->bounds.radius(), 1e-6f);
    }
    for (size_t i = 0; i < content_->shapes.size(); ++i) {
      const std::optional<ColorInput>& radiance = sources_[i].description->radiance;
      if (!radiance || content_->shapes[i].shape->area() <= 0) continue;
      add_light(make_area_light(*radiance, *content_->shapes[i].shape, context));
      content_->shapes[i].light = content_->lights.back().get();
    }
    for (const EmitterDescription& emitter : description().emitters) {
      auto lights = naming_file([&] { return make_lights(emitter, context); });
      for (auto& light : lights) add_light(std::move(light));
    }
    choose_probabilities();
  }

  void add_light(std::unique_ptr<Light> light) {
    light->index = static_cast<uint32_t>(content_->lights.size());
    if (light->is_infinite()) content_->infinite_lights.push_back(light.get());
    content_->lights.push_back(std::move(light));
  }

  /// Half by power, half alike: a weak lamp that is close must not starve beside a strong sun.
  void choose_probabilities() {
    if (content_->lights.empty()) return;
    double total = 0;
    for (const auto& light : content_->lights) total += light->power();
    std::vector<float> weights;
    for (const auto& light : content_->lights) {
      const double by_power = total > 0 ? light->power() / total : 0;
      weights.push_back(static_cast<float>(0.5 * by_power + 0.5 / content_->lights.size()));
    }
    content_->light_distribution = DiscreteDistribution(weights);
  }

  struct Source {
    const ShapeDescription* description;
    int group;
  };

  std::shared_ptr<Content> content_;
  std::shared_ptr<const Bsdf> default_bsdf_;
  std::vector<Source> sources_;       // beside content_->shapes
  std::vector<int> instance_groups_;  // beside content_->instances
};

std::shared_ptr<const Scene> Scene::build(std::shared_ptr<const SceneDescription> description) {
  return Builder(std::move(description)).build();
}

}  // namespace guidelight
