#include "renderer/scene/bsdf/factories.h"

// Models that are still to be written; a scene that uses one is refused.
namespace guidelight {
namespace {
BsdfPointer refuse(const BsdfContext& context) {
  throw Error("{}: this BSDF is not supported yet.", context.where);
}
}  // namespace
BsdfPointer make_bsdf(const RoughDiffuseBsdf&, const BsdfContext& c) { return refuse(c); }
BsdfPointer make_bsdf(const ThinDielectricBsdf&, const BsdfContext& c) { return refuse(c); }
BsdfPointer make_bsdf(const PhongBsdf&, const BsdfContext& c) { return refuse(c); }
BsdfPointer make_bsdf(const WardBsdf&, const BsdfContext& c) { return refuse(c); }
BsdfPointer make_bsdf(const CoatingBsdf&, const BsdfContext& c) { return refuse(c); }
BsdfPointer make_bsdf(const BlendBsdf&, const BsdfContext& c) { return refuse(c); }
BsdfPointer make_bsdf(const NormalMapBsdf&, const BsdfContext& c) { return refuse(c); }
BsdfPointer make_bsdf(const BumpMapBsdf&, const BsdfContext& c) { return refuse(c); }
}  // namespace guidelight
