#include "renderer/scene/texture.h"

#include "renderer/error.h"
#include "renderer/scene/bitmap_texture.h"
#include "renderer/scene/surface_point.h"

namespace guidelight {
namespace {

class Checkerboard final : public Texture {
 public:
  Checkerboard(const CheckerboardTexture& description, const TextureList& previous)
      : color0_(description.color0, previous),
        color1_(description.color1, previous),
        uv_transform_(description.uv_transform) {}

  Color eval(const SurfacePoint& point) const override {
    const Vec3 uv = uv_transform_ * Vec3(point.uv, 1);
    const bool is_same = in_second_half(uv.x) == in_second_half(uv.y);
    return (is_same ? color0_ : color1_).eval(point);
  }

  float eval_channel(const SurfacePoint& point, int channel) const override {
    return channel == 3 ? 1.0f : eval(point)[channel];
  }

  Color mean() const override { return 0.5f * (color0_.mean() + color1_.mean()); }

 private:
  static bool in_second_half(float t) { return t - std::floor(t) >= 0.5f; }

  ColorTexture color0_;
  ColorTexture color1_;
  Mat3 uv_transform_;
};

class VertexColors final : public Texture {
 public:
  Color eval(const SurfacePoint& point) const override { return point.vertex_color; }
  float eval_channel(const SurfacePoint& point, int channel) const override {
    return channel == 3 ? 1.0f : point.vertex_color[channel];
  }
  /// A mesh's colours are not known here.
  Color mean() const override { return Color(1.0f); }
};

using TexturePointer = std::shared_ptr<const Texture>;

TexturePointer make_texture(const BitmapTexture& description, const TextureList&) {
  return std::make_shared<BitmapSampler>(description);
}

TexturePointer make_texture(const CheckerboardTexture& description, const TextureList& previous) {
  for (const int index : {description.color0.texture, description.color1.texture}) {
    if (index >= static_cast<int>(previous.size())) {
      throw Error("A colour of a checkerboard names a texture that is not defined before it.");
    }
  }
  return std::make_shared<Checkerboard>(description, previous);
}

TexturePointer make_texture(const VertexColorTexture&, const TextureList&) {
  return std::make_shared<VertexColors>();
}

}  // namespace

TextureList make_textures(const SceneDescription& scene) {
  TextureList textures;
  textures.reserve(scene.textures.size());
  for (const TextureDescription& description : scene.textures) {
    try {
      textures.push_back(std::visit(
          [&](const auto& model) { return make_texture(model, textures); }, description.model));
    } catch (const Error& error) {
      throw Error("{}:{}: texture '{}': {}", scene.path, description.line, description.name,
                  error.what());
    }
  }
  return textures;
}

}  // namespace guidelight
