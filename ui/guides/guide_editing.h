#pragma once

#include "renderer/transport/guide_trace.h"

namespace guidelight {

/// A guide with one vertex put elsewhere on a surface and the rest traced again. Scattering
/// vertices stay where they are, and the specular ones between are solved for; where no solution
/// exists they stay as they were and check_guide() says what is wrong. A specular vertex that is
/// moved takes the rest of its segment along. Returns the guide unchanged where `to` cannot be that
/// vertex: the first must be on a light, the others must not become or cease to be specular.
GuidePath move_guide_vertex(const Scene& scene, const GuidePath& guide, int vertex,
                            const SurfacePoint& to);

/// Light paths as a guide proposes them.
struct GuideCandidates {
  struct Candidate {
    std::vector<Vec3> points;
    bool valid = false;  // it meets the same kinds of surfaces as the guide
  };
  std::vector<Candidate> candidates;
  float valid_share() const;
};

/// Empty for a guide with faults.
GuideCandidates sample_candidates(const std::shared_ptr<const Scene>& scene, GuidePath guide,
                                  int count);

}  // namespace guidelight
