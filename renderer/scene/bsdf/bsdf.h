#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "renderer/scene/description.h"
#include "renderer/scene/surface_point.h"
#include "renderer/scene/texture.h"

namespace guidelight {

/// The parts a BSDF may have; a bit set.
enum Lobe : uint8_t {
  kLobeNone = 0,
  kLobeDiffuse = 1,            // reflection without a preferred direction
  kLobeGlossy = 2,             // any other finite density, reflected or transmitted
  kLobeDeltaReflection = 4,    // mirror
  kLobeDeltaTransmission = 8,  // refraction, straight pass
  kLobeDelta = kLobeDeltaReflection | kLobeDeltaTransmission,
  kLobeSmooth = kLobeDiffuse | kLobeGlossy,
};

/// A direction drawn by a BSDF, in the local shading frame.
struct BsdfSample {
  Vec3 wi;       // unit, away from the surface
  Color weight;  // f·|cosθ_i| / pdf, for delta lobes the reflected share / pdf; without η² (see
                 // Scattering)
  float pdf;     // per solid angle including the choice of lobe; for delta lobes the discrete
                 // probability
  float eta = 1;          // IOR on the side of wi over IOR on the side of wo; 1 for reflection
  Lobe lobe = kLobeNone;  // the one lobe that was sampled

  bool is_delta() const { return lobe & kLobeDelta; }
};

/// What the finite lobes do between two directions; delta lobes are never seen here.
struct BsdfEvaluation {
  Color value{0.0f};      // f(wo, wi)·|cosθ_i|
  float pdf = 0;          // of sample() to draw wi by a finite lobe, per solid angle, the choice of
                          // lobe included
  float pdf_reverse = 0;  // the same for drawing wo if the path came from wi
};

/// One perfectly specular event, for walks that choose it rather than draw it.
struct SpecularEvent {
  Vec3 wi;
  Color value;        // share of the radiance that goes this way, without η²
  float probability;  // with which sample() takes this event
  float eta = 1;
};

/// A scattering function in a local frame whose z is the shading normal; wo and wi are unit and
/// point away from the surface. It is written once, for no particular transport direction, as the
/// *flux* form without the η² of radiance compression; η² and Veach's shading-normal correction are
/// applied in one place, the class Scattering. Except for these it is reciprocal (each
/// implementation says if not), and its sampling does not depend on the transport direction.
/// Immutable.
class Bsdf {
 public:
  virtual ~Bsdf() = default;

  virtual BsdfEvaluation evaluate(const SurfacePoint& point, Vec3 wo, Vec3 wi) const = 0;

  // One of the three alone.
  Color eval(const SurfacePoint& point, Vec3 wo, Vec3 wi) const {
    return evaluate(point, wo, wi).value;
  }
  float pdf(const SurfacePoint& point, Vec3 wo, Vec3 wi) const {
    return evaluate(point, wo, wi).pdf;
  }

  /// u_lobe chooses, u directs. Empty where nothing is scattered.
  virtual std::optional<BsdfSample> sample(const SurfacePoint& point, Vec3 wo, float u_lobe,
                                           Vec2 u) const = 0;

  /// The delta event of one kind (kLobeDeltaReflection or kLobeDeltaTransmission), empty if there
  /// is none.
  virtual std::optional<SpecularEvent> specular(const SurfacePoint& point, Vec3 wo,
                                                Lobe lobe) const {
    (void)point, (void)wo, (void)lobe;
    return std::nullopt;
  }

  /// All lobes the BSDF may have anywhere on the surface.
  virtual int lobes() const = 0;

  /// Interior over exterior IOR where light is refracted; 1 where it is not.
  virtual float eta() const { return 1; }

  /// Approximate share of light reflected or transmitted: the albedo layer.
  virtual Color albedo(const SurfacePoint& point) const = 0;

  /// Normal and bump maps return the perturbed shading frame; all others the frame as it is.
  virtual Frame shading_frame(const SurfacePoint& point) const { return point.frame; }
};

using BsdfList = std::vector<std::shared_ptr<const Bsdf>>;

/// Builds all BSDFs of a scene, in order.
BsdfList make_bsdfs(const SceneDescription& scene, const TextureList& textures);

}  // namespace guidelight
