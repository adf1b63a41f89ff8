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
    const Shape::SeenSample seen = shape_.sample_seen_from(reference, u);
    const Vec3 to_light = seen.point.position - reference;
    const float squared = length_squared(to_light);
    const float projected = -glm::dot(seen.point.geometric_normal, to_light);  // cosine × distance
    if (!(seen.pdf_solid_angle > 0 && projected > 0 && squared > 0)) return std::nullopt;

    std::optional<DirectSample> result(std::in_place);
    DirectSample& sample = *result;
    sample.distance = std::sqrt(squared);
    sample.wi = to_light / sample.distance;
    sample.cos_light = projected / sample.distance;
    sample.radiance = radiance_.eval(seen.point);
    sample.pdf = seen.pdf_solid_angle;
    sample.point = seen.point;
    sample.point.light = this;
    sample.position = seen.point.position;
    sample.pdf_position = shape_.pdf_area(seen.point);
    sample.pdf_direction = cosine_hemisphere_pdf(sample.cos_light);
    return result;
  }

  float pdf_direct(Vec3 reference, const SurfacePoint& point) const override {
    return shape_.pdf_seen_from(reference, point);
  }

  std::optional<EmissionSample> sample_emission(Vec2 u_position, Vec2 u_direction) const override {
    const ShapeSample from = shape_.sample_area(u_position);
    const Vec3 local = square_to_cosine_hemisphere(u_direction);
    if (!(from.pdf_area > 0 && local.z > 0)) return std::nullopt;
    std::optional<EmissionSample> result(std::in_place);
    EmissionSample& sample = *result;
    sample.point = from.point;
    sample.point.light = this;
    const Frame frame = Frame::from_normal(from.point.geometric_normal);
    sample.ray = from.point.spawn_ray(frame.to_world(local));
    sample.weight = radiance_.eval(from.point) * (kPi / from.pdf_area);
    sample.pdf_position = from.pdf_area;
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
