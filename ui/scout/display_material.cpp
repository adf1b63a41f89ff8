#include <algorithm>

#include "renderer/image/tonemap.h"
#include "ui/scout/display_mesh.h"

namespace guidelight {
namespace {

constexpr int kMostTexels = 4096;  // looked at for the mean of a picture
constexpr float kMetalGrey = 0.75f;
const Color kGlass{0.72f, 0.80f, 0.84f};

/// About the mean; of a large image not every pixel is looked at.
Color rough_mean(const Image& image) {
  const size_t step = std::max<size_t>(1, image.pixel_count() / kMostTexels);
  Color sum(0);
  float count = 0;
  for (size_t i = 0; i < image.pixel_count(); i += step) {
    const auto width = static_cast<size_t>(image.width());
    const Color texel = image.color(static_cast<int>(i % width), static_cast<int>(i / width));
    if (!is_finite(texel)) continue;
    sum += texel;
    ++count;
  }
  return count > 0 ? sum / count : Color(0.5f);
}

/// Linear reflectances of the materials, one overload each.
class Appearance {
 public:
  explicit Appearance(const SceneDescription& scene) : scene_(scene) {}

  struct Look {
    Color reflectance{0.5f};
    bool clear = false;
  };

  Look of(int bsdf) const {
    if (bsdf == kNone) return {};
    return std::visit([this](const auto& model) { return look(model); }, scene_.bsdfs[bsdf].model);
  }

 private:
  Color mean(const ColorInput& input) const {
    return input.texture == kNone ? input.value : input.value * mean(input.texture);
  }
  Color mean(int texture) const {
    const auto& model = scene_.textures[texture].model;
    if (const auto* bitmap = std::get_if<BitmapTexture>(&model)) {
      return bitmap->image ? rough_mean(*bitmap->image) : Color(0.5f);
    }
    if (const auto* board = std::get_if<CheckerboardTexture>(&model)) {
      return 0.5f * (mean(board->color0) + mean(board->color1));
    }
    return Color(0.5f);
  }

  Look look(const DiffuseBsdf& b) const { return {mean(b.reflectance)}; }
  Look look(const RoughDiffuseBsdf& b) const { return {mean(b.reflectance)}; }
  Look look(const ConductorBsdf& b) const {
    // Fresnel's equations at normal incidence.
    const Color k2 = b.k * b.k;
    const Color low = (b.eta - 1.0f) * (b.eta - 1.0f) + k2;
    const Color high = (b.eta + 1.0f) * (b.eta + 1.0f) + k2;
    return {kMetalGrey * mean(b.specular_reflectance) * low / glm::max(high, Color(1e-6f))};
  }
  Look look(const DielectricBsdf& b) const {
    return {kGlass * mean(b.specular_transmittance), true};
  }
  Look look(const ThinDielectricBsdf& b) const {
    return {kGlass * mean(b.specular_transmittance), true};
  }
  Look look(const PlasticBsdf& b) const { return {mean(b.diffuse_reflectance) + 0.04f}; }
  Look look(const PhongBsdf& b) const {
    return {mean(b.diffuse_reflectance) + 0.5f * mean(b.specular_reflectance)};
  }
  Look look(const WardBsdf& b) const {
    return {mean(b.diffuse_reflectance) + 0.5f * mean(b.specular_reflectance)};
  }
  Look look(const CoatingBsdf& b) const { return of(b.nested); }
  Look look(const BlendBsdf& b) const {
    const Look first = of(b.first);
    const Look second = of(b.second);
    return {glm::mix(first.reflectance, second.reflectance, std::clamp(b.weight.value, 0.0f, 1.0f)),
            first.clear && second.clear};
  }
  Look look(const MaskBsdf& b) const { return of(b.nested); }
  Look look(const TwoSidedBsdf& b) const { return of(b.front); }
  Look look(const NullBsdf&) const { return {Color(0.6f), true}; }
  Look look(const NormalMapBsdf& b) const { return of(b.nested); }
  Look look(const BumpMapBsdf& b) const { return of(b.nested); }

  const SceneDescription& scene_;
};

}  // namespace

DisplayMaterial display_material(const SceneDescription& scene, int bsdf) {
  const Appearance::Look look = Appearance(scene).of(bsdf);
  return {display_color(glm::clamp(look.reflectance, Color(0), Color(1)), {}), look.clear};
}

}  // namespace guidelight
