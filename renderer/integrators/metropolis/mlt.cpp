#include "renderer/integrators/metropolis/mlt.h"

#include "renderer/error.h"
#include "renderer/integrators/chain_description.h"
#include "renderer/integrators/metropolis/chain_pass.h"
#include "renderer/metropolis/bidirectional_mutation.h"
#include "renderer/metropolis/caustic_perturbation.h"
#include "renderer/metropolis/eye_perturbations.h"
#include "renderer/metropolis/lens_subpath_mutation.h"

namespace guidelight {

namespace {

struct MltSettings : ChainSettings {
  using ChainSettings::ChainSettings;

  // How often each mutation is tried, relative to the others.
  float bidirectional = 0.3f;
  float lens = 0.3f;
  float caustic = 0.15f;
  float multi_chain = 0.15f;
  float lens_subpath = 0.1f;
  float guided = 0.25f;  // of the bidirectional mutations

  std::vector<Parameter> parameters() override;
  std::unique_ptr<IntegratorSettings> clone() const override {
    return std::make_unique<MltSettings>(*this);
  }
};

std::vector<Parameter> MltSettings::parameters() {
  std::vector<Parameter> list = ChainSettings::parameters();
  const auto add = [&](const char* key, const char* label, const char* help, float& value) {
    list.push_back({key, label, help, "", &value, 0, 1});
  };
  add("bidirectional", "Bidirectional",
      "How often a part of the path is replaced by an independent one.", bidirectional);
  add("lens", "Lens perturbation", "How often the path moves a little in the picture.", lens);
  add("caustic", "Caustic perturbation",
      "How often light turns a little where it leaves for what the eye sees.", caustic);
  add("multi_chain", "Multi-chain perturbation",
      "How often a path through several specular surfaces moves a little.", multi_chain);
  add("lens_subpath", "Lens subpath",
      "How often the path is seen from an independent place in the picture.", lens_subpath);
  add("guided", "Guided share",
      "Share of the bidirectional mutations that follow guide paths, where there are any.", guided);
  return list;
}

class Mlt : public Integrator {
 public:
  Mlt(std::shared_ptr<const Scene> scene, const MltSettings& settings)
      : scene_(std::move(scene)), settings_(settings), pass_(scene_, settings_) {
    if (settings.bidirectional == 0) {
      throw Error(
          "without bidirectional mutations a chain cannot reach every path: give "
          "'bidirectional' more than 0");
    }
    make_mutations();
  }

  void render_pass(uint32_t pass, Film& film, const PassContext& context) override {
    if (guides_ != context.guides) follow(context.guides);
    pass_.render(pass, film, context, chains_, [&](Rng path_rng, Rng chain_rng) {
      Path path;
      pass_.seeding().sampler().sample(path, path_rng);
      return MarkovChain(mutations_, std::move(path), chain_rng);
    });
  }

  std::optional<ChainStatistics> chain_statistics() const override {
    ChainStatistics statistics = sum_statistics(mutations_, chains_, guides_.get());
    describe_normalization(pass_.seeding(), statistics);
    return statistics;
  }

 private:
  void make_mutations() {
    const PathLengths& lengths = pass_.lengths();
    mutations_ = {};
    mutations_.add(make_bidirectional_mutation(*scene_, lengths, guides_, settings_.guided),
                   settings_.bidirectional);
    mutations_.add(make_lens_perturbation(*scene_), settings_.lens);
    mutations_.add(make_caustic_perturbation(*scene_), settings_.caustic);
    mutations_.add(make_multi_chain_perturbation(*scene_), settings_.multi_chain);
    mutations_.add(make_lens_subpath_mutation(*scene_, lengths), settings_.lens_subpath);
  }

  void follow(std::shared_ptr<const GuideMixture> guides) {
    guides_ = std::move(guides);
    make_mutations();
    for (MarkovChain& chain : chains_) chain.forget_guides();
  }

  std::shared_ptr<const Scene> scene_;
  MltSettings settings_;
  ChainPass pass_;
  std::shared_ptr<const GuideMixture> guides_;
  MutationSet mutations_;
  std::vector<MarkovChain> chains_;
};

}  // namespace

IntegratorInfo mlt_info() {
  return {"mlt", "Metropolis light transport",
          "Chains of paths that explore what they have found: good at light through small openings "
          "and caustics by long paths, above all with guide paths.",
          [](const RenderHints& hints) -> std::unique_ptr<IntegratorSettings> {
            return std::make_unique<MltSettings>(hints);
          },
          [](std::shared_ptr<const Scene> scene,
             const IntegratorSettings& settings) -> std::unique_ptr<Integrator> {
            return std::make_unique<Mlt>(std::move(scene),
                                         dynamic_cast<const MltSettings&>(settings));
          }};
}

}  // namespace guidelight
