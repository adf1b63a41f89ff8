#include "renderer/photons/irradiance_cache.h"

#include <algorithm>

namespace guidelight {

namespace {

constexpr int kMaxTreeDepth = 16;

int octant(const Bounds& box, Vec3 p) {
  const Vec3 center = box.center();
  return (p.x >= center.x ? 1 : 0) | (p.y >= center.y ? 2 : 0) | (p.z >= center.z ? 4 : 0);
}

Bounds child_box(const Bounds& box, int child) {
  const Vec3 center = box.center();
  Bounds result = box;
  for (int axis = 0; axis < 3; ++axis) {
    (child >> axis & 1 ? result.lower : result.upper)[axis] = center[axis];
  }
  return result;
}

bool overlaps(const Bounds& box, Vec3 center, float radius) {
  const Vec3 outside = glm::max(glm::max(box.lower - center, center - box.upper), Vec3(0.0f));
  return length_squared(outside) <= sqr(radius);
}

}  // namespace

IrradianceCache::IrradianceCache(const Bounds& bounds, const Settings& settings)
    : settings_(settings), nodes_(1) {
  const Vec3 half(0.5f * max_component(bounds.upper - bounds.lower));
  root_.lower = bounds.center() - half;
  root_.upper = bounds.center() + half;
}

void IrradianceCache::limit(IrradianceRecord& record) const {
  record.distance = std::clamp(record.distance, settings_.min_distance, settings_.max_distance);
  // The gradient alone must not double or extinguish the irradiance within R. It is the gradient
  // that gives way, not R: both come from few rays, and records that happen to be bright have steep
  // gradients. Were these to reach less far, the dark ones beside them would rule, and light from
  // small bright places would be lost.
  Vec3 gradient(0.0f);
  for (int c = 0; c < 3; ++c) gradient += record.translational[c] / 3.0f;
  const float mean = (record.irradiance.r + record.irradiance.g + record.irradiance.b) / 3;
  const float change = glm::length(gradient) * record.distance;
  if (change > mean) {
    for (Vec3& g : record.translational) g *= mean / change;
  }
}

void IrradianceCache::insert(IrradianceRecord record) {
  limit(record);
  records_.push_back(record);
  insert_into(0, root_, static_cast<uint32_t>(records_.size() - 1), 0);
}

void IrradianceCache::insert_into(size_t node, const Bounds& box, uint32_t record, int depth) {
  // In nodes about as large as the record's reach, in all that it touches.
  const IrradianceRecord& added = records_[record];
  const float reach = settings_.accuracy * added.distance;
  if (depth == kMaxTreeDepth || box.upper.x - box.lower.x <= 2 * reach) {
    nodes_[node].records.push_back(record);
    return;
  }
  for (int child = 0; child < 8; ++child) {
    const Bounds part = child_box(box, child);
    if (!overlaps(part, added.position, reach)) continue;
    if (nodes_[node].children[child] < 0) {
      nodes_[node].children[child] = static_cast<int>(nodes_.size());
      nodes_.emplace_back();
    }
    insert_into(nodes_[node].children[child], part, record, depth + 1);
  }
}

float IrradianceCache::weight(const IrradianceRecord& record, Vec3 position, Vec3 normal) const {
  const Vec3 offset = position - record.position;
  const float cosine = glm::dot(normal, record.normal);
  if (cosine <= 0) return 0;
  // Ward & Heckbert 1992, (2): the split sphere's error.
  const float error = glm::length(offset) / record.distance + safe_sqrt(1 - cosine);
  if (!(error < settings_.accuracy)) return 0;
  // A record in front of the point may see around what shades it (Ward et al. 1988).
  if (glm::dot(offset, normal + record.normal) < -0.02f * record.distance) return 0;
  // Falls to 0 where the record ends to be valid, so that none appears with a step.
  return 1 / std::max(error, 1e-4f) - 1 / settings_.accuracy;
}

std::optional<Color> IrradianceCache::interpolate(Vec3 position, Vec3 normal, int key) const {
  Color sum(0.0f);
  float weights = 0;
  const auto add = [&](const IrradianceRecord& record) {
    const float w = record.key == key ? weight(record, position, normal) : 0;
    if (w == 0) return;
    const Vec3 step = position - record.position;
    const Vec3 turn = glm::cross(record.normal, normal);
    for (int c = 0; c < 3; ++c) {
      sum[c] += w * (record.irradiance[c] + glm::dot(turn, record.rotational[c]) +
                     glm::dot(step, record.translational[c]));
    }
    weights += w;
  };
  Bounds box = root_;
  for (int node = 0; node >= 0;) {
    for (const uint32_t record : nodes_[node].records) add(records_[record]);
    const int child = octant(box, position);
    box = child_box(box, child);
    node = nodes_[node].children[child];
  }
  if (!(weights > 0)) return std::nullopt;
  return glm::max(sum / weights, Color(0.0f));
}

}  // namespace guidelight
