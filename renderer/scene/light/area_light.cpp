#include "renderer/math/frame.h"
#include "renderer/sampling/warp.h"
#include "renderer/scene/light/light.h"

namespace guidelight {

namespace {

/// Diffuse emission from the outside of a shape.
class AreaLight final : public Light {
 public:
  AreaLight(const ColorInput& radiance, const Shape& shape, const LightContext& context)
      : shape_(shape),
        radiance_(context.textures ? ColorTexture(radiance, *context.textures)
                                   : ColorTexture(radiance.value)) {}

  Color radiance(const SurfacePoint& point, Vec3 w) const override {
    return glm::dot(point.geometric_normal, w) > 0 ? radiance_.eval(point) : Color(0);
  }

  std::optional<DirectSample> sample_direct(Vec3 reference, Vec2 u) const override {
    std::optional<DirectSample> result(std::in_place);
    DirectSample& sample = *result;
    sample.pdf = shape_.sample_seen_from(reference, u, sample.point);
    const Vec3 to_light = sample.point.position - reference;
    const float squared = length_squared(to_light);
    const float projected = -glm::dot(sample.point.geometric_normal, to_light);  // cos × distance
    if (!(sample.pdf > 0 && projected > 0 && squared > 0)) {
      result.reset();
      return result;
    }

    sample.distance = std::sqrt(squared);
    sample.wi = to_light / sample.distance;
    sample.cos_light = projected / sample.distance;
    sample.radiance = radiance_.eval(sample.point);
    sample.point.light = this;
    sample.position = sample.point.position;
    sample.pdf_position = shape_.pdf_area(sample.point);
    sample.pdf_direction = cosine_hemisphere_pdf(sample.cos_light);
    return result;
  }

  float pdf_direct(Vec3 reference, const SurfacePoint& point) const override {
    return shape_.pdf_seen_from(reference, point);
  }

  std::optional<EmissionSample> sample_emission(Vec2 u_position, Vec2 u_direction) const override {
    std::optional<EmissionSample> result(std::in_place);
    EmissionSample& sample = *result;
    sample.pdf_position = shape_.sample_area(u_position, sample.point);
    const Vec3 local = square_to_cosine_hemisphere(u_direction);
    if (!(sample.pdf_position > 0 && local.z > 0)) {
      result.reset();
      return result;
    }
    sample.point.light = this;
    const Frame frame = Frame::from_normal(sample.point.geometric_normal);
    sample.ray = sample.point.spawn_ray(frame.to_world(local));
    sample.weight = radiance_.eval(sample.point) * (kPi / sample.pdf_position);
    sample.cos_light = local.z;
    sample.pdf_direction = cosine_hemisphere_pdf(local.z);
    return result;
  }

  EmissionPdf pdf_emission(const SurfacePoint& point, Vec3 w) const override {
    return {shape_.pdf_area(point), cosine_hemisphere_pdf(glm::dot(point.geometric_normal, w))};
  }

  float power() const override { return kPi * shape_.area() * luminance(radiance_.mean()); }

 private:
  const Shape& shape_;
  ColorTexture radiance_;
};

}  // namespace

std::unique_ptr<Light> make_area_light(const ColorInput& radiance, const Shape& shape,
                                       const LightContext& context) {
  return std::make_unique<AreaLight>(radiance, shape, context);
}

}  // namespace guidelight
