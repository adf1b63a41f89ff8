#pragma once

#include <memory>
#include <span>
#include <vector>

#include "renderer/scene/description.h"

namespace guidelight {

struct SurfacePoint;

/// A function on surfaces. Immutable.
class Texture {
 public:
  virtual ~Texture() = default;
  virtual Color eval(const SurfacePoint& point) const = 0;
  /// One channel (0..3, 3 is alpha and 1 where there is none).
  virtual float eval_channel(const SurfacePoint& point, int channel) const = 0;
  /// Mean colour over the texture, for light selection and previews.
  virtual Color mean() const = 0;
};

using TextureList = std::vector<std::shared_ptr<const Texture>>;

/// Builds all textures of a scene, in order.
TextureList make_textures(const SceneDescription& scene);

/// ColorInput bound to its texture. Constant colours, by far the most frequent, cost one branch.
class ColorTexture {
 public:
  ColorTexture() = default;
  explicit ColorTexture(Color value) : value_(value) {}
  ColorTexture(const ColorInput& input, const TextureList& textures)
      : value_(input.value), texture_(input.texture >= 0 ? textures.at(input.texture) : nullptr) {}

  Color eval(const SurfacePoint& point) const {
    return texture_ ? value_ * texture_->eval(point) : value_;
  }
  Color mean() const { return texture_ ? value_ * texture_->mean() : value_; }
  bool is_constant() const { return !texture_; }

 private:
  Color value_{1.0f};
  std::shared_ptr<const Texture> texture_;
};

/// FloatInput bound to its texture.
class FloatTexture {
 public:
  FloatTexture() = default;
  explicit FloatTexture(float value) : value_(value) {}
  FloatTexture(const FloatInput& input, const TextureList& textures)
      : value_(input.value),
        channel_(input.channel),
        texture_(input.texture >= 0 ? textures.at(input.texture) : nullptr) {}

  float eval(const SurfacePoint& point) const {
    if (!texture_) return value_;
    return value_ * (channel_ >= 0 ? texture_->eval_channel(point, channel_)
                                   : luminance(texture_->eval(point)));
  }
  float mean() const { return texture_ ? value_ * luminance(texture_->mean()) : value_; }
  bool is_constant() const { return !texture_; }

 private:
  float value_ = 0;
  int channel_ = kNone;
  std::shared_ptr<const Texture> texture_;
};

}  // namespace guidelight
