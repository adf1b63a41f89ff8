#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>

#include "renderer/io/mitsuba/document.h"
#include "renderer/io/mitsuba/properties.h"
#include "renderer/scene/description.h"

namespace guidelight::mitsuba {

/// Turns a document into a description. One object reads one scene; its parts stand in files of
/// their own (textures.cpp, bsdfs.cpp, shapes.cpp, emitters.cpp, sensors.cpp, media.cpp).
class Importer {
 public:
  Importer(const Document& document, SceneDescription& scene)
      : document_(document), scene_(scene), warnings_(scene.warnings) {}

  void import_scene();

 private:
  // textures.cpp
  ColorInput color_input(const Node& node, SpectrumUse use);
  ColorInput color(Properties& properties, Properties::Names names, Color fallback,
                   SpectrumUse use = SpectrumUse::Reflectance);
  Color constant_color(Properties& properties, Properties::Names names, Color fallback,
                       SpectrumUse use);
  FloatInput number(Properties& properties, Properties::Names names, float fallback);
  /// Index of a texture, kNone for one that is constant.
  int texture(const Node& node);
  BitmapTexture bitmap(Properties& properties);
  CheckerboardTexture checkerboard(Properties& properties);
  Mat3 uv_transform(Properties& properties);
  Color spectrum_plugin(const Node& node, SpectrumUse use);
  Color spectrum_file(const Node& node, const std::string& name, SpectrumUse use);
  std::shared_ptr<const Image> image(Properties& properties, bool raw);

  // bsdfs.cpp
  using BsdfModel = decltype(BsdfDescription::model);
  int bsdf(const Node& node);
  /// Empty for a plugin that is not supported.
  std::optional<BsdfModel> bsdf_model(Properties& properties);
  BsdfModel conductor(Properties& properties, bool rough);
  BsdfModel dielectric(Properties& properties, bool rough);
  BsdfModel thin_dielectric(Properties& properties);
  BsdfModel plastic(Properties& properties, bool rough);
  BsdfModel phong(Properties& properties);
  BsdfModel ward(Properties& properties);
  BsdfModel coating(Properties& properties, bool rough);
  BsdfModel blend(Properties& properties);
  BsdfModel mixture(Properties& properties);
  BsdfModel two_sided(Properties& properties);
  BsdfModel normal_map(Properties& properties);
  BsdfModel bump_map(Properties& properties);
  BsdfModel principled(Properties& properties);
  FloatInput squared(const Node& node, const FloatInput& input);
  int nested_bsdf(Properties& properties);
  int add_bsdf(const Node& node, const std::string& suffix, BsdfModel model);
  float ior(Properties& properties, Properties::Names names, float fallback);
  Microfacet distribution(Properties& properties);
  void roughness(Properties& properties, FloatInput& alpha_u, FloatInput& alpha_v);

  // media.cpp
  int medium(const Node& node);

  // shapes.cpp
  /// Empty for a shape that is not supported or has no surface.
  std::optional<ShapeDescription> shape(const Node& node);
  /// The shape if there is anything of it to see; otherwise warns.
  std::optional<ShapeDescription> drawable(const Node& node, ShapeDescription shape);
  bool geometry(Properties& properties, ShapeDescription& shape);
  std::shared_ptr<const Mesh> mesh(Properties& properties);
  void attach(Properties& properties, ShapeDescription& shape);
  int group(const Node& node);
  std::vector<ShapeDescription> shapes_of(const Node& node);

  // emitters.cpp
  using EmitterModel = decltype(EmitterDescription::model);
  void emitter(const Node& node);
  std::optional<EmitterModel> emitter_model(Properties& properties);
  SpotEmitter spot(Properties& properties);
  SunSkyEmitter sun_sky(Properties& properties);
  ProjectorEmitter projector(Properties& properties);
  std::shared_ptr<const Image> projected_image(Properties& properties, float& scale);

  // sensors.cpp
  void sensor(const Node& node);
  /// The angle [degrees] and what it is measured along, of a sensor or a projector.
  std::pair<float, FovAxis> field_of_view(Properties& properties);
  void film(const Node& node);
  void reconstruction_filter(const Node& node);
  void integrator(const Node& node);

  const Document& document_;
  SceneDescription& scene_;
  Warnings warnings_;

  std::map<const Node*, ColorInput> textures_;
  std::map<const Node*, int> bsdfs_;
  std::map<const Node*, int> media_;
  std::map<const Node*, int> groups_;
  std::map<std::tuple<std::string, bool>, std::shared_ptr<const Image>> images_;  // path, raw
  std::map<std::string, std::shared_ptr<const Mesh>> meshes_;  // by path and settings
  std::set<const Node*> seen_shapes_;
  int repeated_shapes_ = 0;
  bool has_sensor_ = false;
};

}  // namespace guidelight::mitsuba
