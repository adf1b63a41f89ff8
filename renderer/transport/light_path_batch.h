#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "renderer/transport/guided_walk.h"
#include "renderer/transport/subpath.h"

namespace guidelight {

/// Light paths that are traced together, with what they refer to. Keeps its memory.
class LightPathBatch {
 public:
  /// `emission_count` is TechniqueCounts::emission. Without `guided`, paths follow no guides.
  LightPathBatch(const Scene& scene, float emission_count,
                 const std::optional<GuidedEmission>& guided);

  /// Forgets all paths and makes room for as many.
  void reset(size_t capacity);
  /// Begins a path, if there is room; false where nothing is emitted.
  bool add(Rng rng);
  std::vector<Subpath>& paths() { return paths_; }

 private:
  const Scene& scene_;
  float emission_count_;
  std::optional<GuidedEmission> guided_;
  std::vector<Subpath> paths_;
  // Of each path; they do not move.
  std::vector<EmissionSample> emissions_;
  std::vector<GuidedWalk> walks_;
};

}  // namespace guidelight
