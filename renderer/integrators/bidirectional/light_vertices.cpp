#include "renderer/integrators/bidirectional/light_vertices.h"

#include "renderer/transport/random_walk.h"

namespace guidelight {

StoredVertex::StoredVertex(const PathVertex& vertex)
    : point_{vertex.hit, vertex.point.position, vertex.wo},
      throughput_(vertex.throughput),
      partials_(vertex.partials),
      length_(static_cast<int16_t>(vertex.length)),
      is_specular_chain_(vertex.is_specular_chain),
      medium_(vertex.medium) {}

PathVertex StoredVertex::restore(const Scene& scene) const {
  PathVertex vertex{.point = point_.restore(scene),
                    .hit = point_.hit,
                    .wo = point_.wo,
                    .throughput = throughput_,
                    .partials = partials_,
                    .merging_before_last = 0,
                    .medium = medium_,
                    .survival = 1,
                    .length = length_,
                    .is_specular_chain = is_specular_chain_};
  vertex.survival = survival_probability(vertex.point);
  return vertex;
}

void StoredVertices::store(const LightVertices& from) {
  vertices.clear();
  for (const PathVertex& vertex : from.vertices) vertices.emplace_back(vertex);
  previous = from.previous;
  last = from.last;
}

void StoredVertices::restore(const Scene& scene, LightVertices& to) const {
  to.reset(last.size());
  for (const StoredVertex& vertex : vertices) to.vertices.push_back(vertex.restore(scene));
  to.previous = previous;
  to.last = last;
}

}  // namespace guidelight
