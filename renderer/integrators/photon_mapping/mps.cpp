#include "renderer/integrators/photon_mapping/mps.h"

#include "renderer/error.h"
#include "renderer/integrators/chain_description.h"
#include "renderer/integrators/photon_mapping/photon_observer.h"
#include "renderer/metropolis/bidirectional_mutation.h"
#include "renderer/metropolis/caustic_perturbation.h"
#include "renderer/metropolis/eye_perturbations.h"
#include "renderer/metropolis/lens_subpath_mutation.h"
#include "renderer/metropolis/markov_chain.h"
#include "renderer/metropolis/seeding.h"

namespace guidelight {

namespace {

struct MpsSettings : PhotonMappingSettings {
  int mutations = 200000;  // per pass
  int chains = 32;
  int seed_paths = 40000;         // per pass
  int importance_paths = 100000;  // in the first pass
  int importance_neighbors = 40;
  float max_angle = 30;  // γ of the photon-map perturbation [degrees]

  // The six proposals, relative to each other (Fan et al. 2005, section 5).
  float guided = 0.1f;
  float bidirectional = 0.3f;
  float photon_map = 0.2f;
  float caustic = 0.1f;
  float lens = 0.1f;
  float lens_subpath = 0.2f;
  // Not of the source: without it, caustics that the eye sees by a mirror or through glass hold a
  // chain for long, and its photons pile up in one place.
  float multi_chain = 0.1f;

  MpsSettings() { alpha = 0.8f; }
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
      {"importance_neighbors", "Importance per estimate",
       "Nearest particles from the eye that such an estimate is made of.", "",
       &importance_neighbors, 2, static_cast<double>(EstimateSettings::kMaxNeighbors), true},
      {"max_angle", "Photon map angle",
       "Largest angle by which the photon map perturbation turns a path.", "degrees", &max_angle, 1,
       80},
  };
  const auto add = [&](const char* key, const char* label, const char* help, float& value) {
    list.push_back({key, label, help, "", &value, 0, 1});
  };
  add("guided", "User paths (UP)", "How often a path follows a guide path, where there is one.",
      guided);
  add("bidirectional", "Bidirectional (BD)",
      "How often a part of the path is replaced by an independent one.", bidirectional);
  add("photon_map", "Photon map (PM)",
      "How often the path turns where the eye's first diffuse vertex sends it back to the light.",
      photon_map);
  add("caustic", "Caustic (CP)",
      "How often light turns a little where it leaves for what the eye sees.", caustic);
  add("lens", "Lens (LP)", "How often the path moves a little in the picture.", lens);
  add("lens_subpath", "Lens subpath (LS)",
      "How often the path is seen from an independent place in the picture.", lens_subpath);
  add("multi_chain", "Multi-chain",
      "How often a path through several specular surfaces moves a little.", multi_chain);
  for (Parameter& parameter : PhotonMappingSettings::parameters()) {
    const bool is_of_emission =
        parameter.key == "light_paths" || parameter.key == "guided_fraction";
    if (!is_of_emission) list.push_back(std::move(parameter));
  }
  return list;
}

/// Photons need three segments at least: those of direct light are sampled.
PathLengths chain_lengths(const MpsSettings& settings) {
  constexpr int kLongest = 64;
  constexpr int kShortest = 3;
  const int max = settings.max_length < 0 ? kLongest : std::min(settings.max_length, kLongest);
  return {std::max(settings.min_length, kShortest), max};
}

constexpr uint64_t kStream = 0x6d7073ull;

class Mps : public Integrator {
 public:
  Mps(std::shared_ptr<const Scene> scene, const MpsSettings& settings)
      : scene_(std::move(scene)),
        settings_(settings),
        lengths_(chain_lengths(settings)),
        sharp_(settings.sharpness),
        leaves_photon_([this](const Path& path) { return photon_site(path, sharp_).has_value(); }),
        seeding_(*scene_, lengths_, leaves_photon_) {
    if (settings.bidirectional == 0) {
      throw Error(
          "without bidirectional mutations a chain cannot reach every path: give "
          "'bidirectional' more than 0");
    }
    make_mutations();
  }

  void render_pass(uint32_t pass, Film& film, const PassContext& context) override {
    const PhotonMappingPass setup(*scene_, settings_, pass, context.seed);
    PassPhotons photons;
    if (lengths_.min <= lengths_.max) photons = trace(setup, context);
    show_photons(setup, photons, film, context);
  }

  std::optional<ChainStatistics> chain_statistics() const override {
    ChainStatistics statistics = sum_statistics(mutations_, chains_, guides_.get());
    describe_normalization(seeding_, statistics);
    return statistics;
  }

 private:
  /// UP and BD are one hybrid proposal.
  void make_mutations() {
    const float hybrid = settings_.bidirectional + (guides_ ? settings_.guided : 0);
    mutations_ = {};
    mutations_.add(
        make_bidirectional_mutation(*scene_, lengths_, guides_, settings_.guided / hybrid), hybrid);
    mutations_.add(make_photon_map_perturbation(*scene_, settings_.max_angle * kPi / 180),
                   settings_.photon_map);
    mutations_.add(make_caustic_perturbation(*scene_), settings_.caustic);
    mutations_.add(make_lens_perturbation(*scene_), settings_.lens);
    mutations_.add(make_lens_subpath_mutation(*scene_, lengths_), settings_.lens_subpath);
    mutations_.add(make_multi_chain_perturbation(*scene_), settings_.multi_chain);
  }

  void follow(std::shared_ptr<const GuideMixture> guides) {
    guides_ = std::move(guides);
    make_mutations();
    for (MarkovChain& chain : chains_) chain.forget_guides();
  }

  PassPhotons trace(const PhotonMappingPass& setup, const PassContext& context) {
    if (guides_ != context.guides) follow(context.guides);
    seeding_.draw(settings_.seed_paths, setup.seed, setup.pass, *context.parallel);
    if (seeding_.normalization() == 0) return {};
    if (chains_.empty()) start_chains(setup);
    // Estimates from more particles reach less far.
    const float growth = std::pow(static_cast<float>(setup.pass) + 1, 1 - settings_.alpha);
    const ImportanceMaps importance(
        setup,
        {static_cast<size_t>(static_cast<float>(settings_.importance_paths) * growth),
         settings_.importance_neighbors},
        *context.parallel);
    const auto steps = static_cast<uint64_t>(std::max(1, settings_.mutations / settings_.chains));
    const double scale = seeding_.normalization() / static_cast<double>(steps * chains_.size());
    std::vector<PassPhotons> parts(chains_.size());
    context.parallel->for_each(chains_.size(), [&](size_t i) {
      PhotonObserver observer(setup, importance, scale, Rng(setup.seed ^ kStream, ~setup.pass, i));
      chains_[i].run(steps, observer);
      parts[i] = observer.photons();
    });
    return join(parts);
  }

  void start_chains(const PhotonMappingPass& setup) {
    const size_t count = settings_.chains;
    for (size_t i = 0; i < count; ++i) {
      Rng path_rng = seeding_.start(i, count);
      Path path;
      seeding_.sampler().sample(path, path_rng);
      chains_.emplace_back(mutations_, std::move(path), Rng(setup.seed ^ kStream, setup.pass, i),
                           leaves_photon_);
    }
  }

  std::shared_ptr<const Scene> scene_;
  MpsSettings settings_;
  PathLengths lengths_;
  SharpScattering sharp_;
  PathFilter leaves_photon_;
  Seeding seeding_;
  std::shared_ptr<const GuideMixture> guides_;
  MutationSet mutations_;
  std::vector<MarkovChain> chains_;
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
