#include "renderer/io/gltf/asset.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>

#include "renderer/io/read_file.h"
#include "renderer/scene/description.h"

namespace guidelight::gltf {
namespace {

constexpr uint64_t kMaxElements = uint64_t{1} << 26;  // of an accessor

enum ComponentType { kByte = 5120, kUbyte, kShort, kUshort, kUint = 5125, kFloat };

size_t component_size(int type) {
  switch (type) {
    case kByte:
    case kUbyte:
      return 1;
    case kShort:
    case kUshort:
      return 2;
    case kUint:
    case kFloat:
      return 4;
  }
  throw Error("an accessor has the unknown component type {}", type);
}

int component_count(const std::string& type) {
  static const std::array<std::pair<const char*, int>, 7> kTypes = {{{"SCALAR", 1},
                                                                     {"VEC2", 2},
                                                                     {"VEC3", 3},
                                                                     {"VEC4", 4},
                                                                     {"MAT2", 4},
                                                                     {"MAT3", 9},
                                                                     {"MAT4", 16}}};
  for (const auto& [name, count] : kTypes) {
    if (type == name) return count;
  }
  throw Error("an accessor has the unknown type '{}'", type);
}

template <typename T>
T load(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

/// A component as a number; normalised integers as glTF 2.0, 3.11 says.
double component(const char* bytes, int type, bool normalized) {
  switch (type) {
    case kByte:
      return normalized ? std::max(load<int8_t>(bytes) / 127.0, -1.0) : load<int8_t>(bytes);
    case kUbyte:
      return load<uint8_t>(bytes) / (normalized ? 255.0 : 1.0);
    case kShort:
      return normalized ? std::max(load<int16_t>(bytes) / 32767.0, -1.0) : load<int16_t>(bytes);
    case kUshort:
      return load<uint16_t>(bytes) / (normalized ? 65535.0 : 1.0);
    case kUint:
      return load<uint32_t>(bytes);
    default:
      return load<float>(bytes);
  }
}

uint64_t size_member(const Json& object, const char* name, uint64_t fallback) {
  const Json* member = find(object, name);
  if (!member) return fallback;
  if (!member->is_number_unsigned()) throw Error("'{}' is not a size", name);
  return member->get<uint64_t>();
}

std::string decode_base64(std::string_view text) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  uint32_t bits = 0;
  int bit_count = 0;
  for (const char c : text) {
    if (c == '=') break;
    const size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) throw Error("a data URI is not base64");
    bits = bits << 6 | static_cast<uint32_t>(digit);
    bit_count += 6;
    if (bit_count >= 8) {
      bit_count -= 8;
      bytes += static_cast<char>(bits >> bit_count);
    }
  }
  return bytes;
}

/// Undoes percent encoding ("%20").
std::string decode_percent(const std::string& uri) {
  std::string result;
  for (size_t i = 0; i < uri.size(); ++i) {
    const bool coded = uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(uri[i + 1]) &&
                       std::isxdigit(uri[i + 2]);
    result += coded ? static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16)) : uri[i];
    if (coded) i += 2;
  }
  return result;
}

}  // namespace

const Json* find(const Json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto member = object.find(name);
  return member == object.end() ? nullptr : &*member;
}

float number_of(const Json& object, const char* name, float fallback) {
  const Json* member = find(object, name);
  if (!member) return fallback;
  const float value = member->is_number() ? member->get<float>() : kInfinity;
  if (!std::isfinite(value)) throw Error("'{}' is not a finite number", name);
  return value;
}

int index_of(const Json& object, const char* name) {
  const Json* member = find(object, name);
  if (!member) return kNone;
  if (!member->is_number_unsigned() || member->get<uint64_t>() > 0x7fffffff) {
    throw Error("'{}' is not an index", name);
  }
  return member->get<int>();
}

std::string text_of(const Json& object, const char* name, const std::string& fallback) {
  const Json* member = find(object, name);
  return member && member->is_string() ? member->get<std::string>() : fallback;
}

std::vector<float> numbers_of(const Json& object, const char* name, std::vector<float> fallback) {
  const Json* member = find(object, name);
  if (!member) return fallback;
  std::vector<float> values;
  for (const Json& entry : *member) {
    values.push_back(entry.is_number() ? entry.get<float>() : kInfinity);
    if (!std::isfinite(values.back()))
      throw Error("'{}' has an entry that is not a finite number", name);
  }
  if (values.size() != fallback.size()) {
    throw Error("'{}' has {} numbers instead of {}", name, values.size(), fallback.size());
  }
  return values;
}

Asset::Asset(const std::string& path, const std::string& bytes) : path_(path) {
  if (bytes.starts_with("glTF")) {
    parse_binary(bytes);
  } else {
    parse_json(bytes);
  }
  if (!json_.is_object()) throw Error("the JSON is not an object");
  const Json* asset = find(json_, "asset");
  const std::string version = asset ? text_of(*asset, "version", "") : "";
  if (!version.starts_with("2.")) throw Error("it has version '{}' instead of 2.0", version);
  load_buffers();
}

void Asset::parse_json(std::string_view text) {
  try {
    json_ = Json::parse(text.begin(), text.end());
  } catch (const Json::parse_error& error) {
    const size_t at = std::min(error.byte, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<ptrdiff_t>(at), '\n');
    throw Error("the JSON is malformed at line {}", line);
  }
}

/// GLB: a header of 12 bytes, then chunks of length, type and data.
void Asset::parse_binary(const std::string& bytes) {
  if (bytes.size() < 12 || load<uint32_t>(&bytes[4]) != 2) throw Error("its header is not GLB 2");
  bool has_json = false;
  for (size_t at = 12; at + 8 <= bytes.size();) {
    const size_t length = load<uint32_t>(&bytes[at]);
    const std::string_view type(&bytes[at + 4], 4);
    at += 8;
    if (length > bytes.size() - at) throw Error("the file ends too early");
    if (type == "JSON" && !has_json) {
      parse_json(std::string_view(bytes).substr(at, length));
      has_json = true;
    } else if (type == std::string_view("BIN\0", 4) && !has_binary_chunk_) {
      binary_chunk_ = bytes.substr(at, length);
      has_binary_chunk_ = true;
    }
    at += length;
  }
  if (!has_json) throw Error("it has no JSON chunk");
}

void Asset::load_buffers() {
  for (size_t i = 0; i < count("buffers"); ++i) {
    const Json& buffer = entry("buffers", static_cast<int>(i));
    const std::string uri = text_of(buffer, "uri", "");
    if (uri.empty() && !(i == 0 && has_binary_chunk_)) throw Error("buffers[{}] has no data", i);
    std::string data = uri.empty() ? binary_chunk_ : load_uri(uri);
    const uint64_t length = size_member(buffer, "byteLength", 0);
    if (data.size() < length) {
      throw Error("buffers[{}] has {} bytes instead of {}", i, data.size(), length);
    }
    buffers_.push_back(std::move(data));
  }
}

std::string Asset::load_uri(const std::string& uri) const {
  if (uri.starts_with("data:")) {
    const size_t comma = uri.find(',');
    if (comma == std::string::npos || uri.rfind(";base64", comma) == std::string::npos) {
      throw Error("a data URI is not base64");
    }
    return decode_base64(std::string_view(uri).substr(comma + 1));
  }
  const std::filesystem::path folder = std::filesystem::path(path_).parent_path();
  return read_file_bytes((folder / decode_percent(uri)).string());
}

size_t Asset::count(const char* list) const {
  const Json* entries = find(json_, list);
  return entries && entries->is_array() ? entries->size() : 0;
}

const Json& Asset::entry(const char* list, int index) const {
  if (index < 0 || static_cast<size_t>(index) >= count(list)) {
    throw Error("{}[{}] is used and there are {}", list, index, count(list));
  }
  return json_[list][static_cast<size_t>(index)];
}

std::string_view Asset::buffer_view(int index) const {
  const Json& view = entry("bufferViews", index);
  const int buffer = index_of(view, "buffer");
  entry("buffers", buffer);
  const std::string_view data = buffers_[static_cast<size_t>(buffer)];
  const uint64_t offset = size_member(view, "byteOffset", 0);
  const uint64_t length = size_member(view, "byteLength", 0);
  if (offset > data.size() || length > data.size() - offset) {
    throw Error("bufferViews[{}] leaves its buffer", index);
  }
  return data.substr(offset, length);
}

/// Calls visit(element, component, bytes) for all components that a buffer view holds.
template <typename Visit>
void Asset::visit_elements(const Json& view_json, const char* view_member, int component_type,
                           int components, size_t count, const Visit& visit) const {
  const int view_index = index_of(view_json, view_member);
  const std::string_view bytes = buffer_view(view_index);
  const size_t size = component_size(component_type);
  const size_t packed = size * static_cast<size_t>(components);
  const uint64_t stride = size_member(entry("bufferViews", view_index), "byteStride", packed);
  const uint64_t offset = size_member(view_json, "byteOffset", 0);
  if (stride < packed || stride > 252 + packed)
    throw Error("a stride of {} bytes is wrong", stride);
  // In steps that cannot overflow: count is below kMaxElements.
  if (count > 0 &&
      (offset > bytes.size() || (count - 1) * stride + packed > bytes.size() - offset)) {
    throw Error("an accessor leaves its buffer view");
  }
  for (size_t i = 0; i < count; ++i) {
    for (int c = 0; c < components; ++c) {
      visit(i, c, bytes.data() + offset + i * stride + static_cast<size_t>(c) * size);
    }
  }
}

int Asset::components(int accessor) const {
  return component_count(text_of(entry("accessors", accessor), "type", ""));
}

std::vector<float> Asset::floats(int accessor, int wanted) const {
  const Json& json = entry("accessors", accessor);
  const int available = components(accessor);
  if (available < wanted) {
    throw Error("accessors[{}] has {} components instead of {}", accessor, available, wanted);
  }
  const int type = index_of(json, "componentType");
  const Json* normalized_member = find(json, "normalized");
  const bool normalized =
      normalized_member && normalized_member->is_boolean() && normalized_member->get<bool>();
  const uint64_t count = size_member(json, "count", 0);
  const Json* sparse = find(json, "sparse");
  const bool backed = find(json, "bufferView");
  if (count > kMaxElements || (!backed && count > kMaxElements / 16)) {
    throw Error("accessors[{}] claims {} elements", accessor, count);
  }
  const auto read = [&](const Json& source, size_t n, const auto& store) {
    visit_elements(source, "bufferView", type, available, n,
                   [&](size_t i, int c, const char* bytes) {
                     if (c < wanted)
                       store(i, c, static_cast<float>(component(bytes, type, normalized)));
                   });
  };
  // Checked before it is allocated: a view that is too small throws in here.
  std::vector<float> values;
  if (backed) {
    values.reserve(std::min<uint64_t>(count, buffer_view(index_of(json, "bufferView")).size()) *
                   static_cast<size_t>(wanted));
    read(json, count, [&](size_t, int, float v) { values.push_back(v); });
  } else {
    values.assign(count * static_cast<size_t>(wanted), 0.0f);
  }
  if (sparse) {
    const uint64_t changed = size_member(*sparse, "count", 0);
    const Json& where = sparse->at("indices");
    if (changed > count) throw Error("accessors[{}] replaces more elements than it has", accessor);
    std::vector<size_t> targets(changed);
    const int index_type = index_of(where, "componentType");
    visit_elements(where, "bufferView", index_type, 1, changed,
                   [&](size_t i, int, const char* bytes) {
                     targets[i] = static_cast<size_t>(component(bytes, index_type, false));
                     if (targets[i] >= count)
                       throw Error("accessors[{}] replaces an element it has not", accessor);
                   });
    read(sparse->at("values"), changed, [&](size_t i, int c, float v) {
      values[targets[i] * static_cast<size_t>(wanted) + static_cast<size_t>(c)] = v;
    });
  }
  return values;
}

std::vector<uint32_t> Asset::indices(int accessor) const {
  const Json& json = entry("accessors", accessor);
  const int type = index_of(json, "componentType");
  if (components(accessor) != 1 || type == kFloat) {
    throw Error("accessors[{}] holds no indices", accessor);
  }
  const uint64_t count = size_member(json, "count", 0);
  if (count > kMaxElements) throw Error("accessors[{}] claims {} elements", accessor, count);
  std::vector<uint32_t> values;
  visit_elements(json, "bufferView", type, 1, count, [&](size_t, int, const char* bytes) {
    values.push_back(static_cast<uint32_t>(component(bytes, type, false)));
  });
  return values;
}

}  // namespace guidelight::gltf
