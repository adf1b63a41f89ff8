#pragma once

#include <array>
#include <vector>

#include "renderer/image/film.h"
#include "renderer/integrators/bidirectional/light_vertices.h"
#include "renderer/integrators/bidirectional/pass_setup.h"
#include "renderer/integrators/tiles.h"
#include "renderer/photons/hash_grid.h"
#include "renderer/photons/kd_tree.h"
#include "renderer/photons/photon.h"
#include "renderer/transport/path_weights.h"

namespace guidelight {

/// Light vertices of the whole pass, to choose from at random.
class VertexCache {
 public:
  /// One batch for each tile; must outlive this.
  explicit VertexCache(const std::vector<StoredVertices>& batches);

  size_t size() const { return begin_.back(); }
  const StoredVertex& operator[](size_t i) const;

 private:
  const std::vector<StoredVertices>& batches_;
  std::vector<size_t> begin_;  // of each batch; and the end
};

/// What the camera's paths may meet; null where a technique is off.
struct LightSide {
  const LightVertices* own = nullptr;         // the tile's light paths
  const VertexCache* cache = nullptr;         // all vertices
  const HashGrid<Photon>* photons = nullptr;  // to merge with, those within a radius …
  const KdTree<Photon>* nearest = nullptr;    // … or the nearest
};

/// Traces the camera paths of a tile and closes them in every way but t = 1.
class CameraStage {
 public:
  explicit CameraStage(const PassSetup& setup);

  void render(const PixelRegion& tile, const LightSide& light, Film& film);

  // RandomWalk's visitor.
  void escaped(uint32_t index, Subpath& path);
  void expect(Vec3 position, bool soon) const;
  bool visit(uint32_t index, Subpath& path, const PathVertex& vertex, const Scattering& scattering);
  void end_segment();

 private:
  /// A camera path beside its Subpath.
  struct PathState {
    std::optional<RayFootprint> footprint;  // if the radius is asked to depend on it
    float radius = 0;         // of merging, once the first connectible vertex is known
    float eta = 0;            // see MisSums::total
    int finite_vertices = 0;  // that scattered by a finite lobe
    bool first_is_finite = false;
    bool is_specular_tail = false;  // the last did not
    FilmSample sample;

    /// Takes note of how the vertex before the segment scattered.
    void extend(const Subpath& path);
    /// After one finite vertex, specular ones alone.
    bool is_caustic() const { return finite_vertices == 1 && is_specular_tail; }
    bool is_direct_caustic() const { return finite_vertices == 1 && first_is_finite; }
  };
  struct PendingLight {
    uint32_t path;
    int s;
    int t;
    Color contribution;  // without weight
    float weight;
  };

  void start(const PixelRegion& tile, const Filter& filter);
  void add_emission(uint32_t index, const Subpath& path, const PathVertex& vertex);
  void connect_light(uint32_t index, Subpath& path, const PathVertex& vertex,
                     const Scattering& scattering);
  void connect_own_path(uint32_t index, const PathVertex& vertex, const Scattering& scattering);
  void connect_random_vertices(uint32_t index, Subpath& path, const PathVertex& vertex,
                               const Scattering& scattering);
  void connect(uint32_t index, const PathVertex& light, const PathVertex& vertex,
               const Scattering& scattering, float scale);
  void merge_within_radius(uint32_t index, const PathVertex& vertex, const Scattering& scattering);
  void merge_nearest(uint32_t index, const PathVertex& vertex, const Scattering& scattering);
  /// `kernel`: value of the density estimate's kernel, per area.
  void merge(uint32_t index, const PathVertex& vertex, const Scattering& scattering,
             const Photon& photon, float kernel);
  void queue(const Ray& shadow_ray, const PendingLight& light);
  /// Adds a visible contribution of technique (s,t), for a merge of light vertex s - 1.
  void add(uint32_t index, int s, int t, Color contribution, float weight, bool is_caustic = false,
           bool is_merging = false);

  const PassSetup& setup_;
  LightSide light_;
  RandomWalk walk_;
  std::vector<Subpath> paths_;
  std::vector<PathState> states_;
  PixelRegion tile_;
  std::vector<Neighbor> neighbors_;  // room for a search
  std::vector<PendingLight> pending_;
  std::vector<Ray> shadow_rays_;
  std::vector<uint8_t> blocked_;
};

}  // namespace guidelight
