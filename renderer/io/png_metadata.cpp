#include "renderer/io/png_metadata.h"

#include <zlib.h>

#include <algorithm>

#include "renderer/error.h"

namespace guidelight {
namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
constexpr size_t kHeaderEnd = 8 + 12 + 13;  // signature and the IHDR chunk
constexpr size_t kMaxKey = 79;

void append_big_endian(std::string& out, uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(value >> shift);
}

uint32_t read_big_endian(std::string_view bytes) {
  uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<uint8_t>(bytes[i]);
  return value;
}

uint32_t checksum(std::string_view bytes) {
  return static_cast<uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return static_cast<uint8_t>(c) < 128; });
}

std::string text_chunk(const std::string& key, const std::string& value) {
  const bool ascii = is_ascii(value);
  std::string body = ascii ? "tEXt" : "iTXt";
  body += key.substr(0, kMaxKey);
  body += '\0';
  // iTXt: compression flag and method, then empty language tag and translated keyword.
  if (!ascii) body.append(4, '\0');
  body += value;
  std::string chunk;
  append_big_endian(chunk, static_cast<uint32_t>(body.size() - 4));
  chunk += body;
  append_big_endian(chunk, checksum(body));
  return chunk;
}

/// Adds the key and value of a text chunk's data.
void parse_text(bool international, std::string_view data, Metadata& metadata) {
  const size_t end = data.find('\0');
  if (end == std::string_view::npos) return;
  const std::string key(data.substr(0, end));
  std::string_view rest = data.substr(end + 1);
  if (international) {
    if (rest.size() < 2 || rest[0] != 0) return;
    rest.remove_prefix(2);
    for (int field = 0; field < 2; ++field) {
      const size_t stop = rest.find('\0');
      if (stop == std::string_view::npos) return;
      rest.remove_prefix(stop + 1);
    }
  }
  metadata[key] = std::string(rest);
}

}  // namespace

bool is_png(std::string_view bytes) { return bytes.substr(0, 8) == kSignature; }

std::string insert_png_metadata(const std::string& png, const Metadata& metadata) {
  std::string chunks;
  for (const auto& [key, value] : metadata) {
    if (!key.empty()) chunks += text_chunk(key, value);
  }
  return png.substr(0, kHeaderEnd) + chunks + png.substr(kHeaderEnd);
}

Metadata png_metadata(std::string_view png) {
  Metadata metadata;
  size_t position = kSignature.size();
  while (position + 12 <= png.size()) {
    const size_t length = read_big_endian(png.substr(position, 4));
    if (length > png.size() - position - 12) break;
    const std::string_view type = png.substr(position + 4, 4);
    const std::string_view data = png.substr(position + 8, length);
    if (type == "tEXt" || type == "iTXt") parse_text(type == "iTXt", data, metadata);
    position += length + 12;
  }
  return metadata;
}

}  // namespace guidelight
