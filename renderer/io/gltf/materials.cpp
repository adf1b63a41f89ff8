#include "renderer/io/gltf/materials.h"

#include <algorithm>

#include "renderer/io/image_file.h"

namespace guidelight::gltf {
namespace {

const Json kEmpty = Json::object();

const Json& member_or_empty(const Json& object, const char* name) {
  const Json* member = find(object, name);
  return member ? *member : kEmpty;
}

const Json* extension(const Json& object, const char* name) {
  return find(member_or_empty(object, "extensions"), name);
}

Color color_of(const Json& object, const char* name, Color fallback) {
  const std::vector<float> v = numbers_of(object, name, {fallback.r, fallback.g, fallback.b});
  return {v[0], v[1], v[2]};
}

Image single_channel(const Image& source, int channel, float (*map)(float, float),
                     float parameter) {
  Image result(source.width(), source.height(), 1);
  const int available = std::min(channel, source.channels() - 1);
  for (size_t i = 0; i < source.pixel_count(); ++i) {
    result.data()[i] = map(source.data()[i * source.channels() + available], parameter);
  }
  return result;
}

/// Scales the tilt of a tangent-space normal map.
void scale_normals(Image& image, float strength) {
  if (strength == 1 || image.channels() < 3) return;
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    float* p = &image.data()[i * image.channels()];
    for (int c = 0; c < 2; ++c) p[c] = std::clamp(0.5f + (p[c] - 0.5f) * strength, 0.0f, 1.0f);
  }
}

WrapMode wrap_mode(const Json& sampler, const char* name) {
  switch (static_cast<int>(number_of(sampler, name, 10497))) {
    case 33071:
      return WrapMode::Clamp;
    case 33648:
      return WrapMode::Mirror;
    default:
      return WrapMode::Repeat;
  }
}

/// KHR_texture_transform: scale, then a turn that is counter-clockwise in a picture whose v grows
/// downwards, then offset. In the end v changes direction, since glTF has v = 0 at the top row.
Mat3 uv_transform(const Json* transform) {
  const Mat3 flip(Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 1, 1));
  if (!transform) return flip;
  const std::vector<float> offset = numbers_of(*transform, "offset", {0, 0});
  const std::vector<float> scale = numbers_of(*transform, "scale", {1, 1});
  const float angle = number_of(*transform, "rotation", 0);
  const float c = std::cos(angle), s = std::sin(angle);
  return flip * Mat3(Vec3(c * scale[0], -s * scale[0], 0), Vec3(s * scale[1], c * scale[1], 0),
                     Vec3(offset[0], offset[1], 1));
}

}  // namespace

Surface Materials::surface(int index, bool vertex_colors) {
  const auto [known, is_new] = surfaces_.try_emplace({index, vertex_colors});
  if (is_new) {
    const Json& material = index == kNone ? kEmpty : asset_.entry("materials", index);
    known->second = make_surface(material, vertex_colors);
  }
  return known->second;
}

int Materials::add_bsdf(const std::string& name, decltype(BsdfDescription::model) model) {
  scene_.bsdfs.push_back({name, 0, std::move(model)});
  return static_cast<int>(scene_.bsdfs.size()) - 1;
}

Surface Materials::make_surface(const Json& material, bool vertex_colors) {
  uv_sets_.clear();
  Surface surface;
  const std::string name = text_of(material, "name", "");
  const ColorInput base =
      base_color(member_or_empty(material, "pbrMetallicRoughness"), vertex_colors);
  surface.bsdf = opaque_bsdf(material, name, base);
  surface.bsdf = transmit(material, name, base, surface.bsdf, surface);
  if (const Json* info = find(material, "normalTexture")) {
    const int map = texture(info, Use::Normal, number_of(*info, "scale", 1));
    surface.bsdf = add_bsdf(name + " (normal map)", NormalMapBsdf{map, surface.bsdf, true});
  }
  surface.bsdf = mask(material, name, surface.bsdf);

  const Json* strength = extension(material, "KHR_materials_emissive_strength");
  const float scale = strength ? number_of(*strength, "emissiveStrength", 1) : 1;
  const Color emitted = scale * color_of(material, "emissiveFactor", Color(0));
  if (!is_black(emitted)) {
    surface.radiance = ColorInput{emitted, texture(find(material, "emissiveTexture"), Use::Color)};
  }
  for (const char* unsupported :
       {"KHR_materials_clearcoat", "KHR_materials_sheen", "KHR_materials_iridescence",
        "KHR_materials_anisotropy", "KHR_materials_unlit", "KHR_materials_dispersion",
        "KHR_materials_pbrSpecularGlossiness"}) {
    if (extension(material, unsupported)) {
      notices_.add(
          fmt::format("the extension '{}' of materials is not supported; they are drawn "
                      "without it.",
                      unsupported));
    }
  }
  if (uv_sets_.size() > 1) {
    notices_.add("a material uses several sets of texture coordinates; only the first is used.");
  }
  surface.uv_set = uv_sets_.empty() ? 0 : *uv_sets_.begin();
  return surface;
}

ColorInput Materials::base_color(const Json& metallic_roughness, bool vertex_colors) {
  const std::vector<float> factor = numbers_of(metallic_roughness, "baseColorFactor", {1, 1, 1, 1});
  ColorInput base{Color(factor[0], factor[1], factor[2]),
                  texture(find(metallic_roughness, "baseColorTexture"), Use::Color)};
  if (!vertex_colors) return base;
  if (base.texture != kNone) {
    notices_.add("vertex colours together with a texture are not supported; the texture is used.");
    return base;
  }
  scene_.textures.push_back({"vertex colours", 0, VertexColorTexture{}});
  base.texture = static_cast<int>(scene_.textures.size()) - 1;
  return base;
}

/// α of the microfacet models; glTF 2.0, appendix B.2.2: α = roughness².
FloatInput Materials::roughness_squared(const Json& metallic_roughness) {
  const float factor = number_of(metallic_roughness, "roughnessFactor", 1);
  return {sqr(factor),
          texture(find(metallic_roughness, "metallicRoughnessTexture"), Use::SquaredRoughness)};
}

/// Metallic-roughness as a blend of plastic and metal, visible from both sides.
int Materials::opaque_bsdf(const Json& material, const std::string& name, const ColorInput& base) {
  const Json& parameters = member_or_empty(material, "pbrMetallicRoughness");
  const float metallic = std::clamp(number_of(parameters, "metallicFactor", 1), 0.0f, 1.0f);
  const int metallic_texture =
      metallic > 0 ? texture(find(parameters, "metallicRoughnessTexture"), Use::Data) : kNone;
  const FloatInput alpha = roughness_squared(parameters);

  int bsdf = kNone;
  if (metallic < 1 || metallic_texture != kNone) {
    PlasticBsdf plastic;
    const Json* ior = extension(material, "KHR_materials_ior");
    plastic.int_ior = std::max(ior ? number_of(*ior, "ior", 1.5f) : 1.5f, 1.0f);
    plastic.ext_ior = 1;
    plastic.diffuse_reflectance = base;
    plastic.alpha = alpha;
    plastic.distribution = Microfacet::Ggx;
    if (const Json* specular = extension(material, "KHR_materials_specular")) {
      plastic.specular_reflectance.value = number_of(*specular, "specularFactor", 1) *
                                           color_of(*specular, "specularColorFactor", Color(1));
      if (find(*specular, "specularTexture") || find(*specular, "specularColorTexture")) {
        notices_.add("textures of 'KHR_materials_specular' are not supported; its factors count.");
      }
    }
    bsdf = add_bsdf(name + " (dielectric)", plastic);
  }
  if (metallic > 0) {
    ConductorBsdf metal;  // eta = 0, k = 1: the base colour is its reflectance at every angle
    metal.specular_reflectance = base;
    metal.alpha_u = metal.alpha_v = alpha;
    metal.distribution = Microfacet::Ggx;
    const int second = add_bsdf(name + " (metal)", metal);
    // Blue holds the metalness.
    bsdf = bsdf == kNone ? second
                         : add_bsdf(name + " (blend)",
                                    BlendBsdf{{metallic, metallic_texture, 2}, bsdf, second});
  }
  return add_bsdf(name, TwoSidedBsdf{bsdf, bsdf});
}

/// KHR_materials_transmission: a thin sheet, or with KHR_materials_volume solid glass.
int Materials::transmit(const Json& material, const std::string& name, const ColorInput& base,
                        int opaque, Surface& surface) {
  const Json* transmission = extension(material, "KHR_materials_transmission");
  const float factor = transmission ? number_of(*transmission, "transmissionFactor", 0) : 0;
  if (!(factor > 0)) return opaque;
  const Json* ior = extension(material, "KHR_materials_ior");
  const Json* volume = extension(material, "KHR_materials_volume");
  const float int_ior = std::max(ior ? number_of(*ior, "ior", 1.5f) : 1.5f, 1.0f);
  int glass = kNone;
  if (volume && number_of(*volume, "thicknessFactor", 0) > 0) {
    DielectricBsdf solid;
    solid.int_ior = int_ior;
    solid.ext_ior = 1;
    solid.specular_transmittance = base;
    solid.alpha_u = solid.alpha_v =
        roughness_squared(member_or_empty(material, "pbrMetallicRoughness"));
    solid.distribution = Microfacet::Ggx;
    glass = add_bsdf(name + " (glass)", solid);
    surface.interior = interior_medium(*volume, name);
  } else {
    ThinDielectricBsdf sheet;
    sheet.int_ior = int_ior;
    sheet.ext_ior = 1;
    sheet.specular_transmittance = base;
    glass = add_bsdf(name + " (thin glass)", sheet);
  }
  const int map = texture(find(*transmission, "transmissionTexture"), Use::Data);
  if (factor >= 1 && map == kNone) return glass;
  return add_bsdf(name + " (transmission)", BlendBsdf{{factor, map, 0}, opaque, glass});
}

/// KHR_materials_volume: the attenuation colour is what is left after the attenuation distance.
int Materials::interior_medium(const Json& volume, const std::string& name) {
  const Color color = color_of(volume, "attenuationColor", Color(1));
  const float distance = number_of(volume, "attenuationDistance", 0);
  if (!(distance > 0) || color == Color(1)) return kNone;
  MediumDescription medium{name, 0, Color(0)};
  for (int i = 0; i < 3; ++i) {
    medium.sigma_a[i] = -std::log(std::clamp(color[i], 1e-4f, 1.0f)) / distance;
  }
  scene_.media.push_back(medium);
  return static_cast<int>(scene_.media.size()) - 1;
}

int Materials::mask(const Json& material, const std::string& name, int nested) {
  const std::string mode = text_of(material, "alphaMode", "OPAQUE");
  if (mode != "MASK" && mode != "BLEND") return nested;
  const Json& parameters = member_or_empty(material, "pbrMetallicRoughness");
  const float alpha = numbers_of(parameters, "baseColorFactor", {1, 1, 1, 1})[3];
  const Json* info = find(parameters, "baseColorTexture");
  FloatInput opacity{alpha};
  if (mode == "MASK") {
    // Opaque where factor × texture reaches the cutoff.
    const float cutoff = number_of(material, "alphaCutoff", 0.5f);
    const float threshold = alpha > 0 ? cutoff / alpha : kInfinity;
    opacity.value = info ? 1.0f : (alpha >= cutoff ? 1.0f : 0.0f);
    opacity.texture = info ? texture(info, Use::AlphaMask, threshold) : kNone;
    opacity.channel = 0;
  } else if (info) {
    opacity.texture = texture(info, Use::Color);
    opacity.channel = 3;
  }
  if (opacity.texture == kNone && opacity.value >= 1) return nested;
  return add_bsdf(name + " (mask)", MaskBsdf{opacity, nested});
}

int Materials::texture(const Json* info, Use use, float parameter) {
  if (!info) return kNone;
  const Json& entry = asset_.entry("textures", index_of(*info, "index"));
  const int source = index_of(entry, "source");
  if (source == kNone) {
    notices_.add("a texture has no image in a format that is read; it is left out.");
    return kNone;
  }
  const int sampler_index = index_of(entry, "sampler");
  const Json& sampler = sampler_index == kNone ? kEmpty : asset_.entry("samplers", sampler_index);
  const Json* transform = extension(*info, "KHR_texture_transform");
  int uv_set = std::max(index_of(*info, "texCoord"), 0);
  if (transform && find(*transform, "texCoord")) uv_set = index_of(*transform, "texCoord");
  uv_sets_.insert(uv_set);

  BitmapTexture bitmap;
  bitmap.image = image(source, use, parameter);
  bitmap.uv_transform = uv_transform(transform);
  bitmap.wrap_u = wrap_mode(sampler, "wrapS");
  bitmap.wrap_v = wrap_mode(sampler, "wrapT");
  const bool nearest = number_of(sampler, "magFilter", 9729) == 9728;
  bitmap.filter = nearest ? TextureFilter::Nearest : TextureFilter::Bilinear;
  scene_.textures.push_back({text_of(entry, "name", ""), 0, bitmap});
  return static_cast<int>(scene_.textures.size()) - 1;
}

std::shared_ptr<const Image> Materials::image(int source, Use use, float parameter) {
  std::shared_ptr<const Image>& known = images_[{source, use, parameter}];
  if (known) return known;
  const Json& entry = asset_.entry("images", source);
  const std::string uri = text_of(entry, "uri", "");
  const std::string loaded = uri.empty() ? std::string() : asset_.load_uri(uri);
  const std::string_view bytes =
      uri.empty() ? asset_.buffer_view(index_of(entry, "bufferView")) : std::string_view(loaded);
  const std::string name =
      uri.empty() || uri.starts_with("data:") ? fmt::format("images[{}]", source) : uri;
  Image image = read_image(bytes.data(), bytes.size(), name,
                           use == Use::Color ? ColorSpace::Srgb : ColorSpace::Linear);
  if (use == Use::SquaredRoughness) {  // green holds the roughness
    image = single_channel(
        image, 1, [](float g, float) { return g * g; }, 0);
  } else if (use == Use::AlphaMask) {
    const bool has_alpha = image.channels() == 2 || image.channels() == 4;
    if (has_alpha) {
      image = single_channel(
          image, image.channels() - 1,
          [](float alpha, float threshold) { return alpha >= threshold ? 1.0f : 0.0f; }, parameter);
    } else {
      image = Image(1, 1, 1);
      image.data()[0] = parameter <= 1 ? 1 : 0;
    }
  } else if (use == Use::Normal) {
    scale_normals(image, parameter);
  }
  known = std::make_shared<Image>(std::move(image));
  return known;
}

}  // namespace guidelight::gltf
