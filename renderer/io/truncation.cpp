#include "renderer/io/truncation.h"

#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "renderer/error.h"

namespace guidelight {
namespace {

uint8_t byte_at(std::string_view bytes, size_t i) {
  if (i >= bytes.size()) throw Error("the file ends too early");
  return static_cast<uint8_t>(bytes[i]);
}

uint32_t little_endian(std::string_view bytes, size_t offset, int count) {
  uint32_t value = 0;
  for (int i = count - 1; i >= 0; --i) value = value << 8 | byte_at(bytes, offset + i);
  return value;
}

void require_size(std::string_view bytes, uint64_t needed) {
  if (bytes.size() < needed) throw Error("the file ends too early");
}

void check_end(std::string_view bytes, std::string_view end_marker) {
  if (bytes.rfind(end_marker) == std::string_view::npos) throw Error("the file ends too early");
}

/// Walks the run-length code of Radiance's RGBE scanlines (Ward 1991, "Real Pixels").
void check_hdr(std::string_view bytes) {
  const size_t header_end = bytes.find("\n\n");
  const size_t line_end =
      header_end == std::string_view::npos ? header_end : bytes.find('\n', header_end + 2);
  if (line_end == std::string_view::npos) throw Error("the file ends too early");
  const std::string size_line(bytes.substr(header_end + 2, line_end - header_end - 2));
  long height = 0, width = 0;
  if (std::sscanf(size_line.c_str(), "-Y %ld +X %ld", &height, &width) != 2)
    return;  // stb refuses it
  size_t i = line_end + 1;
  if (width < 8 || width >= 32768) {  // flat, never run-length coded
    require_size(bytes, i + uint64_t(width) * uint64_t(height) * 4);
    return;
  }
  for (long y = 0; y < height; ++y) {
    const bool coded =
        byte_at(bytes, i) == 2 && byte_at(bytes, i + 1) == 2 && (byte_at(bytes, i + 2) & 0x80) == 0;
    if (!coded) {  // stb reads such a file as flat pixels
      if (y > 0) throw Error("a scanline is damaged");
      require_size(bytes, i + uint64_t(width) * uint64_t(height) * 4);
      return;
    }
    i += 4;
    for (int channel = 0; channel < 4; ++channel) {
      for (long x = 0; x < width;) {
        const int count = byte_at(bytes, i);
        const bool run = count > 128;
        if (count == 0) throw Error("a scanline is damaged");
        x += run ? count - 128 : count;
        i += run ? 2 : 1 + count;
      }
    }
  }
  require_size(bytes, i);
}

void check_bmp(std::string_view bytes) {
  const uint64_t pixels_at = little_endian(bytes, 10, 4);
  const uint32_t header_size = little_endian(bytes, 14, 4);
  if (header_size < 40) return;
  const int64_t width = static_cast<int32_t>(little_endian(bytes, 18, 4));
  const int64_t height =
      std::abs(static_cast<int64_t>(static_cast<int32_t>(little_endian(bytes, 22, 4))));
  const uint32_t bits = little_endian(bytes, 28, 2);
  const uint64_t row = (static_cast<uint64_t>(width) * bits + 31) / 32 * 4;
  require_size(bytes, pixels_at + row * static_cast<uint64_t>(height));
}

void check_tga(std::string_view bytes) {
  const uint32_t color_map = little_endian(bytes, 1, 1);
  const uint32_t type = little_endian(bytes, 2, 1);
  const bool known = color_map <= 1 && ((type >= 1 && type <= 3) || (type >= 9 && type <= 11));
  if (!known) throw Error("its format is not known");
  const uint64_t pixels = uint64_t{little_endian(bytes, 12, 2)} * little_endian(bytes, 14, 2);
  const uint64_t palette =
      uint64_t{little_endian(bytes, 5, 2)} * ((little_endian(bytes, 7, 1) + 7) / 8);
  const uint64_t pixel_bytes = (little_endian(bytes, 16, 1) + 7) / 8;
  uint64_t at = 18 + little_endian(bytes, 0, 1) + palette;
  if (type < 9) return require_size(bytes, at + pixels * pixel_bytes);
  for (uint64_t done = 0; done < pixels;) {  // packets of equal or of different pixels
    const uint8_t packet = byte_at(bytes, at);
    const uint64_t count = (packet & 0x7f) + 1;
    at += 1 + pixel_bytes * (packet & 0x80 ? 1 : count);
    done += count;
  }
  require_size(bytes, at);
}

}  // namespace

void check_not_truncated(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\x89PNG")) return check_end(bytes, "IEND");
  if (bytes.starts_with("\xff\xd8\xff")) return check_end(bytes, "\xff\xd9");
  if (bytes.starts_with("#?")) return check_hdr(bytes);
  if (bytes.starts_with("BM")) return check_bmp(bytes);
  for (const std::string_view other : {"GIF8"sv, "8BPS"sv, "P5"sv, "P6"sv, "\x53\x80\xf6\x34"sv}) {
    if (bytes.starts_with(other)) throw Error("its format is not supported");
  }
  check_tga(bytes);
}

}  // namespace guidelight
