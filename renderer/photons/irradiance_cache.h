#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "renderer/scene/shape.h"

namespace guidelight {

/// Irradiance at a point, and how it changes around it.
struct IrradianceRecord {
  Vec3 position{0};
  Vec3 normal{0, 0, 1};
  Color irradiance{0.0f};
  /// Change of each channel by a turn of the normal around an axis [per rad] …
  std::array<Vec3, 3> rotational{};
  /// … and by a step in the tangent plane [per scene unit].
  std::array<Vec3, 3> translational{};
  float distance = 0;  // R: harmonic mean of the distances to what is seen [scene units]
  int key = 0;         // records serve only queries of the same key
};

/// Irradiance caching (Ward, Rubinstein & Clear 1988) with gradients (Ward & Heckbert 1992,
/// "Irradiance Gradients"). A record is valid where the split-sphere model expects an error below
/// the accuracy; records are found through an octree.
class IrradianceCache {
 public:
  struct Settings {
    float accuracy = 0.2f;   // a; the largest expected error, relative
    float min_distance = 0;  // limits of R [scene units]
    float max_distance = kInfinity;
  };

  IrradianceCache(const Bounds& bounds, const Settings& settings);

  /// Adds a record, its R limited by the gradient and by the settings. Results depend on the order
  /// of insertion in rounding only.
  void insert(IrradianceRecord record);

  /// Mean of the valid records, extrapolated by their gradients; empty if none is valid.
  std::optional<Color> interpolate(Vec3 position, Vec3 normal, int key) const;

  std::span<const IrradianceRecord> records() const { return records_; }

 private:
  struct Node {
    std::array<int, 8> children{-1, -1, -1, -1, -1, -1, -1, -1};
    std::vector<uint32_t> records;
  };

  /// How much a record weighs at a point; 0 where it is not valid.
  float weight(const IrradianceRecord& record, Vec3 position, Vec3 normal) const;
  void limit(IrradianceRecord& record) const;
  void insert_into(size_t node, const Bounds& box, uint32_t record, int depth);

  Settings settings_;
  Bounds root_;  // a cube
  std::vector<IrradianceRecord> records_;
  std::vector<Node> nodes_;
};

}  // namespace guidelight
