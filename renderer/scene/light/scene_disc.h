#pragma once

#include "renderer/math/frame.h"
#include "renderer/sampling/warp.h"
#include "renderer/scene/light/light.h"

namespace guidelight {

/// The disc that faces a light at infinity and covers the scene's bounding sphere: all light of one
/// direction that can meet the scene passes through it.
class SceneDisc {
 public:
  explicit SceneDisc(const LightContext& context)
      : center_(context.scene_center), radius_(context.scene_radius * 1.001f) {}

  float area() const { return kPi * sqr(radius_); }
  float pdf() const { return kInvPi / sqr(radius_); }

  /// A ray that arrives from unit direction `towards`.
  Ray ray_from(Vec3 towards, Vec2 u) const {
    const Vec2 disk = square_to_disk(u);
    const Frame frame = Frame::from_normal(towards);
    return {center_ + radius_ * frame.to_world(Vec3(disk, 1)), -towards, kInfinity};
  }

 private:
  Vec3 center_;
  float radius_;
};

/// A direct sample of a light at infinity.
inline DirectSample distant_sample(Vec3 towards, Color radiance, float pdf, const SceneDisc& disc) {
  DirectSample sample;
  sample.wi = towards;
  sample.distance = kInfinity;
  sample.radiance = radiance;
  sample.pdf = pdf;
  sample.position = Vec3(0);
  sample.pdf_position = disc.pdf();
  sample.pdf_direction = pdf;
  sample.cos_light = 1;
  return sample;
}

/// The first ray of a light path from infinity.
inline EmissionSample distant_emission(Vec3 towards, Color radiance, float pdf,
                                       const SceneDisc& disc, Vec2 u_position) {
  EmissionSample sample;
  sample.ray = disc.ray_from(towards, u_position);
  sample.weight = radiance * (disc.area() / pdf);
  sample.pdf_position = disc.pdf();
  sample.pdf_direction = pdf;
  sample.cos_light = 1;
  return sample;
}

}  // namespace guidelight
