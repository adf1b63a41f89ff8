#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/image/film.h"
#include "renderer/image/pixel_region.h"
#include "renderer/integrators/chain_statistics.h"
#include "renderer/integrators/parameters.h"
#include "renderer/parallel/parallel.h"
#include "renderer/scene/scene.h"

namespace guidelight {

class GuideMixture;
class PhotonRequest;
class PixelHistory;
class TechniqueImages;

/// What a pass needs besides the scene.
struct PassContext {
  uint64_t seed = 0;
  Parallel* parallel = nullptr;            // runs the loops, and says when to stop
  std::optional<PixelRegion> region = {};  // only these pixels are rendered
  /// Progressive photon mapping writes the history of the pixels that somebody looks at; may be
  /// null.
  PixelHistory* history = nullptr;
  /// Bidirectional methods keep their techniques apart in these; may be null.
  TechniqueImages* techniques = nullptr;
  /// Photon methods hand over the photons of the pass; may be null.
  PhotonRequest* photons = nullptr;
  /// Guide paths of the pass, which may be others than those of the pass before; null for none.
  std::shared_ptr<const GuideMixture> guides = {};
};

/// An algorithm that renders a scene progressively. It is constructed from a scene and its own
/// settings.
class Integrator {
 public:
  virtual ~Integrator() = default;

  /// Adds pass `pass` to the film: replayable, random numbers depend only on (seed, pass, path
  /// index). Throws Stopped if the loops were told to stop; the film then holds a part of the pass.
  /// Whoever calls this ends a whole pass with Film::finish_pass.
  virtual void render_pass(uint32_t pass, Film& film, const PassContext& context) = 0;

  /// Of Markov chains, after a pass; empty for methods without.
  virtual std::optional<ChainStatistics> chain_statistics() const { return std::nullopt; }
};

/// An entry of the list of integrators.
struct IntegratorInfo {
  std::string name;     // as on the command line
  std::string label;    // as in menus
  std::string summary;  // what it is good at, one sentence
  std::unique_ptr<IntegratorSettings> (*make_settings)(const RenderHints& hints);
  /// `settings` must come from make_settings of the same entry.
  std::unique_ptr<Integrator> (*create)(std::shared_ptr<const Scene> scene,
                                        const IntegratorSettings& settings);
  bool combines_techniques = false;  // and can keep them apart: PassContext::techniques
};

const std::vector<IntegratorInfo>& integrators();
/// Throws Error listing the known names.
const IntegratorInfo& find_integrator(const std::string& name);

}  // namespace guidelight
