#pragma once

#include <vector>

#include "renderer/sampling/random.h"
#include "renderer/scene/bsdf/scattering.h"
#include "renderer/transport/guide_mixture.h"

namespace guidelight {

class GuidedPlaces;

/// Light paths of which a share follows guides, the others the lights and BSDFs alone.
struct GuidedEmission {
  const GuideMixture* mixture;
  float fraction;                  // that follows guides, in (0, 1)
  GuidedPlaces* places = nullptr;  // told where guided paths leave photons; may be null

  /// Density of a first segment over that of ordinary emission, which is `pdf`: the choice of the
  /// light times position times direction. Arguments as of GuideMixture::pdf_start.
  float density_ratio(const Light& light, const SurfacePoint& point, Vec3 ray_origin,
                      Vec3 direction, double pdf) const;
};

/// What a light path knows of the guides. A path up to vertex i has been drawn with the density
/// ((1 - a) + a Σ_j w_j r_j(i)) p(i), where p is that of ordinary sampling, survival included, a
/// the share of guided paths and r_j the density of guide j over p; docs/guides.md. The ratios are
/// products of one factor per vertex, so nothing earlier has to be remembered.
class GuidedWalk {
 public:
  explicit GuidedWalk(const GuidedEmission& emission) : emission_(emission) {}

  /// Draws the beginning of a path that follows a guide, or empty: of one that follows none.
  struct Choice {
    bool is_guided;
    std::optional<GuidedStart> start;  // of a guided path, unless the candidate is rejected
  };
  Choice begin(Rng& rng);

  /// Takes note of the first segment; `pdf` as of GuidedEmission::density_ratio. Returns that
  /// ratio.
  float emit(const Light& light, const EmissionSample& emission, double pdf);

  /// The path has left a photon here.
  void left_photon(Vec3 position) const;

  /// Whether the path follows a guide from the vertex where it has arrived.
  bool follows_guide() const { return guide_ != kNoGuide; }

  /// Where its guide sends the path from vertex `i`, with weight and density as if the BSDF had
  /// drawn it; empty where the guide does not fit the surface.
  std::optional<ScatteringSample> sample(int i, const Scattering& scattering, Rng& rng) const;

  /// Takes note of how the path went on from vertex `i`, whoever drew it. Returns the density of
  /// the path over p before divided by that now, a factor for its throughput.
  float scatter(int i, const Scattering& scattering, const ScatteringSample& sample,
                float survival);

 private:
  static constexpr uint32_t kNoGuide = kInvalidIndex;
  struct Candidate {
    uint32_t guide;
    double ratio;  // w_j r_j
  };

  /// Moves guides that end at vertex i to the finished ones.
  void finish(int i);
  double density_ratio() const;
  double step_ratio(uint32_t guide, int i, const Scattering& scattering,
                    const ScatteringSample& sample, float survival) const;

  GuidedEmission emission_;
  uint32_t guide_ = kNoGuide;          // that is followed
  uint32_t began_with_ = kNoGuide;     // the same, also when the guide has ended
  std::vector<Candidate> candidates_;  // guides that could have made the path and go on
  double finished_ = 0;                // Σ w_j r_j of those that could have and do not
  double density_ = 1;                 // (1 - a) + a Σ w_j r_j
};

}  // namespace guidelight
