#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "renderer/image/image.h"

namespace guidelight {

/// Words that travel with a picture: scene, integrator, settings, passes …
using Metadata = std::map<std::string, std::string>;

/// A picture to be written: named layers of the same size.
struct ImageLayers {
  std::vector<std::pair<std::string, Image>>
      layers;  // "beauty" becomes R,G,B; others name.R … or name.Y
  Metadata metadata;
};

enum class ColorSpace {
  Linear,
  Srgb,
  Automatic
};  // Automatic: 8-bit files are sRGB, float files linear

/// Reads EXR, HDR, PNG, JPEG, TGA, BMP by content. Values are returned linear, 1 to 4 channels.
/// Throws Error naming the file for anything that cannot be read.
Image read_image(const std::string& path, ColorSpace space = ColorSpace::Automatic);
/// The same from memory; `name` stands for the file in messages.
Image read_image(const void* data, size_t size, const std::string& name,
                 ColorSpace space = ColorSpace::Automatic);
/// All layers and metadata of an EXR.
ImageLayers read_exr(const std::string& path);

/// Writers go to a temporary name beside `path` and rename: a failure leaves an existing file as it
/// was. They throw Error naming the path and the reason.
void write_exr(const std::string& path, const ImageLayers& picture, bool half_precision = true);
void write_png(const std::string& path, const DisplayImage& image, const Metadata& metadata = {});
/// The metadata of a PNG written by write_png, or of an EXR.
Metadata read_metadata(const std::string& path);

}  // namespace guidelight
