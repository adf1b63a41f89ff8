#pragma once

#include <algorithm>

#include "renderer/transport/mis_partials.h"

namespace guidelight {

/// How often each family of techniques samples one camera path; 0 switches it off. A path of k
/// segments is cut into s vertices on the light's side and t on the camera's, s + t = k + 1.
struct TechniqueCounts {
  float emission = 1;       // s = 0: the camera path finds an emitter
  float next_event = 1;     // s = 1: it is connected to a point on a light
  float light_tracing = 1;  // t = 1: light paths per camera path, each connected to the lens
  float connections = 1;    // s, t ≥ 2: pairs of vertices per camera path
  float merging = 0;        // light paths whose vertices are merged with
  /// Merge also photons of direct light, and those of caustics at vertices that the camera sees
  /// directly. Other techniques are better at both (Georgiev et al. 2012, section 6).
  bool merge_direct = false;
  /// Ω [sr]: photons merged with count as independent of each other as far as the camera path came
  /// to them by scattering within this angle; see MisWeights::independence. By default, always.
  float independent_angle = 1e30f;
};

/// Expected number of samples that all techniques take of one path, divided by that of a technique
/// at the edge where the sum stands. Kept apart by whether a radius belongs to it.
struct MisSums {
  float connection = 0;
  float merging = 0;  // per `eta`

  /// eta = light paths merged with × merging area.
  float total(float eta) const { return connection + eta * merging; }
};

/// The one step of the recurrence: closes the partials of a vertex by the density of scattering
/// back to the one before (per solid angle, survival included). `technique_count` is the count of
/// the technique that connects at the edge before the vertex, `mergeable` 1 if photons may be
/// merged here, `independence` what MisWeights::independence says of scattering back.
inline MisSums mis_sums(const MisPartials& partials, float pdf_backward, float technique_count,
                        float mergeable, float independence = 1) {
  return {technique_count * partials.inverse_pdf + pdf_backward * partials.connection,
          mergeable + independence * pdf_backward * partials.merging};
}

/// The same at a vertex that scatters by a delta lobe: nothing connects or merges here.
inline MisSums mis_sums_at_delta(const MisPartials& partials, float pdf_backward) {
  return {pdf_backward * partials.connection, pdf_backward * partials.merging};
}

/// Balance heuristic over all techniques (Georgiev et al. 2012, section 4.5), from partial sums
/// along the two subpaths. Densities `pdf_arrival…` are per area (or as the end vertex measures
/// it), those called `pdf_backward…` per solid angle; both contain the survival probability of the
/// vertex that scatters. docs/mis.md derives each line.
class MisWeights {
 public:
  explicit MisWeights(const TechniqueCounts& counts) : counts_(counts) {}

  const TechniqueCounts& counts() const { return counts_; }

  /// Count of the technique that connects at the edge before vertex `length` of a subpath.
  float count_before_light_vertex(int length) const {
    return length == 1 ? counts_.next_event : counts_.connections;
  }
  float count_before_camera_vertex(int length) const {
    return length == 1 ? counts_.light_tracing : counts_.connections;
  }
  /// Photons of the first segment are direct light.
  float mergeable_light_vertex(int length) const {
    return length > 1 || counts_.merge_direct ? 1.0f : 0.0f;
  }

  /// By what a scattering of the camera path, of finite density per solid angle, reduces the count
  /// of all merges behind it: they share its direction (after Grittmann et al. 2021,
  /// "Correlation-Aware Multiple Importance Sampling"; docs/mis.md).
  float independence(float pdf_scattering) const {
    return std::min(1.0f, pdf_scattering * counts_.independent_angle);
  }

  /// s, t ≥ 2. `light_share`: independence of a merge at the light's vertex.
  float connection(const MisSums& light, float pdf_arrival_light, const MisSums& camera,
                   float pdf_arrival_camera, float eta, float light_share) const {
    const float others =
        pdf_arrival_light * light.total(eta * light_share) + pdf_arrival_camera * camera.total(eta);
    return 1 / (1 + others / counts_.connections);
  }

  /// s = 1. `emission_ratio`: density of emitting the whole first segment over that of
  /// next-event estimation, the arrival at the camera's vertex per area; `hit_ratio`: density of
  /// finding the light by scattering over that of next-event estimation (0 for delta lights).
  float next_event(const MisSums& camera, float emission_ratio, float hit_ratio, float eta) const {
    const float others = counts_.emission * hit_ratio + emission_ratio * camera.total(eta);
    return 1 / (1 + others / counts_.next_event);
  }

  /// t = 1.
  float light_tracing(const MisSums& light, float pdf_arrival_light, float eta) const {
    return 1 / (1 + pdf_arrival_light * light.total(eta) / counts_.light_tracing);
  }

  /// s = 0, after at least one scattering. `pdf_direct`: density of next-event estimation of this
  /// point; pdf_emission: density of emitting this last segment, position times direction.
  float emission(const MisPartials& camera, float pdf_direct, float pdf_emission, float eta) const {
    if (counts_.emission == 0) return is_unreachable(camera) ? 1.0f : 0.0f;
    const float others = counts_.next_event * pdf_direct * camera.inverse_pdf +
                         pdf_emission * (camera.connection + eta * camera.merging);
    return 1 / (1 + others / counts_.emission);
  }

  /// Merging, with sums closed without a technique of their own. `share`: independence of the
  /// camera's vertex.
  float merging(const MisSums& light, const MisSums& camera, float eta, float share) const {
    // Behind very many bounces the share may be too small for a float.
    return share / (share * (1 + light.merging) + (light.connection + camera.connection) / eta +
                    camera.merging);
  }

 private:
  /// No other technique could have found a path with these partials.
  static bool is_unreachable(const MisPartials& camera) {
    return camera.inverse_pdf == 0 && camera.connection == 0 && camera.merging == 0;
  }

  TechniqueCounts counts_;
};

}  // namespace guidelight
