#pragma once

#include <memory>

#include "renderer/sampling/random.h"
#include "renderer/transport/guide_mixture.h"
#include "renderer/transport/path.h"

namespace guidelight {

/// Proposes paths whose light's side follows a guide (Fan et al. 2005, section 5.2): it is joined
/// with the eye's side of the current path, up to its first finite vertex, or straight with the
/// lens, each half of the time. The source knows the former alone; caustics that the eye sees
/// directly need the latter.
class GuideProposal {
 public:
  GuideProposal(const Scene& scene, std::shared_ptr<const GuideMixture> guides)
      : scene_(scene), guides_(std::move(guides)) {}

  const std::shared_ptr<const GuideMixture>& guides() const { return guides_; }

  /// As Mutation::propose. Sets y.guide also where there is no candidate.
  bool propose(const Path& x, int max_length, Path& y, Rng& rng) const;
  /// As Mutation::density.
  double density(const Path& x, const Path& y) const;

 private:
  bool follow(uint32_t guide, Path& y, Rng& rng) const;
  /// Density of the first `segments` segments of y.
  double prefix_pdf(const Path& y, int segments) const;

  const Scene& scene_;
  std::shared_ptr<const GuideMixture> guides_;
};

}  // namespace guidelight
