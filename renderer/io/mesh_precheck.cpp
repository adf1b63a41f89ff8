#include "renderer/io/mesh_precheck.h"

#include <charconv>
#include <cstdint>

#include "renderer/error.h"

namespace guidelight {
namespace {

/// The next line without its end; advances `rest`.
std::string_view next_line(std::string_view& rest) {
  const size_t end = rest.find('\n');
  std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string_view next_word(std::string_view& rest) {
  const size_t begin = rest.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  const size_t end = std::min(rest.find_first_of(" \t", begin), rest.size());
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

/// Bytes that one value of a PLY type takes in a binary file.
uint64_t type_size(std::string_view type) {
  if (type == "char" || type == "uchar" || type == "int8" || type == "uint8") return 1;
  if (type == "short" || type == "ushort" || type == "int16" || type == "uint16") return 2;
  if (type == "double" || type == "float64") return 8;
  return 4;
}

}  // namespace

void check_ply(std::string_view bytes) {
  std::string_view rest = bytes;
  if (next_line(rest) != "ply") throw Error("it does not start with 'ply'");
  bool binary = false;
  uint64_t count = 0, size = 0, total = 0;  // of the element being described; of all
  for (;;) {
    if (rest.empty()) throw Error("its header has no end");
    std::string_view line = next_line(rest);
    const std::string_view keyword = next_word(line);
    if (keyword == "format") {
      binary = next_word(line) != "ascii";
    } else if (keyword == "property") {
      const std::string_view type = next_word(line);
      // In text every value takes at least a digit and a separator; a list at least its count.
      size += !binary ? 2 : type == "list" ? type_size(next_word(line)) : type_size(type);
    } else if (keyword == "element" || keyword == "end_header") {
      total += count * size;
      count = size = 0;
      if (keyword == "end_header") break;
      next_word(line);
      const std::string_view number = next_word(line);
      const auto [end, error] =
          std::from_chars(number.data(), number.data() + number.size(), count);
      // Also keeps the products from overflowing.
      if (error != std::errc() || end != number.data() + number.size() || count > bytes.size()) {
        throw Error("an element count '{}' cannot be true for {} bytes", number, bytes.size());
      }
    }
  }
  if (total > rest.size() + 1) {
    throw Error("its header claims {} bytes of data and the file has {}", total, rest.size());
  }
}

void check_obj(std::string_view bytes) {
  if (bytes.find('\0') != std::string_view::npos) throw Error("it is not a text file");
  // Every face makes vertices of its own; the memory per byte is bounded, so the size is.
  constexpr size_t kMaxBytes = size_t{512} << 20;
  if (bytes.size() > kMaxBytes) throw Error("it has {} bytes, more than 512 MiB", bytes.size());
}

}  // namespace guidelight
