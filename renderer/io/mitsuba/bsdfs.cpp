#include <algorithm>

#include "renderer/io/material_data.h"
#include "renderer/io/mitsuba/importer.h"
#include "renderer/io/mitsuba/values.h"

namespace guidelight::mitsuba {
namespace {

bool transmits(const BsdfDescription& bsdf) {
  return std::holds_alternative<DielectricBsdf>(bsdf.model) ||
         std::holds_alternative<ThinDielectricBsdf>(bsdf.model) ||
         std::holds_alternative<NullBsdf>(bsdf.model) ||
         std::holds_alternative<MaskBsdf>(bsdf.model);
}

Image squared_luminance(const Image& source) {
  Image result(source.width(), source.height(), 1);
  for (int y = 0; y < source.height(); ++y) {
    for (int x = 0; x < source.width(); ++x) {
      *result.pixel(x, y) = sqr(luminance(source.color(x, y)));
    }
  }
  return result;
}

}  // namespace

int Importer::add_bsdf(const Node& node, const std::string& suffix, BsdfModel model) {
  scene_.bsdfs.push_back({node.id + suffix, node.source.line, std::move(model)});
  return static_cast<int>(scene_.bsdfs.size()) - 1;
}

int Importer::bsdf(const Node& node) {
  if (const auto known = bsdfs_.find(&node); known != bsdfs_.end()) return known->second;
  Properties properties(node, warnings_);
  std::optional<BsdfModel> model = bsdf_model(properties);
  if (model) {
    properties.warn_about_the_rest();
  } else {
    warnings_.add(
        node.source, plugin_name(node),
        fmt::format("{} is not supported; a grey diffuse surface stands in.", plugin_name(node)));
    model = DiffuseBsdf{};
  }
  // Two-sided around something that has two sides by itself is that thing.
  const auto* two_sided = std::get_if<TwoSidedBsdf>(&*model);
  if (two_sided && transmits(scene_.bsdfs[two_sided->front]))
    return bsdfs_[&node] = two_sided->front;
  return bsdfs_[&node] = add_bsdf(node, "", std::move(*model));
}

std::optional<Importer::BsdfModel> Importer::bsdf_model(Properties& p) {
  const std::string& type = p.node().type;
  if (type == "diffuse" || type == "lambertian") {
    return DiffuseBsdf{color(p, {"reflectance", "diffuse_reflectance"}, Color(0.5f))};
  }
  if (type == "roughdiffuse") {
    p.ignore({"use_fast_approx"});
    return RoughDiffuseBsdf{color(p, {"reflectance", "diffuse_reflectance"}, Color(0.5f)),
                            number(p, {"alpha"}, 0.2f)};
  }
  if (type == "conductor") return conductor(p, false);
  if (type == "roughconductor") return conductor(p, true);
  if (type == "dielectric") return dielectric(p, false);
  if (type == "roughdielectric") return dielectric(p, true);
  if (type == "thindielectric") return thin_dielectric(p);
  if (type == "plastic") return plastic(p, false);
  if (type == "roughplastic") return plastic(p, true);
  if (type == "phong") return phong(p);
  if (type == "ward") return ward(p);
  if (type == "coating") return coating(p, false);
  if (type == "roughcoating") return coating(p, true);
  if (type == "blendbsdf") return blend(p);
  if (type == "mixturebsdf") return mixture(p);
  if (type == "mask") return MaskBsdf{number(p, {"opacity"}, 0.5f), nested_bsdf(p)};
  if (type == "twosided") return two_sided(p);
  if (type == "null") return NullBsdf{};
  if (type == "normalmap") return normal_map(p);
  if (type == "bumpmap") return bump_map(p);
  if (type == "principled") return principled(p);
  return std::nullopt;
}

float Importer::ior(Properties& p, Properties::Names names, float fallback) {
  const Node* property = p.find(names);
  if (!property) return fallback;
  const std::string name = p.text(names, "");
  if (const std::optional<float> named = named_ior(name)) return *named;
  if (!parse_number(name)) {
    warnings_.add(
        property->source, "ior " + name,
        fmt::format("the material '{}' is not known; an index of refraction of {} stands in.", name,
                    fallback));
    return fallback;
  }
  const float value = p.number(names, fallback);
  if (!(value > 0)) {
    throw Error("{}: an index of refraction of {} is not positive; correct it.",
                property->source.to_string(), value);
  }
  return value;
}

Microfacet Importer::distribution(Properties& p) {
  const std::string name = p.text({"distribution"}, "beckmann");
  p.ignore({"sample_visible", "sample_all"});
  if (name == "ggx") return Microfacet::Ggx;
  if (name != "beckmann") {
    warnings_.add(
        p.node().source, "distribution " + name,
        fmt::format("the microfacet distribution '{}' is not supported; 'beckmann' with the "
                    "same roughness stands in.",
                    name));
  }
  return Microfacet::Beckmann;
}

void Importer::roughness(Properties& p, FloatInput& alpha_u, FloatInput& alpha_v) {
  const FloatInput alpha = number(p, {"alpha"}, 0.1f);
  alpha_u = p.find({"alpha_u"}) ? number(p, {"alpha_u"}, 0.1f) : alpha;
  alpha_v = p.find({"alpha_v"}) ? number(p, {"alpha_v"}, 0.1f) : alpha;
}

Importer::BsdfModel Importer::conductor(Properties& p, bool rough) {
  ConductorBsdf bsdf;
  // Copper is the default of Mitsuba 0.x, a perfect mirror that of 2 and 3; also of what only one
  // of `eta` and `k` leaves open.
  const std::string fallback = document_.version < 2 ? "Cu" : "none";
  const std::string material = p.text({"material"}, fallback);
  const std::optional<ConductorData> data = named_conductor(material);
  if (!data) {
    warnings_.add(p.node().source, "conductor " + material,
                  fmt::format("the conductor '{}' is not known; copper stands in.", material));
  }
  const ConductorData indices = data ? *data : *named_conductor("Cu");
  const float exterior = ior(p, {"ext_eta"}, 1);
  bsdf.eta = constant_color(p, {"eta"}, indices.eta, SpectrumUse::Coefficient) / exterior;
  bsdf.k = constant_color(p, {"k"}, indices.k, SpectrumUse::Coefficient) / exterior;
  bsdf.specular_reflectance = color(p, {"specular_reflectance"}, Color(1));
  if (rough) {
    roughness(p, bsdf.alpha_u, bsdf.alpha_v);
    bsdf.distribution = distribution(p);
  }
  return bsdf;
}

Importer::BsdfModel Importer::dielectric(Properties& p, bool rough) {
  DielectricBsdf bsdf;
  bsdf.int_ior = ior(p, {"int_ior"}, bsdf.int_ior);
  bsdf.ext_ior = ior(p, {"ext_ior"}, bsdf.ext_ior);
  bsdf.specular_reflectance = color(p, {"specular_reflectance"}, Color(1));
  bsdf.specular_transmittance = color(p, {"specular_transmittance"}, Color(1));
  if (rough) {
    roughness(p, bsdf.alpha_u, bsdf.alpha_v);
    bsdf.distribution = distribution(p);
  }
  return bsdf;
}

Importer::BsdfModel Importer::thin_dielectric(Properties& p) {
  ThinDielectricBsdf bsdf;
  bsdf.int_ior = ior(p, {"int_ior"}, bsdf.int_ior);
  bsdf.ext_ior = ior(p, {"ext_ior"}, bsdf.ext_ior);
  bsdf.specular_reflectance = color(p, {"specular_reflectance"}, Color(1));
  bsdf.specular_transmittance = color(p, {"specular_transmittance"}, Color(1));
  return bsdf;
}

Importer::BsdfModel Importer::plastic(Properties& p, bool rough) {
  PlasticBsdf bsdf;
  bsdf.int_ior = ior(p, {"int_ior"}, bsdf.int_ior);
  bsdf.ext_ior = ior(p, {"ext_ior"}, bsdf.ext_ior);
  bsdf.diffuse_reflectance = color(p, {"diffuse_reflectance"}, Color(0.5f));
  bsdf.specular_reflectance = color(p, {"specular_reflectance"}, Color(1));
  bsdf.nonlinear = p.boolean({"nonlinear"}, false);
  if (rough) {
    bsdf.alpha = number(p, {"alpha"}, 0.1f);
    bsdf.distribution = distribution(p);
  }
  return bsdf;
}

Importer::BsdfModel Importer::phong(Properties& p) {
  PhongBsdf bsdf;
  bsdf.diffuse_reflectance = color(p, {"diffuse_reflectance"}, Color(0.5f));
  bsdf.specular_reflectance = color(p, {"specular_reflectance"}, Color(0.2f));
  bsdf.exponent = number(p, {"exponent"}, 30);
  return bsdf;
}

Importer::BsdfModel Importer::ward(Properties& p) {
  WardBsdf bsdf;
  bsdf.diffuse_reflectance = color(p, {"diffuse_reflectance"}, Color(0.5f));
  bsdf.specular_reflectance = color(p, {"specular_reflectance"}, Color(0.2f));
  roughness(p, bsdf.alpha_u, bsdf.alpha_v);
  const std::string variant = canonical_name(p.text({"variant"}, "balanced"));
  if (variant == "ward") bsdf.variant = WardBsdf::Variant::Ward;
  if (variant == "ward-duer") bsdf.variant = WardBsdf::Variant::WardDuer;
  return bsdf;
}

int Importer::nested_bsdf(Properties& p) {
  const Node* nested = p.object("bsdf");
  if (nested) return bsdf(*nested);
  warnings_.add(p.node().source, plugin_name(p.node()) + p.node().source.to_string(),
                fmt::format("{} has no nested BSDF; a grey diffuse surface stands in.",
                            plugin_name(p.node())));
  return add_bsdf(p.node(), " (missing)", DiffuseBsdf{});
}

Importer::BsdfModel Importer::coating(Properties& p, bool rough) {
  CoatingBsdf bsdf;
  bsdf.nested = nested_bsdf(p);
  bsdf.int_ior = ior(p, {"int_ior"}, bsdf.int_ior);
  bsdf.ext_ior = ior(p, {"ext_ior"}, bsdf.ext_ior);
  bsdf.thickness = p.number({"thickness"}, 1);
  bsdf.sigma_a = color(p, {"sigma_a"}, Color(0), SpectrumUse::Coefficient);
  bsdf.specular_reflectance = color(p, {"specular_reflectance"}, Color(1));
  if (rough) {
    p.ignore({"alpha", "distribution"});
    warnings_.add(p.node().source, "roughcoating",
                  "bsdf 'roughcoating' is not supported; a smooth coating stands in.");
  }
  return bsdf;
}

Importer::BsdfModel Importer::blend(Properties& p) {
  const FloatInput weight = number(p, {"weight"}, 0.5f);
  const std::vector<const Node*> nested = p.objects("bsdf");
  const int first = nested_bsdf(p);
  return BlendBsdf{weight, first, nested.size() > 1 ? bsdf(*nested[1]) : first};
}

/// Any number of BSDFs as a chain of blends; the weights count in proportion.
Importer::BsdfModel Importer::mixture(Properties& p) {
  const std::vector<const Node*> nested = p.objects("bsdf");
  const std::optional<std::vector<double>> weights = parse_numbers(p.text({"weights"}, ""));
  const bool valid = weights && weights->size() == nested.size() &&
                     std::all_of(weights->begin(), weights->end(),
                                 [](double w) { return w >= 0 && std::isfinite(w); });
  if (!valid || nested.size() < 2) {
    throw Error("{}: {} has {} nested BSDFs and no list of as many weights; correct 'weights'.",
                p.node().source.to_string(), plugin_name(p.node()), nested.size());
  }
  int mixed = bsdf(*nested[0]);
  double sum = weights->front();
  BlendBsdf last;
  for (size_t i = 1; i < nested.size(); ++i) {
    if (i > 1) mixed = add_bsdf(p.node(), fmt::format(" (part {})", i), last);
    sum += (*weights)[i];
    const double share = sum > 0 ? (*weights)[i] / sum : 0;
    last = BlendBsdf{{static_cast<float>(share)}, mixed, bsdf(*nested[i])};
  }
  if (sum < 0.999) {
    warnings_.add(
        p.node().source, "mixture weights",
        "the weights of a mixturebsdf add up to less than one; they count in proportion.");
  }
  return last;
}

Importer::BsdfModel Importer::two_sided(Properties& p) {
  const std::vector<const Node*> nested = p.objects("bsdf");
  const int front = nested_bsdf(p);
  return TwoSidedBsdf{front, nested.size() > 1 ? bsdf(*nested[1]) : front};
}

Importer::BsdfModel Importer::normal_map(Properties& p) {
  const int nested = nested_bsdf(p);
  const Node* map = p.find({"normalmap"});
  if (!map) map = p.object("texture");
  const int index = map ? texture(*map) : kNone;
  if (index != kNone) return NormalMapBsdf{index, nested};
  return scene_.bsdfs[nested].model;  // a constant map changes nothing
}

Importer::BsdfModel Importer::bump_map(Properties& p) {
  const int nested = nested_bsdf(p);
  const Node* map = p.object("texture");
  if (!map) map = p.find({"map", "arbitrary"});
  const ColorInput input = map ? color_input(*map, SpectrumUse::Coefficient) : ColorInput{};
  const float scale = p.number({"scale"}, 1) * luminance(input.value);
  if (input.texture != kNone) return BumpMapBsdf{input.texture, scale, nested};
  return scene_.bsdfs[nested].model;
}

/// The square of what `input` says; a texture is squared in a copy.
FloatInput Importer::squared(const Node& node, const FloatInput& input) {
  const float value = sqr(input.value);
  if (input.texture == kNone) return {value};
  TextureDescription texture = scene_.textures[input.texture];
  if (auto* bitmap = std::get_if<BitmapTexture>(&texture.model)) {
    bitmap->image = std::make_shared<Image>(squared_luminance(*bitmap->image));
  } else if (auto* checkerboard = std::get_if<CheckerboardTexture>(&texture.model)) {
    for (ColorInput* color : {&checkerboard->color0, &checkerboard->color1}) {
      const FloatInput square = squared(node, {luminance(color->value), color->texture, kNone});
      *color = {Color(square.value), square.texture};
    }
  } else {
    warnings_.add(node.source, "squared vertex colours",
                  "a roughness of vertex colours cannot be squared; it counts as α itself.");
    return {value, input.texture, input.channel};
  }
  scene_.textures.push_back(std::move(texture));
  return {value, static_cast<int>(scene_.textures.size()) - 1, kNone};
}

/// Burley's principled BSDF as a mixture of what there is: plastic for the dielectric part, a
/// mirror in the base colour for the metallic one, glass for the transmitting one.
Importer::BsdfModel Importer::principled(Properties& p) {
  warnings_.add(
      p.node().source, "principled",
      "bsdf 'principled' is not supported; a blend of plastic, metal and glass stands in.");
  const ColorInput base = color(p, {"base_color"}, Color(0.5f));
  FloatInput alpha = squared(p.node(), number(p, {"roughness"}, 0.5f));
  alpha.value = std::max(alpha.value, 1e-3f);
  // Reflectance at normal incidence is 0.08 · specular (Burley 2012).
  const float root = std::sqrt(0.08f * std::clamp(p.number({"specular"}, 0.5f), 0.0f, 1.0f));
  const float eta = p.find({"eta"}) ? ior(p, {"eta"}, 1.5f) : (1 + root) / (1 - root);
  const FloatInput metallic = number(p, {"metallic"}, 0);
  const FloatInput transmission = number(p, {"spec_trans"}, 0);
  p.ignore({"anisotropic", "spec_tint", "sheen", "sheen_tint", "clearcoat", "clearcoat_gloss",
            "flatness", "diffuse_reflectance_sampling_rate", "specular_reflectance_sampling_rate"});

  PlasticBsdf plastic;
  plastic.int_ior = eta;
  plastic.ext_ior = 1;
  plastic.diffuse_reflectance = base;
  plastic.alpha = alpha;
  plastic.distribution = Microfacet::Ggx;
  BsdfModel model = plastic;
  const auto is_zero = [](const FloatInput& input) {
    return input.texture == kNone && !(input.value > 0);
  };
  if (!is_zero(metallic)) {
    ConductorBsdf metal;
    metal.specular_reflectance = base;
    metal.alpha_u = metal.alpha_v = alpha;
    metal.distribution = Microfacet::Ggx;
    const int first = add_bsdf(p.node(), " (plastic)", std::move(model));
    model = BlendBsdf{metallic, first, add_bsdf(p.node(), " (metal)", metal)};
  }
  if (!is_zero(transmission)) {
    DielectricBsdf glass;
    glass.int_ior = std::max(eta, 1.001f);
    glass.ext_ior = 1;
    glass.specular_transmittance = base;
    glass.alpha_u = glass.alpha_v = alpha;
    glass.distribution = Microfacet::Ggx;
    const int first = add_bsdf(p.node(), " (opaque)", std::move(model));
    model = BlendBsdf{transmission, first, add_bsdf(p.node(), " (glass)", glass)};
  }
  return model;
}

}  // namespace guidelight::mitsuba
