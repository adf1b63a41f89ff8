#include "renderer/image/layer.h"

#include <cstddef>

namespace guidelight {

const char* layer_name(Layer layer) {
  static constexpr const char* kNames[kLayerCount] = {
      "beauty", "direct", "indirect", "caustic",      "connection", "merging",
      "albedo", "normal", "depth",    "sample_count", "variance"};
  return kNames[static_cast<size_t>(layer)];
}

int layer_channels(Layer layer) { return layer >= Layer::Depth ? 1 : 3; }

bool is_radiance_layer(Layer layer) { return layer <= Layer::Merging; }

}  // namespace guidelight
