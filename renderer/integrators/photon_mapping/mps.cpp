#include "renderer/integrators/photon_mapping/mps.h"

#include "renderer/integrators/chain_description.h"
#include "renderer/integrators/mutation_parameters.h"
#include "renderer/integrators/photon_mapping/emission_stage.h"
#include "renderer/integrators/photon_mapping/photon_observer.h"
#include "renderer/metropolis/seeding.h"

namespace guidelight {

namespace {

struct MpsSettings : PhotonMappingSettings {
  int mutations = 100000;  // per pass
  int chains = 32;
  int seed_paths = 160000;        // per pass
  int importance_paths = 100000;  // in the first pass
  int importance_neighbors = 40;
  float max_angle = 30;  // γ of the photon-map perturbation [degrees]

  /// The six proposals of the source (Fan et al. 2005, section 5), and the multi-chain
  /// perturbation: without it, caustics that the eye sees by a mirror or through glass hold a chain
  /// for long, and its photons pile up in one place.
  MutationWeights weights{.bidirectional = 0.3f,
                          .guided = 0.1f,
                          .lens = 0.1f,
                          .caustic = 0.1f,
                          .multi_chain = 0.1f,
                          .lens_subpath = 0.2f,
                          .photon_map = 0.2f};

  MpsSettings() {
    alpha = 0.8f;
    light_paths = 20000;
  }
  std::vector<Parameter> parameters() override;
  std::unique_ptr<IntegratorSettings> clone() const override {
    return std::make_unique<MpsSettings>(*this);
  }
};

std::vector<Parameter> MpsSettings::parameters() {
  std::vector<Parameter> list = {
      {"mutations", "Mutations", "Mutations per pass.", "per pass", &mutations, 100, 1e9, true},
      {"chains", "Chains", "Independent chains, which share the mutations.", "", &chains, 1, 4096,
       true},
      {"seed_paths", "Seed paths",
       "Independent paths per pass, from which the power of all photons and the starts of the "
       "chains are taken.",
       "per pass", &seed_paths, 100, 10000000, true},
      {"importance_paths", "Importance paths",
       "Paths from the eye in the first pass, which tell how much of a photon is seen; more in "
       "later passes if the radius shrinks.",
       "per pass", &importance_paths, 100, 1e8, true},
      {"importance_neighbors", "Importons",
       "Nearest particles from the eye that an estimate of importance is made of.", "per estimate",
       &importance_neighbors, 2, static_cast<double>(EstimateSettings::kMaxNeighbors), true},
      {"light_paths", "Light paths",
       "Light paths per pass that leave photons beside those of the chains; they bound the power "
       "of "
       "photons in places that paths from the eye hardly know.",
       "per pass", &light_paths, 1, 100e6, true},
      {"max_angle", "Photon map angle",
       "Largest angle by which the photon map perturbation turns a path.", "degrees", &max_angle, 1,
       80},
  };
  add_mutation_parameters(weights, list);
  for (Parameter& parameter : PhotonMappingSettings::parameters()) {
    const bool is_of_emission =
        parameter.key == "light_paths" || parameter.key == "guided_fraction";
    if (!is_of_emission) list.push_back(std::move(parameter));
  }
  return list;
}

/// Photons need three segments at least: those of direct light are sampled.
PathLengths chain_lengths(const MpsSettings& settings) {
  constexpr int kShortest = 3;
  const int max =
      settings.max_length < 0 ? kLongestPath : std::min(settings.max_length, kLongestPath);
  return {std::max(settings.min_length, kShortest), max};
}

MutationWeights weights_of(const MpsSettings& settings) {
  MutationWeights weights = settings.weights;
  weights.max_angle = glm::radians(settings.max_angle);
  return weights;
}

constexpr uint64_t kChainStream = 0x6d7073ull;

class Mps : public Integrator {
 public:
  Mps(std::shared_ptr<const Scene> scene, const MpsSettings& settings)
      : scene_(std::move(scene)),
        settings_(settings),
        lengths_(chain_lengths(settings)),
        sharp_(settings.sharpness),
        leaves_photon_([this](const Path& path) { return photon_site(path, sharp_).has_value(); }),
        seeding_(*scene_, lengths_, leaves_photon_),
        chains_(*scene_, lengths_, weights_of(settings), leaves_photon_) {}

  void render_pass(uint32_t pass, Film& film, const PassContext& context) override {
    const PhotonMappingPass setup(*scene_, settings_, pass, context.seed);
    PassPhotons photons;
    if (lengths_.min <= lengths_.max) photons = trace(setup, context);
    show_photons(setup, photons, film, context);
  }

  std::optional<ChainStatistics> chain_statistics() const override {
    return describe_chains(chains_, seeding_);
  }

 private:
  PassPhotons trace(const PhotonMappingPass& setup, const PassContext& context) {
    chains_.follow(context.guides);
    seeding_.follow(context.guides);
    seeding_.draw(settings_.seed_paths, setup.seed, setup.pass, *context.parallel);
    if (!seeding_.can_start()) return EmissionStage::trace_all(setup, *context.parallel);
    start_chains(setup);
    std::vector<MarkovChain>& chains = chains_.list();
    // Estimates from more particles reach less far.
    const float growth = std::pow(static_cast<float>(setup.pass) + 1, 1 - settings_.alpha);
    const ImportanceMaps importance(
        setup,
        {static_cast<size_t>(static_cast<float>(settings_.importance_paths) * growth),
         settings_.importance_neighbors},
        *context.parallel);
    const auto steps = static_cast<uint64_t>(std::max(1, settings_.mutations / settings_.chains));
    const double scale = seeding_.normalization() / static_cast<double>(steps * chains.size());
    const PhotonPower power(importance, scale, settings_.light_paths);
    std::vector<PassPhotons> parts(chains.size() + 1);
    parts.back() = trace_light_paths(setup, power, *context.parallel);
    context.parallel->for_each(chains.size(), [&](size_t i) {
      PhotonObserver observer(setup, power, Rng(setup.seed ^ kChainStream, ~setup.pass, i));
      chains[i].run(steps, observer);
      parts[i] = observer.photons();
    });
    return join(parts);
  }

  PassPhotons trace_light_paths(const PhotonMappingPass& setup, const PhotonPower& power,
                                Parallel& parallel) const {
    return EmissionStage::trace_all(
        setup, parallel,
        [&](const PathVertex& vertex, const Scattering& scattering, bool for_caustic_map) {
          const Color importance = power.importance(vertex, scattering, for_caustic_map);
          return power.of_light_path(vertex.throughput, importance);
        });
  }

  /// Chains of every round start anew, so that no round repeats the faults of the one before.
  void start_chains(const PhotonMappingPass& setup) {
    const size_t count = settings_.chains;
    for (size_t i = 0; i < count; ++i) {
      chains_.start(i, seeding_.start_path(i, count),
                    Rng(setup.seed ^ kChainStream, setup.pass, i));
    }
  }

  std::shared_ptr<const Scene> scene_;
  MpsSettings settings_;
  PathLengths lengths_;
  SharpScattering sharp_;
  PathFilter leaves_photon_;
  Seeding seeding_;
  GuidedChains chains_;
};

}  // namespace

IntegratorInfo mps_info() {
  return {"mps", "Metropolis photon sampling",
          "Photon mapping with photons where the eye sees them, by chains of complete paths: good "
          "at rooms lit through small openings, above all with guide paths.",
          [](const RenderHints& hints) -> std::unique_ptr<IntegratorSettings> {
            auto settings = std::make_unique<MpsSettings>();
            settings->max_length = hints.max_depth.value_or(settings->max_length);
            return settings;
          },
          [](std::shared_ptr<const Scene> scene,
             const IntegratorSettings& settings) -> std::unique_ptr<Integrator> {
            return std::make_unique<Mps>(std::move(scene),
                                         dynamic_cast<const MpsSettings&>(settings));
          }};
}

}  // namespace guidelight
