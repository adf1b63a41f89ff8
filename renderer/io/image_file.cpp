#include "renderer/io/image_file.h"

#include <stb_image.h>
#include <stb_image_write.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <memory>
#include <string_view>

#include "renderer/error.h"
#include "renderer/io/atomic_file.h"
#include "renderer/io/exr_file.h"
#include "renderer/io/image_limits.h"
#include "renderer/io/png_metadata.h"
#include "renderer/io/read_file.h"
#include "renderer/io/truncation.h"

namespace guidelight {
namespace {

struct StbDeleter {
  void operator()(void* pixels) const { stbi_image_free(pixels); }
};
template <typename T>
using StbPixels = std::unique_ptr<T, StbDeleter>;

float srgb_to_linear(float v) {
  return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

/// Integer samples to linear floats through a table of all their values; alpha is never encoded.
template <typename Sample>
Image from_integers(const Sample* samples, int width, int height, int channels, bool srgb) {
  constexpr int kLevels = 1 << (8 * sizeof(Sample));
  std::vector<float> decode(kLevels);
  for (int i = 0; i < kLevels; ++i) {
    const float v = static_cast<float>(i) / (kLevels - 1);
    decode[i] = srgb ? srgb_to_linear(v) : v;
  }
  Image image(width, height, channels);
  const std::span<float> out = image.data();
  const int alpha = channels == 2 || channels == 4 ? channels - 1 : -1;
  for (size_t i = 0; i < out.size(); ++i) {
    const bool is_alpha = static_cast<int>(i % channels) == alpha;
    out[i] = is_alpha ? static_cast<float>(samples[i]) / (kLevels - 1) : decode[samples[i]];
  }
  return image;
}

Image decode_with_stb(std::string_view bytes, bool srgb) {
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(data, size, &width, &height, &channels)) {
    throw Error("{}", stbi_failure_reason());
  }
  check_image_size(width, height, channels, bytes.size());
  check_not_truncated(bytes);
  if (stbi_is_hdr_from_memory(data, size)) {
    const StbPixels<float> pixels(
        stbi_loadf_from_memory(data, size, &width, &height, &channels, 3));
    if (!pixels) throw Error("{}", stbi_failure_reason());
    Image image(width, height, 3);
    std::copy_n(pixels.get(), image.data().size(), image.data().begin());
    return image;
  }
  if (stbi_is_16_bit_from_memory(data, size)) {
    const StbPixels<stbi_us> pixels(
        stbi_load_16_from_memory(data, size, &width, &height, &channels, 0));
    if (!pixels) throw Error("{}", stbi_failure_reason());
    return from_integers(pixels.get(), width, height, channels, srgb);
  }
  const StbPixels<stbi_uc> pixels(stbi_load_from_memory(data, size, &width, &height, &channels, 0));
  if (!pixels) throw Error("{}", stbi_failure_reason());
  return from_integers(pixels.get(), width, height, channels, srgb);
}

/// The layer that stands for the picture, at most four channels.
Image decode_exr_picture(std::string_view bytes, const std::string& name) {
  Image image = std::move(decode_exr(bytes, name).layers.front().second);
  if (image.channels() <= 4) return image;
  Image first_four(image.width(), image.height(), 4);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      std::copy_n(image.pixel(x, y), 4, first_four.pixel(x, y));
    }
  }
  return first_four;
}

void linearise(Image& image) {
  const int alpha = image.channels() == 2 || image.channels() == 4 ? image.channels() - 1 : -1;
  const std::span<float> values = image.data();
  for (size_t i = 0; i < values.size(); ++i) {
    if (static_cast<int>(i % image.channels()) != alpha) values[i] = srgb_to_linear(values[i]);
  }
}

}  // namespace

Image read_image(const void* data, size_t size, const std::string& name, ColorSpace space) {
  const std::string_view bytes(static_cast<const char*>(data), size);
  if (is_exr(bytes)) {
    Image image = decode_exr_picture(bytes, name);
    if (space == ColorSpace::Srgb) linearise(image);
    return image;
  }
  try {
    if (size == 0) throw Error("it is empty");
    return decode_with_stb(bytes, space != ColorSpace::Linear);
  } catch (const std::exception& error) {
    throw Error("Cannot read the image '{}': {}; use a PNG, JPEG, HDR, EXR, TGA or BMP file.", name,
                error.what());
  }
}

Image read_image(const std::string& path, ColorSpace space) {
  const std::string bytes = read_file_bytes(path);
  return read_image(bytes.data(), bytes.size(), path, space);
}

void write_png(const std::string& path, const DisplayImage& image, const Metadata& metadata) {
  const size_t expected = static_cast<size_t>(image.width) * image.height * 4;
  if (image.width < 1 || image.height < 1 || image.rgba.size() != expected) {
    throw Error("Cannot write '{}': the picture is empty; render something first.", path);
  }
  std::string png;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<char*>(data), static_cast<size_t>(size));
  };
  if (!stbi_write_png_to_func(append, &png, image.width, image.height, 4, image.rgba.data(),
                              image.width * 4)) {
    throw Error("Cannot write '{}': the picture could not be encoded; free some memory.", path);
  }
  write_file_atomically(path, insert_png_metadata(png, metadata));
}

Metadata read_metadata(const std::string& path) {
  const std::string bytes = read_file_bytes(path);
  if (is_exr(bytes)) return decode_exr_metadata(bytes, path);
  if (is_png(bytes)) return png_metadata(bytes);
  throw Error(
      "Cannot read metadata of '{}': it is neither a PNG nor an EXR; choose a picture that "
      "this program wrote.",
      path);
}

}  // namespace guidelight
