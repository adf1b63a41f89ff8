#include "renderer/scene/bsdf/bsdf.h"

#include <fmt/format.h>

#include "renderer/scene/bsdf/factories.h"

namespace guidelight {

BsdfPointer BsdfContext::nested(int index) const {
  if (index < 0 || index >= static_cast<int>(previous.size())) {
    throw Error("{}: the nested BSDF is missing; define it before the BSDF that uses it.", where);
  }
  return previous[index];
}

std::shared_ptr<const Texture> BsdfContext::texture(int index) const {
  if (index < 0 || index >= static_cast<int>(textures.size())) {
    throw Error("{}: the texture is missing; define it before the BSDF that uses it.", where);
  }
  return textures[index];
}

ColorTexture BsdfContext::color(const ColorInput& input) const {
  if (input.texture != kNone) texture(input.texture);
  return ColorTexture(input, textures);
}

FloatTexture BsdfContext::scalar(const FloatInput& input) const {
  if (input.texture != kNone) texture(input.texture);
  return FloatTexture(input, textures);
}

float BsdfContext::relative_ior(float interior, float exterior) const {
  const float eta = interior / exterior;
  if (!(interior > 0 && exterior > 0) || !std::isfinite(eta)) {
    throw Error("{}: the index of refraction must be a positive number, not {} over {}.", where,
                interior, exterior);
  }
  return eta;
}

BsdfList make_bsdfs(const SceneDescription& scene, const TextureList& textures) {
  BsdfList bsdfs;
  bsdfs.reserve(scene.bsdfs.size());
  for (const BsdfDescription& description : scene.bsdfs) {
    const BsdfContext context{
        textures, bsdfs,
        fmt::format("{}:{}: BSDF '{}'", scene.path, description.line, description.name)};
    bsdfs.push_back(std::visit([&](const auto& model) { return make_bsdf(model, context); },
                               description.model));
  }
  return bsdfs;
}

}  // namespace guidelight
