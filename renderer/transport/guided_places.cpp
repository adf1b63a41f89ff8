#include "renderer/transport/guided_places.h"

#include "renderer/sampling/hash_position.h"

namespace guidelight {

void GuidedPlaces::note(Vec3 position, uint32_t guide) {
  const uint64_t key = hash_position(position);
  Part& part = parts_[key % parts_.size()];
  const std::lock_guard lock(part.mutex);
  part.guides.insert_or_assign(key, guide);
}

std::optional<uint32_t> GuidedPlaces::guide_at(Vec3 position) const {
  const uint64_t key = hash_position(position);
  const auto& guides = parts_[key % parts_.size()].guides;
  const auto found = guides.find(key);
  return found != guides.end() ? std::optional(found->second) : std::nullopt;
}

}  // namespace guidelight
