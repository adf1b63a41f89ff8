#include "renderer/integrators/metropolis/pssmlt.h"

#include "renderer/integrators/chain_description.h"
#include "renderer/integrators/metropolis/chain_pass.h"
#include "renderer/metropolis/primary_chain.h"

namespace guidelight {

namespace {

struct PssmltSettings : ChainSettings {
  using ChainSettings::ChainSettings;

  float large_steps = 0.3f;

  std::vector<Parameter> parameters() override {
    std::vector<Parameter> list = ChainSettings::parameters();
    list.push_back({"large_steps", "Large steps",
                    "How often the path is replaced by an independent one.", "", &large_steps, 0.01,
                    1});
    return list;
  }
  std::unique_ptr<IntegratorSettings> clone() const override {
    return std::make_unique<PssmltSettings>(*this);
  }
};

class Pssmlt : public Integrator {
 public:
  Pssmlt(std::shared_ptr<const Scene> scene, const PssmltSettings& settings)
      : scene_(std::move(scene)), settings_(settings), pass_(scene_, settings_) {}

  void render_pass(uint32_t pass, Film& film, const PassContext& context) override {
    pass_.render(pass, film, context, chains_, [&](size_t i, Rng path_rng, Rng chain_rng) {
      if (i == chains_.size())
        chains_.emplace_back(pass_.seeding().sampler(), settings_.large_steps);
      chains_[i].start(path_rng, chain_rng);
    });
  }

  std::optional<ChainStatistics> chain_statistics() const override {
    return describe_chains(chains_, pass_.seeding());
  }

 private:
  std::shared_ptr<const Scene> scene_;
  PssmltSettings settings_;
  ChainPass pass_;
  std::vector<PrimaryChain> chains_;
};

}  // namespace

IntegratorInfo pssmlt_info() {
  return {"pssmlt", "Primary sample space Metropolis",
          "Chains over the random numbers of a bidirectional path sampler: the simple baseline of "
          "Metropolis methods.",
          [](const RenderHints& hints) -> std::unique_ptr<IntegratorSettings> {
            return std::make_unique<PssmltSettings>(hints);
          },
          [](std::shared_ptr<const Scene> scene,
             const IntegratorSettings& settings) -> std::unique_ptr<Integrator> {
            return std::make_unique<Pssmlt>(std::move(scene),
                                            dynamic_cast<const PssmltSettings&>(settings));
          }};
}

}  // namespace guidelight
