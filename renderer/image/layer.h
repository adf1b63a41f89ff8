#pragma once

#include <array>

namespace guidelight {

/// The pictures a film develops. Colour layers have 3 channels, the others 1.
enum class Layer {
  Beauty,
  Direct,      // emitters seen directly and light after one scattering
  Indirect,    // the rest; beauty = direct + indirect
  Caustic,     // the part of indirect that FilmSample::caustic describes
  Connection,  // found by tracing and connecting paths; beauty = connection + merging
  Merging,     // found by merging vertices, which is density estimation
  Albedo,
  Normal,  // world space, -1..1, of the first hit
  Depth,   // distance from the camera along the ray [scene units], mean over samples that hit
  SampleCount,
  Variance,  // of the pixel mean, luminance of beauty; of density estimates with the squared bias
};
inline constexpr int kLayerCount = 11;
inline constexpr std::array<Layer, kLayerCount> kAllLayers = {
    Layer::Beauty,     Layer::Direct,      Layer::Indirect, Layer::Caustic,
    Layer::Connection, Layer::Merging,     Layer::Albedo,   Layer::Normal,
    Layer::Depth,      Layer::SampleCount, Layer::Variance};

/// Lower-case name for files and menus, e.g. "sample_count".
const char* layer_name(Layer layer);
int layer_channels(Layer layer);
/// Beauty and its parts, which are compared with each other.
bool is_radiance_layer(Layer layer);

}  // namespace guidelight
