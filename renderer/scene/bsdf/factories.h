#pragma once

#include <string>

#include "renderer/error.h"
#include "renderer/scene/bsdf/bsdf.h"

/// How make_bsdfs builds one BSDF; each overload is defined in the file of its model.
namespace guidelight {

using BsdfPointer = std::shared_ptr<const Bsdf>;

/// What a BSDF may refer to: all textures, and the BSDFs before it.
struct BsdfContext {
  const TextureList& textures;
  const BsdfList& previous;
  std::string where;  // names the BSDF in errors

  /// The accessors throw Error for an index that names nothing.
  BsdfPointer nested(int index) const;
  std::shared_ptr<const Texture> texture(int index) const;
  ColorTexture color(const ColorInput& input) const;
  FloatTexture scalar(const FloatInput& input) const;
  /// Interior over exterior IOR. Throws Error unless both are positive and finite.
  float relative_ior(float interior, float exterior) const;
};

BsdfPointer make_bsdf(const DiffuseBsdf& description, const BsdfContext& context);
BsdfPointer make_bsdf(const RoughDiffuseBsdf& description, const BsdfContext& context);
BsdfPointer make_bsdf(const ConductorBsdf& description, const BsdfContext& context);
BsdfPointer make_bsdf(const DielectricBsdf& description, const BsdfContext& context);
BsdfPointer make_bsdf(const ThinDielectricBsdf& description, const BsdfContext& context);
BsdfPointer make_bsdf(const PlasticBsdf& description, const BsdfContext& context);
BsdfPointer make_bsdf(const PhongBsdf& description, const BsdfContext& context);
BsdfPointer make_bsdf(const WardBsdf& description, const BsdfContext& context);
BsdfPointer make_bsdf(const CoatingBsdf& description, const BsdfContext& context);
BsdfPointer make_bsdf(const BlendBsdf& description, const BsdfContext& context);
BsdfPointer make_bsdf(const MaskBsdf& description, const BsdfContext& context);
BsdfPointer make_bsdf(const TwoSidedBsdf& description, const BsdfContext& context);
BsdfPointer make_bsdf(const NullBsdf& description, const BsdfContext& context);
BsdfPointer make_bsdf(const NormalMapBsdf& description, const BsdfContext& context);
BsdfPointer make_bsdf(const BumpMapBsdf& description, const BsdfContext& context);

/// Whether two specular events of one lobe, of different parts of a BSDF, go the same way.
inline bool is_same_event(Vec3 a, Vec3 b) { return length_squared(a - b) < 1e-10f; }

/// A random number that chose an event of probability p by u < p (or ≥), stretched to be used
/// again.
inline float reuse_below(float u, float p) { return std::min(u / p, kOneMinusEpsilon); }
inline float reuse_above(float u, float p) { return std::min((u - p) / (1 - p), kOneMinusEpsilon); }

}  // namespace guidelight
