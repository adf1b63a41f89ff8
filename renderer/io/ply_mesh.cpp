#include "renderer/io/ply_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <optional>
#include <string>

#include "renderer/error.h"

namespace guidelight {
namespace {

static_assert(std::endian::native == std::endian::little);

enum class Encoding { Text, LittleEndian, BigEndian };
enum class Type { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

struct Property {
  std::string name;
  Type type = Type::Float32;
  std::optional<Type> count_type;  // of a list
};

struct Element {
  std::string name;
  uint64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::Text;
  std::vector<Element> elements;
};

size_t size_of(Type type) {
  constexpr std::array<size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<size_t>(type)];
}

Type parse_type(std::string_view name) {
  constexpr std::array<std::array<std::string_view, 2>, 8> kNames = {{{"char", "int8"},
                                                                      {"uchar", "uint8"},
                                                                      {"short", "int16"},
                                                                      {"ushort", "uint16"},
                                                                      {"int", "int32"},
                                                                      {"uint", "uint32"},
                                                                      {"float", "float32"},
                                                                      {"double", "float64"}}};
  for (size_t i = 0; i < kNames.size(); ++i) {
    if (name == kNames[i][0] || name == kNames[i][1]) return static_cast<Type>(i);
  }
  throw Error("its header has the unknown type '{}'", name);
}

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view kSpaces = " \t\r";
  std::vector<std::string_view> words;
  for (size_t begin = line.find_first_not_of(kSpaces); begin != std::string_view::npos;) {
    const size_t end = std::min(line.find_first_of(kSpaces, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kSpaces, end);
  }
  return words;
}

uint64_t parse_count(std::string_view text, size_t file_bytes) {
  uint64_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc() || end != text.data() + text.size() || count > file_bytes) {
    throw Error("an element count of '{}' cannot be true for {} bytes", text, file_bytes);
  }
  return count;
}

/// Reads up to and with "end_header"; `rest` is left at the data.
Header parse_header(std::string_view& rest) {
  const size_t file_bytes = rest.size();
  Header header;
  for (bool first = true;; first = false) {
    const size_t end = rest.find('\n');
    if (end == std::string_view::npos) throw Error("its header has no end");
    const std::vector<std::string_view> words = words_of(rest.substr(0, end));
    rest.remove_prefix(end + 1);
    if (first && (words.empty() || words[0] != "ply")) throw Error("it does not start with 'ply'");
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info" || first) continue;
    if (words[0] == "end_header") return header;
    if (words[0] == "format" && words.size() >= 2) {
      header.encoding = words[1] == "ascii"                  ? Encoding::Text
                        : words[1] == "binary_little_endian" ? Encoding::LittleEndian
                                                             : Encoding::BigEndian;
    } else if (words[0] == "element" && words.size() >= 3) {
      header.elements.push_back({std::string(words[1]), parse_count(words[2], file_bytes), {}});
    } else if (words[0] == "property" && !header.elements.empty() && words.size() >= 3) {
      const bool list = words[1] == "list";
      if (list && words.size() < 5) throw Error("its header is damaged");
      Property property{std::string(words[list ? 4 : 2]), parse_type(words[list ? 3 : 1]), {}};
      if (list) property.count_type = parse_type(words[2]);
      header.elements.back().properties.push_back(property);
    } else {
      throw Error("its header is damaged");
    }
  }
}

/// The values after the header, one after another.
class Values {
 public:
  Values(std::string_view data, Encoding encoding) : data_(data), encoding_(encoding) {}

  double next(Type type) { return encoding_ == Encoding::Text ? next_text() : next_binary(type); }
  size_t bytes_left() const { return data_.size(); }

 private:
  double next_text() {
    const size_t begin = data_.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) throw Error("the file ends too early");
    data_.remove_prefix(begin);
    double value = 0;
    const auto [end, error] = std::from_chars(data_.data(), data_.data() + data_.size(), value);
    if (error == std::errc::invalid_argument) throw Error("a value is not a number");
    data_.remove_prefix(static_cast<size_t>(end - data_.data()));
    return value;
  }

  double next_binary(Type type) {
    const size_t size = size_of(type);
    if (data_.size() < size) throw Error("the file ends too early");
    std::array<char, 8> bytes{};
    for (size_t i = 0; i < size; ++i) {
      bytes[i] = data_[encoding_ == Encoding::BigEndian ? size - 1 - i : i];
    }
    data_.remove_prefix(size);
    const auto as = [&]<typename T>(T value) {
      std::memcpy(&value, bytes.data(), sizeof(T));
      return static_cast<double>(value);
    };
    switch (type) {
      case Type::Int8:
        return as(int8_t{});
      case Type::Uint8:
        return as(uint8_t{});
      case Type::Int16:
        return as(int16_t{});
      case Type::Uint16:
        return as(uint16_t{});
      case Type::Int32:
        return as(int32_t{});
      case Type::Uint32:
        return as(uint32_t{});
      case Type::Float32:
        return as(float{});
      case Type::Float64:
        return as(double{});
    }
    return 0;
  }

  std::string_view data_;
  Encoding encoding_;
};

/// Places of a vertex's values: position 0–2, normal 3–5, uv 6–7, colour 8–10; -1 for all others.
int vertex_slot(const std::string& name) {
  constexpr std::array<std::array<std::string_view, 4>, 11> kNames = {
      {{"x"},
       {"y"},
       {"z"},
       {"nx"},
       {"ny"},
       {"nz"},
       {"u", "s", "texture_u"},
       {"v", "t", "texture_v"},
       {"red", "r", "diffuse_red"},
       {"green", "g", "diffuse_green"},
       {"blue", "b", "diffuse_blue"}}};
  for (size_t slot = 0; slot < kNames.size(); ++slot) {
    for (const std::string_view candidate : kNames[slot]) {
      if (!candidate.empty() && candidate == name) return static_cast<int>(slot);
    }
  }
  return -1;
}

/// What one unit of an integer colour is worth.
float color_scale(Type type) {
  if (type == Type::Uint8) return 1.0f / 255;
  if (type == Type::Uint16) return 1.0f / 65535;
  return 1;
}

void skip_list(Values& values, const Property& property) {
  const double count = values.next(*property.count_type);
  for (double i = 0; i < count; ++i) values.next(property.type);
}

void read_vertices(const Element& element, Values& values, Mesh& mesh) {
  std::array<bool, 11> present{};
  std::vector<int> slots;
  for (const Property& property : element.properties) {
    slots.push_back(property.count_type ? -1 : vertex_slot(property.name));
    if (slots.back() >= 0) present[slots.back()] = true;
  }
  if (!present[0] || !present[1] || !present[2]) throw Error("its vertices have no x, y and z");
  const bool normals = present[3] && present[4] && present[5];
  const bool uvs = present[6] && present[7];
  const bool colors = present[8] && present[9] && present[10];
  for (uint64_t i = 0; i < element.count; ++i) {
    std::array<float, 11> v{};
    for (size_t p = 0; p < slots.size(); ++p) {
      const Property& property = element.properties[p];
      if (property.count_type) {
        skip_list(values, property);
        continue;
      }
      const auto value = static_cast<float>(values.next(property.type));
      if (slots[p] >= 0) v[slots[p]] = slots[p] >= 8 ? value * color_scale(property.type) : value;
    }
    mesh.positions.emplace_back(v[0], v[1], v[2]);
    if (normals) mesh.normals.emplace_back(v[3], v[4], v[5]);
    if (uvs) mesh.uvs.emplace_back(v[6], v[7]);
    if (colors) mesh.colors.emplace_back(v[8], v[9], v[10]);
  }
}

/// Polygons become fans.
void read_face(Values& values, const Property& property, Mesh& mesh) {
  const double count = values.next(*property.count_type);
  if (!(count >= 0 && count <= static_cast<double>(values.bytes_left()))) {
    throw Error("a face claims {} corners", count);
  }
  std::array<uint32_t, 3> triangle{};
  for (uint64_t i = 0; i < static_cast<uint64_t>(count); ++i) {
    const double index = values.next(property.type);
    // Everything wrong becomes an index that the check of the mesh refuses.
    const bool valid = index >= 0 && index < 4294967295.0;
    const uint32_t vertex = valid ? static_cast<uint32_t>(index) : 0xffffffffu;
    if (i >= 3) triangle[1] = triangle[2];
    triangle[std::min<uint64_t>(i, 2)] = vertex;
    if (i >= 2) mesh.triangles.push_back(triangle);
  }
}

void read_faces(const Element& element, Values& values, Mesh& mesh) {
  for (uint64_t i = 0; i < element.count; ++i) {
    for (const Property& property : element.properties) {
      const bool indices = property.name == "vertex_indices" || property.name == "vertex_index";
      if (property.count_type && indices) {
        read_face(values, property, mesh);
      } else if (property.count_type) {
        skip_list(values, property);
      } else {
        values.next(property.type);
      }
    }
  }
}

}  // namespace

Mesh decode_ply(std::string_view bytes) {
  const Header header = parse_header(bytes);
  Values values(bytes, header.encoding);
  Mesh mesh;
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;
    if (element.name == "vertex") {
      read_vertices(element, values, mesh);
    } else {  // of other elements no property is called vertex_indices
      read_faces(element, values, mesh);
    }
  }
  return mesh;
}

}  // namespace guidelight
