#include "renderer/integrators/metropolis/mlt.h"

#include "renderer/integrators/chain_description.h"
#include "renderer/integrators/metropolis/chain_pass.h"
#include "renderer/integrators/mutation_parameters.h"

namespace guidelight {

namespace {

struct MltSettings : ChainSettings {
  using ChainSettings::ChainSettings;

  MutationWeights weights{.bidirectional = 0.3f,
                          .guided = 0.1f,
                          .lens = 0.3f,
                          .caustic = 0.15f,
                          .multi_chain = 0.15f,
                          .lens_subpath = 0.1f};

  std::vector<Parameter> parameters() override;
  std::unique_ptr<IntegratorSettings> clone() const override {
    return std::make_unique<MltSettings>(*this);
  }
};

std::vector<Parameter> MltSettings::parameters() {
  std::vector<Parameter> list = ChainSettings::parameters();
  add_mutation_parameters(weights, list);
  return list;
}

class Mlt : public Integrator {
 public:
  Mlt(std::shared_ptr<const Scene> scene, const MltSettings& settings)
      : scene_(std::move(scene)),
        settings_(settings),
        pass_(scene_, settings_),
        chains_(*scene_, pass_.lengths(), settings.weights) {}

  void render_pass(uint32_t pass, Film& film, const PassContext& context) override {
    chains_.follow(context.guides);
    pass_.seeding().follow(context.guides);
    pass_.render(pass, film, context, chains_.list(), [&](size_t i, Rng path_rng, Rng chain_rng) {
      Path path;
      pass_.seeding().sampler().sample(path, path_rng);
      chains_.start(i, std::move(path), chain_rng);
    });
  }

  std::optional<ChainStatistics> chain_statistics() const override {
    return describe_chains(chains_, pass_.seeding());
  }

 private:
  std::shared_ptr<const Scene> scene_;
  MltSettings settings_;
  ChainPass pass_;
  GuidedChains chains_;
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
