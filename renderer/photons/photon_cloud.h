#pragma once

#include <algorithm>
#include <vector>

#include "renderer/photons/photon.h"
#include "renderer/transport/guided_places.h"

namespace guidelight {

/// Photons of one pass, to be looked at.
struct PhotonCloud {
  struct Point {
    Vec3 position;
    Vec3 direction;  // unit, towards where the photon came from
    Color power;   // [W]; of ppm, sppm and the bidirectional methods as the shading normal sees it
    int bounce;    // segments of the light path that ends here
    bool caustic;  // see Photon::caustic
    int guide;     // position in the list of guides of the one its path began with; -1 for none
  };
  std::vector<Point> points;
  size_t total = 0;  // photons of the pass, of which `points` are evenly chosen ones
  size_t bytes = 0;  // that all of them take
};

/// Asks a pass for its photons; nobody asks by a null pointer.
class PhotonRequest {
 public:
  /// At most `cap` photons are handed over.
  explicit PhotonRequest(size_t cap) : cap_(cap) {}

  /// Called by integrators with all their maps. The photons' power is in watts times `light_paths`.
  template <class... Maps>
  void collect(double light_paths, const Maps&... maps) {
    cloud_ = {};
    cloud_.total = (maps.size() + ...);
    cloud_.bytes = ((maps.size() * sizeof(maps[0])) + ...);
    const size_t stride =
        std::max<size_t>(1, (cloud_.total + cap_ - 1) / std::max<size_t>(1, cap_));
    cloud_.points.reserve(cloud_.total / stride + sizeof...(maps));
    (take(maps, stride, static_cast<float>(1 / light_paths)), ...);
  }

  PhotonCloud& cloud() { return cloud_; }
  /// Where the pass's light paths have followed guides; to be filled before collect().
  GuidedPlaces& guided_places() { return places_; }

 private:
  template <class Map>
  void take(const Map& map, size_t stride, float scale) {
    for (size_t i = 0; i < map.size(); i += stride) {
      const Photon& photon = map[i];
      const auto guide = places_.guide_at(photon.position);
      cloud_.points.push_back({photon.position, photon.direction(), scale * photon.power(),
                               photon.length(), photon.caustic(),
                               guide ? static_cast<int>(*guide) : -1});
    }
  }

  size_t cap_;
  GuidedPlaces places_;
  PhotonCloud cloud_;
};

}  // namespace guidelight
