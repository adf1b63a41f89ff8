#pragma once

#include <map>
#include <vector>

#include "renderer/metropolis/harvest.h"
#include "renderer/transport/path.h"

namespace guidelight {

/// Groups paths that visit the same shapes and scatter there alike.
class Ways {
 public:
  /// `scene` must outlive this.
  explicit Ways(const Scene& scene) : scene_(scene) {}

  /// A path that brings so much light; that of the highest rank stands for its way.
  void add(const Path& path, double contribution, double rank);

  /// The ways that bring most, the strongest first.
  std::vector<HarvestedPath> strongest(size_t count) const;

 private:
  struct Way {
    double contribution = 0;
    double rank = 0;
    GuidePath guide;
  };

  const Scene& scene_;
  std::map<std::vector<uint32_t>, Way> ways_;  // by light, shapes and events
  double total_ = 0;
};

}  // namespace guidelight
