#include "renderer/transport/guide_mixture.h"

#include "renderer/sampling/warp.h"
#include "renderer/transport/guide_check.h"

namespace guidelight {

namespace {

/// Rays that look for a light's point in a disc start this far above it.
float clearance(const SurfacePoint& center, float disc_radius) {
  return 16 * center.offset + 1e-4f * disc_radius;
}

/// 1 - cosθ between unit vectors, without the cancellation.
float one_minus_cosine(Vec3 a, Vec3 b) { return 0.5f * length_squared(a - b); }

}  // namespace

std::shared_ptr<const GuideMixture> GuideMixture::build(std::shared_ptr<const Scene> scene,
                                                        std::span<const GuidePath> guides) {
  auto mixture = std::make_shared<GuideMixture>();
  std::vector<float> weights;
  for (size_t i = 0; i < guides.size(); ++i) {
    if (!guides[i].enabled || !(guides[i].weight > 0)) continue;
    std::vector<GuideFault> faults;
    const PlacedGuide placed = place_guide(*scene, guides[i], faults);
    if (!faults.empty()) continue;
    Guide guide{static_cast<uint32_t>(i),  placed.light,          placed.points[0],
                placed.points[1].position, guides[i].disc_radius, {}};
    for (size_t k = 0; k + 1 < placed.points.size(); ++k) {
      const Vec3 segment = placed.points[k + 1].position - placed.points[k].position;
      const GuideVertex& vertex = guides[i].vertices[k];
      guide.steps.push_back(
          {glm::normalize(segment), 2 * sqr(std::sin(0.5f * vertex.cone)), vertex.event});
    }
    mixture->guides_.push_back(std::move(guide));
    weights.push_back(guides[i].weight);
  }
  if (weights.empty()) return nullptr;
  mixture->weights_ = DiscreteDistribution(weights);
  mixture->scene_ = std::move(scene);
  return mixture;
}

std::optional<GuidedStart> GuideMixture::start(uint32_t index, Vec2 u_position,
                                               Vec2 u_direction) const {
  const Guide& guide = guides_[index];
  const Light& light = *guide.light;
  GuidedStart start{&light, {}};
  EmissionSample& emission = start.emission;
  const Vec3 direction =
      light.is_delta_direction() ? guide.steps[0].axis : sample_direction(index, 0, u_direction);
  emission.cos_light = 1;
  if (light.is_infinite()) {
    emission.ray = parallel_ray(guide, direction, u_position);
  } else if (light.is_delta_position()) {
    emission.point = guide.origin;
    emission.ray = {guide.origin.position, direction, kInfinity};
  } else {
    const auto point = sample_disc(guide, u_position);
    if (!point) return std::nullopt;
    emission.point = *point;
    emission.ray = point->spawn_ray(direction);
    emission.cos_light = glm::dot(point->geometric_normal, direction);
    if (!(emission.cos_light > 0)) return std::nullopt;
  }
  const EmissionPdf pdf = light.pdf_emission(emission.point, direction);
  emission.pdf_position = light.is_delta_position() ? 1.0f : pdf.position;
  emission.pdf_direction = light.is_delta_direction() ? 1.0f : pdf.direction;
  if (!(emission.pdf_position > 0 && emission.pdf_direction > 0)) return std::nullopt;
  emission.weight = emitted_light(light, emission.point, direction) * emission.cos_light /
                    (emission.pdf_position * emission.pdf_direction);
  if (is_black(emission.weight)) return std::nullopt;
  return start;
}

double GuideMixture::pdf_start(uint32_t index, const Light& light, const SurfacePoint& point,
                               Vec3 ray_origin, Vec3 direction) const {
  const Guide& guide = guides_[index];
  if (guide.light != &light) return 0;
  const double pdf =
      light.is_delta_direction() ? 1.0 : static_cast<double>(pdf_direction(index, 0, direction));
  if (pdf == 0 || light.is_delta_position()) return pdf;
  return pdf * (light.is_infinite() ? pdf_parallel(guide, ray_origin, direction)
                                    : pdf_disc(guide, point));
}

Vec3 GuideMixture::sample_direction(uint32_t guide, int vertex, Vec2 u) const {
  const Step& step = guides_[guide].steps[vertex];
  return Frame::from_normal(step.axis).to_world(square_to_narrow_cap(u, step.one_minus_cos));
}

float GuideMixture::pdf_direction(uint32_t guide, int vertex, Vec3 direction) const {
  const Step& step = guides_[guide].steps[vertex];
  const bool is_inside = one_minus_cosine(step.axis, direction) <= step.one_minus_cos;
  return is_inside ? narrow_cap_pdf(step.one_minus_cos) : 0.0f;
}

double GuideMixture::pdf_step(uint32_t guide, int vertex, const GuidedStep& step) const {
  if (event(guide, vertex) != step.event) return 0;
  return step.event == PathEvent::Scatter ? double{pdf_direction(guide, vertex, step.direction)}
                                          : 1.0;
}

/// Projects a uniform point of the disc that touches the light at vertex 0 onto the light.
std::optional<SurfacePoint> GuideMixture::sample_disc(const Guide& guide, Vec2 u) const {
  const Vec3 normal = guide.origin.geometric_normal;
  const Vec2 disc = guide.disc_radius * square_to_disk(u);
  const float height = clearance(guide.origin, guide.disc_radius);
  const Vec3 above =
      guide.origin.position + Frame::from_normal(normal).to_world(Vec3(disc.x, disc.y, height));
  const Ray ray{above, -normal, height + guide.disc_radius};
  const Hit hit = scene_->intersect(ray);
  if (!hit.valid()) return std::nullopt;
  const SurfacePoint point = scene_->surface_point(ray, hit);
  const bool is_on_light =
      point.light == guide.light && glm::dot(point.geometric_normal, normal) > 0;
  return is_on_light ? std::optional(point) : std::nullopt;
}

/// Per area of the light: that of the disc times the cosine of the projection.
double GuideMixture::pdf_disc(const Guide& guide, const SurfacePoint& point) const {
  const Vec3 normal = guide.origin.geometric_normal;
  const Vec3 offset = point.position - guide.origin.position;
  const float depth = -glm::dot(offset, normal);
  const float height = clearance(guide.origin, guide.disc_radius);
  const float cosine = glm::dot(point.geometric_normal, normal);
  const float squared = length_squared(offset + depth * normal);
  if (!(cosine > 0 && squared <= sqr(guide.disc_radius) && depth >= -height &&
        depth <= guide.disc_radius)) {
    return 0;
  }
  // Where the light is flat nothing can be between.
  const Ray up{point.offset_origin(normal), normal, depth + height};
  if (depth > height && scene_->occluded(up)) return 0;
  return cosine * kUniformDiskPdf / sqr(guide.disc_radius);
}

/// Passes through the disc around vertex 1, and begins before the scene does.
Ray GuideMixture::parallel_ray(const Guide& guide, Vec3 direction, Vec2 u) const {
  const Vec2 disc = guide.disc_radius * square_to_disk(u);
  const Vec3 aim = guide.anchor + Frame::from_normal(direction).to_world(Vec3(disc.x, disc.y, 0));
  const Bounds bounds = scene_->bounds();
  const float ahead = glm::dot(aim - bounds.center(), direction) + 1.001f * bounds.radius();
  return {aim - ahead * direction, direction, kInfinity};
}

/// Per area across the ray.
double GuideMixture::pdf_parallel(const Guide& guide, Vec3 ray_origin, Vec3 direction) const {
  const Vec3 offset = ray_origin - guide.anchor;
  const Vec3 across = offset - glm::dot(offset, direction) * direction;
  const float squared = length_squared(across);
  return squared <= sqr(guide.disc_radius) ? kUniformDiskPdf / sqr(guide.disc_radius) : 0.0;
}

}  // namespace guidelight
