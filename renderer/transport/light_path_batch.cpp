#include "renderer/transport/light_path_batch.h"

namespace guidelight {

LightPathBatch::LightPathBatch(const Scene& scene, float emission_count,
                               const std::optional<GuidedEmission>& guided)
    : scene_(scene), emission_count_(emission_count), guided_(guided) {}

void LightPathBatch::reset(size_t capacity) {
  paths_.clear();
  paths_.reserve(capacity);
  if (emissions_.size() < capacity) emissions_.resize(capacity);
  if (guided_ && walks_.size() < capacity) walks_.resize(capacity, GuidedWalk(*guided_));
}

bool LightPathBatch::add(Rng rng) {
  const size_t index = paths_.size();
  if (index == emissions_.size()) return false;
  GuidedWalk* walk = guided_ ? &walks_[index] : nullptr;
  const auto path = start_light_path(scene_, rng, emission_count_, emissions_[index], walk);
  if (path) paths_.push_back(*path);
  return path.has_value();
}

}  // namespace guidelight
