#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/error.h"
#include "renderer/math/vector.h"

/// The container side of glTF 2.0 (Khronos 2021): JSON, binary chunks, buffers, accessors. All
/// offsets and counts are checked here.
namespace guidelight::gltf {

using Json = nlohmann::json;

/// Member access that tells what is wrong with a damaged file. Throw Error with the reason only.
const Json* find(const Json& object, const char* name);  // nullptr if absent
float number_of(const Json& object, const char* name, float fallback);
int index_of(const Json& object, const char* name);  // kNone if absent
std::string text_of(const Json& object, const char* name, const std::string& fallback);
std::vector<float> numbers_of(const Json& object, const char* name, std::vector<float> fallback);

class Asset {
 public:
  /// Throws Error naming `path` for a file that is not glTF 2.0.
  Asset(const std::string& path, const std::string& bytes);

  const Json& json() const { return json_; }

  /// Entry `index` of a list of the file such as "meshes".
  const Json& entry(const char* list, int index) const;
  size_t count(const char* list) const;

  /// Values of an accessor as floats, `components` per element; normalised integers become 0..1,
  /// -1..1. Accessors with more components are cut, with fewer refused.
  std::vector<float> floats(int accessor, int components) const;
  int components(int accessor) const;
  std::vector<uint32_t> indices(int accessor) const;

  std::string_view buffer_view(int index) const;
  /// The bytes behind a URI: a data URI or a file beside the scene.
  std::string load_uri(const std::string& uri) const;

 private:
  void parse_binary(const std::string& bytes);
  void parse_json(std::string_view text);
  void load_buffers();
  template <typename Visit>
  void visit_elements(const Json& view_json, const char* view_member, int component_type,
                      int components, size_t count, const Visit& visit) const;

  std::string path_;
  Json json_;
  std::string binary_chunk_;
  bool has_binary_chunk_ = false;
  std::vector<std::string> buffers_;
};

}  // namespace guidelight::gltf
