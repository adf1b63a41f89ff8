#pragma once

#include <memory>

#include "renderer/integrators/integrator.h"
#include "renderer/scene/scene.h"

namespace guidelight::testing {

/// Small descriptions from which tests build scenes, without files.
SceneDescription empty_scene(int width = 16, int height = 16);

/// Adds a diffuse BSDF and returns its index.
int add_diffuse(SceneDescription& scene, Color reflectance);

/// Adds the rectangle [-1,1]² in z = 0, normal +z, under a transform.
ShapeDescription& add_rectangle(SceneDescription& scene, const Mat4& to_world, int bsdf = kNone);
ShapeDescription& add_sphere(SceneDescription& scene, Vec3 center, float radius, int bsdf = kNone);

/// A camera at `origin` that looks at `target`.
void look_at(SceneDescription& scene, Vec3 origin, Vec3 target, float fov_degrees = 40);

/// A closed diffuse room with a lamp in the ceiling, seen from inside.
SceneDescription room(int width = 16, int height = 16);

std::shared_ptr<const Scene> build(SceneDescription description);

/// Renders passes of an integrator with its default settings for the scene.
Film render(std::shared_ptr<const Scene> scene, uint32_t passes, int threads = 2, uint64_t seed = 1,
            const std::string& integrator = "path");

}  // namespace guidelight::testing
