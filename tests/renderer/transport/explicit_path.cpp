#include "tests/renderer/transport/explicit_path.h"

#include <cmath>

#include "renderer/scene/bsdf/scattering.h"
#include "renderer/transport/random_walk.h"

namespace guidelight::testing {

namespace {

/// Evaluates p→ and p← of one path, in the measures of algorithms: area for surfaces, solid angle
/// for x₀ at infinity; a delta lobe counts with its discrete probability in its place.
class Densities {
 public:
  Densities(const Scene& scene, const ExplicitPath& path) : scene_(scene), path_(path) {}

  int k() const { return path_.length(); }

  /// Density of x_j sampled from the light's side, for j < k.
  double from_light(int j) const {
    const Light& light = *path_.light;
    const double chosen = scene_.light_probability(light);
    const EmissionPdf emission = emission_pdf();
    if (light.is_infinite()) {
      if (j == 0) return chosen * (light.is_delta() ? 1.0 : emission.direction);
      if (j == 1) return emission.position * cosine(1, -path_.towards);
    } else {
      if (j == 0) return chosen * (light.is_delta() ? 1.0 : emission.position);
      if (j == 1) return emission.direction * to_area(0, 1);
    }
    return scatter(j - 1, j - 2, j) * to_area(j - 1, j);
  }

  /// Density of x_j sampled from the camera's side, for j < k; the lens counts 1.
  double from_camera(int j) const {
    if (j == k() - 1) {
      const Camera& camera = scene_.camera();
      const double pdf = camera.pdf_direction(path_.lens, direction(k(), j));
      if (camera.description().model == CameraModel::Orthographic) {
        return pdf * cosine(j, camera.forward());
      }
      return pdf * to_area(k(), j);
    }
    const double pdf = scatter(j + 1, j + 2, j);
    return j == 0 && path_.light->is_infinite() ? pdf : pdf * to_area(j + 1, j);
  }

  /// Density of next-event estimation for x₀.
  double direct() const {
    const Light& light = *path_.light;
    const double chosen = scene_.light_probability(light);
    if (light.is_delta()) return chosen;
    if (light.is_infinite()) return chosen * light.pdf_direct_from(path_.towards);
    return chosen * light.pdf_direct(position(1), path_.light_point) * to_area(1, 0);
  }

  bool is_delta(int j) const { return path_.vertices[j - 1].is_delta; }

  /// Of the camera path that merges at x_m: the product over its finite scatterings.
  double independence(int m, double angle) const {
    double product = 1;
    for (int j = m + 1; j < k(); ++j) {
      if (!is_delta(j)) product *= std::min(1.0, angle * scatter(j, j + 1, j - 1));
    }
    return product;
  }

 private:
  Vec3 position(int j) const {
    if (j == 0) return path_.light_position;
    return j == k() ? path_.lens : path_.vertices[j - 1].point.position;
  }

  Vec3 direction(int from, int to) const {
    if (to == 0 && path_.light->is_infinite()) return path_.towards;
    const glm::dvec3 d = glm::dvec3(position(to)) - glm::dvec3(position(from));
    return Vec3(d / glm::length(d));
  }

  double cosine(int j, Vec3 w) const {
    const SurfacePoint& point = j == 0 ? path_.light_point : path_.vertices[j - 1].point;
    return std::abs(glm::dot(glm::dvec3(point.geometric_normal), glm::dvec3(w)));
  }

  double to_area(int from, int to) const {
    const glm::dvec3 d = glm::dvec3(position(to)) - glm::dvec3(position(from));
    const double has_surface =
        to == 0 && path_.light->is_delta() ? 1 : cosine(to, direction(from, to));
    return has_surface / glm::dot(d, d);
  }

  EmissionPdf emission_pdf() const {
    const Light& light = *path_.light;
    const Vec3 w = light.is_infinite() ? -path_.towards : direction(0, 1);
    return light.pdf_emission(path_.light_point, w);
  }

  /// Density per solid angle, survival included, of scattering at x_j from one neighbour to the
  /// other.
  double scatter(int j, int from, int to) const {
    const auto& [point, is_delta] = path_.vertices[j - 1];
    const double survival = survival_probability(point);
    if (!is_delta) {
      return survival *
             Scattering(point, direction(j, from), TransportMode::Radiance).pdf(direction(j, to));
    }
    // The same from both sides (tested with the BSDFs), but near total reflection rounding decides,
    // and must decide once.
    const Vec3 wo = direction(j, std::min(from, to));
    const Vec3 wi = direction(j, std::max(from, to));
    const bool reflects =
        glm::dot(point.geometric_normal, wo) * glm::dot(point.geometric_normal, wi) > 0;
    const auto event = point.bsdf->specular(
        point, point.frame.to_local(wo), reflects ? kLobeDeltaReflection : kLobeDeltaTransmission);
    return event ? survival * event->probability : 0.0;
  }

  const Scene& scene_;
  const ExplicitPath& path_;
};

}  // namespace

OracleWeights oracle_weights(const Scene& scene, const ExplicitPath& path,
                             const TechniqueCounts& counts, double eta) {
  const Densities p(scene, path);
  const int k = path.length();
  const auto is_connectible = [&](int j) { return j == 0 || j == k || !p.is_delta(j); };
  std::vector<double> light(k), camera(k);
  for (int j = 0; j < k; ++j) light[j] = p.from_light(j);
  for (int j = 0; j < k; ++j) camera[j] = p.from_camera(j);
  // Products of up to a dozen densities; long doubles have the range.
  const auto product = [&](int light_end, int camera_begin) {
    long double value = 1;
    for (int j = 0; j < light_end; ++j) value *= light[j];
    for (int j = camera_begin; j < k; ++j) value *= camera[j];
    return value;
  };

  std::vector<long double> connection(k + 1, 0), merging(k, 0);
  if (!path.light->is_delta()) connection[0] = counts.emission * product(0, 0);
  for (int s = 1; s <= k && k > 1; ++s) {
    if (!is_connectible(s - 1) || !is_connectible(s)) continue;
    if (s == 1) {
      connection[s] = counts.next_event * p.direct() * product(0, 1);
    } else {
      connection[s] = (s == k ? counts.light_tracing : counts.connections) * product(s, s);
    }
  }
  bool is_caustic = true;  // all vertices between the light and x_m are specular
  for (int m = 1; m < k; ++m) {
    const bool is_direct = m == 1 || (m == k - 1 && is_caustic);
    is_caustic &= p.is_delta(m);
    if (p.is_delta(m) || (is_direct && !counts.merge_direct)) continue;
    merging[m] = eta * p.independence(m, counts.independent_angle) * product(m + 1, m);
  }

  long double sum = 0;
  for (long double value : connection) sum += value;
  for (long double value : merging) sum += value;
  OracleWeights weights;
  for (long double value : connection)
    weights.connection.push_back(static_cast<double>(value / sum));
  for (long double value : merging) weights.merging.push_back(static_cast<double>(value / sum));
  return weights;
}

}  // namespace guidelight::testing
