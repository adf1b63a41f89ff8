#include "renderer/io/exr_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfTileDescription.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "renderer/error.h"
#include "renderer/io/atomic_file.h"
#include "renderer/io/image_limits.h"
#include "renderer/io/read_file.h"

namespace guidelight {
namespace {

constexpr std::string_view kMagic("\x76\x2f\x31\x01", 4);
constexpr float kMaxHalf = 65504.0f;

class MemoryStream : public Imf::IStream {
 public:
  MemoryStream(std::string_view bytes, const std::string& name)
      : Imf::IStream(name.c_str()), bytes_(bytes) {}

  bool read(char buffer[], int count) override {
    if (count < 0 || position_ + static_cast<size_t>(count) > bytes_.size()) {
      throw Error("the file ends too early");
    }
    std::memcpy(buffer, bytes_.data() + position_, static_cast<size_t>(count));
    position_ += static_cast<size_t>(count);
    return position_ < bytes_.size();
  }
  uint64_t tellg() override { return position_; }
  void seekg(uint64_t position) override {
    position_ = std::min<uint64_t>(position, bytes_.size());
  }

 private:
  std::string_view bytes_;
  size_t position_ = 0;
};

/// The library's own files swallow the errors of what they write last.
class MemoryOutput : public Imf::OStream {
 public:
  explicit MemoryOutput(const std::string& name) : Imf::OStream(name.c_str()) {}

  void write(const char buffer[], int count) override {
    const auto size = static_cast<size_t>(count);
    if (bytes_.size() < position_ + size) bytes_.resize(position_ + size);
    std::memcpy(bytes_.data() + position_, buffer, size);
    position_ += size;
  }
  uint64_t tellp() override { return position_; }
  void seekp(uint64_t position) override { position_ = position; }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  size_t position_ = 0;
};

/// The library allocates what an attribute claims before it reads it. Attributes are name, type
/// (both zero-terminated), size and value; an empty name ends a header.
void check_attribute_sizes(std::string_view bytes) {
  size_t at = 8;
  const auto skip_text = [&] {
    const size_t end = bytes.find('\0', at);
    if (end == std::string_view::npos) throw Error("the file ends too early");
    const bool empty = end == at;
    at = end + 1;
    return !empty;
  };
  while (skip_text()) {
    skip_text();
    uint32_t size = 0;
    if (bytes.size() - at < sizeof(size)) throw Error("the file ends too early");
    std::memcpy(&size, bytes.data() + at, sizeof(size));
    at += sizeof(size);
    if (size > bytes.size() - at) throw Error("its header is damaged");
    at += size;
  }
}

/// Reads the header alone: opening the file would already allocate tables for the size it claims.
Imf::Header read_header(std::string_view bytes, const std::string& name) {
  check_attribute_sizes(bytes);
  MemoryStream stream(bytes, name);
  char magic_and_version[8];
  stream.read(magic_and_version, 8);
  int version = 0;
  std::memcpy(&version, magic_and_version + 4, 4);
  Imf::Header header;
  header.readFrom(stream, version);
  const Imath::Box2i window = header.dataWindow();
  const int64_t width = int64_t{window.max.x} - window.min.x + 1;
  const int64_t height = int64_t{window.max.y} - window.min.y + 1;
  int channels = 0;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c) ++channels;
  check_image_size(width, height, channels, bytes.size());
  if (header.hasTileDescription()) {
    const Imf::TileDescription& tile = header.tileDescription();
    check_image_size(tile.xSize, tile.ySize, channels, bytes.size());
  }
  return header;
}

Metadata string_attributes(const Imf::Header& header) {
  Metadata metadata;
  for (auto a = header.begin(); a != header.end(); ++a) {
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute())) {
      metadata[a.name()] = text->value();
    }
  }
  return metadata;
}

/// Channels R,G,B,A and X,Y,Z come in that order, others by name.
int channel_rank(const std::string& suffix) {
  static constexpr std::array<std::string_view, 8> kOrder = {"R", "G", "B", "X",
                                                             "Y", "Z", "V", "A"};
  const auto* found = std::find(kOrder.begin(), kOrder.end(), suffix);
  return static_cast<int>(found - kOrder.begin());
}

struct LayerChannels {
  std::string name;
  std::vector<std::string> channels;  // full names
};

std::string suffix_of(const std::string& channel) {
  const size_t dot = channel.rfind('.');
  return dot == std::string::npos ? channel : channel.substr(dot + 1);
}

/// Groups channels by the part of their name before the last dot; the unnamed layer is "beauty".
std::vector<LayerChannels> group_channels(const Imf::Header& header) {
  std::vector<LayerChannels> layers;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
    if (c.channel().xSampling != 1 || c.channel().ySampling != 1) {
      throw Error("its channel '{}' is subsampled; convert it to RGB", c.name());
    }
    const std::string full = c.name();
    const size_t dot = full.rfind('.');
    const std::string name = dot == std::string::npos ? "beauty" : full.substr(0, dot);
    auto layer = std::find_if(layers.begin(), layers.end(),
                              [&](const LayerChannels& l) { return l.name == name; });
    if (layer == layers.end()) layer = layers.insert(layers.end(), {name, {}});
    layer->channels.push_back(full);
  }
  for (LayerChannels& layer : layers) {
    std::stable_sort(layer.channels.begin(), layer.channels.end(),
                     [](const std::string& a, const std::string& b) {
                       return channel_rank(suffix_of(a)) < channel_rank(suffix_of(b));
                     });
  }
  std::stable_partition(layers.begin(), layers.end(),
                        [](const LayerChannels& l) { return l.name == "beauty"; });
  if (layers.empty()) throw Error("it has no channels");
  return layers;
}

/// A slice whose base is shifted so that the data window starts at our first pixel.
Imf::Slice float_slice(float* pixels, int channels, const Imath::Box2i& window) {
  const int width = window.max.x - window.min.x + 1;
  return Imf::Slice::Make(Imf::FLOAT, pixels, Imath::V2i(window.min), static_cast<int64_t>(width),
                          window.max.y - window.min.y + 1, sizeof(float) * channels,
                          sizeof(float) * channels * width);
}

/// Interleaved halves or floats of one layer, kept until the file is written.
struct EncodedLayer {
  std::vector<Imath::half> halves;
};

std::vector<std::string> channel_names(const std::string& layer, int channels) {
  static constexpr std::array<const char*, 4> kColor = {"R", "G", "B", "A"};
  static constexpr std::array<const char*, 2> kGrey = {"Y", "A"};
  const std::string prefix = layer == "beauty" ? "" : layer + ".";
  std::vector<std::string> names;
  for (int c = 0; c < channels; ++c) {
    if (channels <= 2) {
      names.push_back(prefix + kGrey[c]);
    } else {
      names.push_back(prefix + (c < 4 ? kColor[c] : fmt::format("C{}", c)));
    }
  }
  return names;
}

/// Values beyond the range of half become its largest one, so that no finite value turns infinite.
std::vector<Imath::half> to_half(std::span<const float> values) {
  std::vector<Imath::half> halves(values.size());
  std::transform(values.begin(), values.end(), halves.begin(), [](float v) {
    return Imath::half(std::isfinite(v) ? std::clamp(v, -kMaxHalf, kMaxHalf) : v);
  });
  return halves;
}

std::string encode_exr(const std::string& path, const ImageLayers& picture, bool half_precision) {
  const Image& first = picture.layers.front().second;
  Imf::Header header(first.width(), first.height());
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [key, value] : picture.metadata) header.insert(key, Imf::StringAttribute(value));

  Imf::FrameBuffer frame;
  std::vector<EncodedLayer> encoded(picture.layers.size());
  for (size_t i = 0; i < picture.layers.size(); ++i) {
    const auto& [name, image] = picture.layers[i];
    const int channels = image.channels();
    // Depths, counts and variances need more range and precision than colours.
    const bool half = half_precision && channels >= 3;
    if (half) encoded[i].halves = to_half(image.data());
    const size_t sample_size = half ? sizeof(Imath::half) : sizeof(float);
    char* base = half ? reinterpret_cast<char*>(encoded[i].halves.data())
                      : reinterpret_cast<char*>(const_cast<float*>(image.data().data()));
    const std::vector<std::string> names = channel_names(name, channels);
    for (int c = 0; c < channels; ++c) {
      const Imf::PixelType type = half ? Imf::HALF : Imf::FLOAT;
      header.channels().insert(names[c], Imf::Channel(type));
      frame.insert(names[c], Imf::Slice(type, base + c * sample_size, sample_size * channels,
                                        sample_size * channels * image.width()));
    }
  }
  MemoryOutput output(path);
  {
    Imf::OutputFile file(output, header, 0);
    file.setFrameBuffer(frame);
    file.writePixels(first.height());
  }  // which completes the table of lines
  return output.bytes();
}

}  // namespace

bool is_exr(std::string_view bytes) { return bytes.substr(0, 4) == kMagic; }

ImageLayers decode_exr(std::string_view bytes, const std::string& name) {
  try {
    const Imf::Header header = read_header(bytes, name);
    const Imath::Box2i window = header.dataWindow();
    const std::vector<LayerChannels> groups = group_channels(header);

    ImageLayers picture;
    picture.metadata = string_attributes(header);
    Imf::FrameBuffer frame;
    for (const LayerChannels& group : groups) {
      const int channels = static_cast<int>(group.channels.size());
      picture.layers.emplace_back(group.name, Image(window.max.x - window.min.x + 1,
                                                    window.max.y - window.min.y + 1, channels));
      float* pixels = picture.layers.back().second.data().data();
      for (int c = 0; c < channels; ++c) {
        frame.insert(group.channels[c], float_slice(pixels + c, channels, window));
      }
    }
    MemoryStream stream(bytes, name);
    Imf::InputFile file(stream, 0);
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    return picture;
  } catch (const std::exception& error) {
    throw Error("Cannot read the EXR image '{}': {}; export it again.", name, error.what());
  }
}

Metadata decode_exr_metadata(std::string_view bytes, const std::string& name) {
  try {
    return string_attributes(read_header(bytes, name));
  } catch (const std::exception& error) {
    throw Error("Cannot read the EXR image '{}': {}; export it again.", name, error.what());
  }
}

ImageLayers read_exr(const std::string& path) {
  const std::string bytes = read_file_bytes(path);
  if (!is_exr(bytes)) {
    throw Error("Cannot read '{}': it is not an EXR image; convert it to OpenEXR.", path);
  }
  return decode_exr(bytes, path);
}

void write_exr(const std::string& path, const ImageLayers& picture, bool half_precision) {
  if (picture.layers.empty() || picture.layers.front().second.empty()) {
    throw Error("Cannot write '{}': the picture is empty; render something first.", path);
  }
  for (const auto& [name, image] : picture.layers) {
    if (image.width() != picture.layers.front().second.width() ||
        image.height() != picture.layers.front().second.height() || image.channels() < 1) {
      throw Error(
          "Cannot write '{}': layer '{}' has another size than the first; give all layers "
          "the same size.",
          path, name);
    }
  }
  std::string bytes;
  try {
    bytes = encode_exr(path, picture, half_precision);
  } catch (const std::exception& error) {
    throw Error("Cannot write '{}': {}; render it again.", path, error.what());
  }
  write_file_atomically(path, bytes);
}

}  // namespace guidelight
