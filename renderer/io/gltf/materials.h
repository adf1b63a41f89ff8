#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>

#include "renderer/io/gltf/asset.h"
#include "renderer/scene/description.h"

namespace guidelight::gltf {

/// Warnings about one file, each subject once.
class Notices {
 public:
  Notices(std::string path, std::vector<std::string>& sentences)
      : path_(std::move(path)), sentences_(sentences) {}

  void add(const std::string& sentence) {
    if (seen_.insert(sentence).second) sentences_.push_back(path_ + ": " + sentence);
  }

 private:
  std::string path_;
  std::vector<std::string>& sentences_;
  std::set<std::string> seen_;
};

/// What a primitive takes from its material.
struct Surface {
  int bsdf = kNone;
  std::optional<ColorInput> radiance;
  int interior = kNone;  // medium
  int uv_set = 0;        // TEXCOORD_n
};

/// Materials of a glTF file as BSDFs. The mapping is described in docs/scene-formats.md.
class Materials {
 public:
  Materials(const Asset& asset, SceneDescription& scene, Notices& notices)
      : asset_(asset), scene_(scene), notices_(notices) {}

  /// Material `index`, or the default one for kNone, for a mesh with or without vertex colours.
  Surface surface(int index, bool vertex_colors);

 private:
  /// How the pixels of an image are prepared.
  enum class Use { Color, Data, SquaredRoughness, AlphaMask, Normal };

  Surface make_surface(const Json& material, bool vertex_colors);
  int opaque_bsdf(const Json& material, const std::string& name, const ColorInput& base);
  int add_bsdf(const std::string& name, decltype(BsdfDescription::model) model);
  ColorInput base_color(const Json& metallic_roughness, bool vertex_colors);
  FloatInput roughness_squared(const Json& metallic_roughness);
  int transmit(const Json& material, const std::string& name, const ColorInput& base, int opaque,
               Surface& surface);
  int mask(const Json& material, const std::string& name, int nested);
  int interior_medium(const Json& volume, const std::string& name);

  /// Index of the texture that `info` names (kNone without), prepared; `parameter` is the strength
  /// of a normal map or the cutoff of a mask.
  int texture(const Json* info, Use use, float parameter = 1);
  std::shared_ptr<const Image> image(int source, Use use, float parameter);

  const Asset& asset_;
  SceneDescription& scene_;
  Notices& notices_;
  std::map<std::tuple<int, bool>, Surface> surfaces_;
  std::map<std::tuple<int, Use, float>, std::shared_ptr<const Image>> images_;
  std::set<int> uv_sets_;  // of the material being read
};

}  // namespace guidelight::gltf
