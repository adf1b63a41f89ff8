#pragma once

#include <vector>

#include "renderer/transport/path_vertex.h"
#include "renderer/transport/stored_point.h"

namespace guidelight {

/// Names no vertex.
inline constexpr uint32_t kNoVertex = 0xffffffffu;

/// The connectible vertices of a batch of light paths, each path a chain from its last to its
/// first.
struct LightVertices {
  std::vector<PathVertex> vertices;
  std::vector<uint32_t> previous;  // of each vertex, kNoVertex for a path's first
  std::vector<uint32_t> last;      // of each path, kNoVertex if it has none

  void reset(size_t paths) {
    vertices.clear();
    previous.clear();
    last.assign(paths, kNoVertex);
  }
  void add(uint32_t path, const PathVertex& vertex) {
    previous.push_back(last[path]);
    last[path] = static_cast<uint32_t>(vertices.size());
    vertices.push_back(vertex);
  }
};

/// A light vertex as it is kept from one stage of a pass to the next: the surface is looked up
/// again instead of stored.
class StoredVertex {
 public:
  explicit StoredVertex(const PathVertex& vertex);
  PathVertex restore(const Scene& scene) const;

 private:
  StoredPoint point_;
  Color throughput_;
  MisPartials partials_;
  int16_t length_;
  bool is_specular_chain_;
  const Medium* medium_;
};

/// LightVertices at rest.
struct StoredVertices {
  std::vector<StoredVertex> vertices;
  std::vector<uint32_t> previous;
  std::vector<uint32_t> last;

  void store(const LightVertices& from);
  void restore(const Scene& scene, LightVertices& to) const;
};

}  // namespace guidelight
