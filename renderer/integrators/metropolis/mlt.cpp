#include "renderer/integrators/metropolis/mlt.h"

#include "renderer/error.h"
#include "renderer/integrators/metropolis/film_observer.h"
#include "renderer/metropolis/bidirectional_mutation.h"
#include "renderer/metropolis/caustic_perturbation.h"
#include "renderer/metropolis/eye_perturbations.h"
#include "renderer/metropolis/lens_subpath_mutation.h"
#include "renderer/metropolis/markov_chain.h"
#include "renderer/metropolis/seeding.h"

namespace guidelight {

namespace {

struct MltSettings : IntegratorSettings {
  int max_length = 12;
  int min_length = 1;
  bool separate_direct = true;
  float mutations = 4;  // per pixel and pass
  int chains = 64;
  int seed_paths = 40000;  // per pass
  float bidirectional = 0.3f;
  float lens = 0.3f;
  float caustic = 0.15f;
  float multi_chain = 0.15f;
  float lens_subpath = 0.1f;

  std::vector<Parameter> parameters() override;
  std::unique_ptr<IntegratorSettings> clone() const override {
    return std::make_unique<MltSettings>(*this);
  }
};

std::vector<Parameter> MltSettings::parameters() {
  std::vector<Parameter> list = {
      {"max_length", "Longest path", "Longest path in segments.", "segments", &max_length, 1, 64},
      {"min_length", "Shortest path",
       "Shortest path in segments: 1 shows emitters, 2 begins with direct light.", "segments",
       &min_length, 1, 64},
      {"separate_direct", "Direct light apart",
       "Emitters and direct light are path traced, which is quicker where they are easy.", "",
       &separate_direct},
      {"mutations", "Mutations", "Mutations per pixel and pass.", "per pixel", &mutations, 0.1,
       1000, true},
      {"chains", "Chains", "Independent chains, which share the mutations.", "", &chains, 1, 4096,
       true},
      {"seed_paths", "Seed paths",
       "Independent paths per pass, from which the brightness of the picture and the starts of the "
       "chains are taken.",
       "per pass", &seed_paths, 100, 10000000, true},
  };
  const auto add_weight = [&](const char* key, const char* label, const char* help, float& value) {
    list.push_back({key, label, help, "", &value, 0, 1});
  };
  add_weight("bidirectional", "Bidirectional",
             "How often a part of the path is replaced by an independent one.", bidirectional);
  add_weight("lens", "Lens perturbation", "How often the path moves a little in the picture.",
             lens);
  add_weight("caustic", "Caustic perturbation",
             "How often light turns a little where it leaves for a caustic.", caustic);
  add_weight("multi_chain", "Multi-chain perturbation",
             "How often a path through several specular surfaces moves a little.", multi_chain);
  add_weight("lens_subpath", "Lens subpath",
             "How often the path is seen from an independent place in the picture.", lens_subpath);
  return list;
}

/// Emitters and direct light.
constexpr int kDirectLength = 2;

/// The path tracer has no shortest path.
bool separates(const MltSettings& settings) {
  return settings.separate_direct && settings.min_length == 1;
}

/// Paths of up to two segments, by the path tracer.
std::unique_ptr<Integrator> direct_light(std::shared_ptr<const Scene> scene, int max_length) {
  const IntegratorInfo& info = find_integrator("path");
  const auto settings = info.make_settings({});
  set_parameter(*settings, "max_depth", std::to_string(std::min(max_length, kDirectLength)));
  return info.create(std::move(scene), *settings);
}

class Mlt : public Integrator {
 public:
  Mlt(std::shared_ptr<const Scene> scene, const MltSettings& settings)
      : scene_(std::move(scene)),
        settings_(settings),
        lengths_{separates(settings) ? kDirectLength + 1 : settings.min_length,
                 settings.max_length},
        seeding_(*scene_, lengths_) {
    if (separates(settings)) direct_ = direct_light(scene_, settings.max_length);
    mutations_.add(make_bidirectional_mutation(*scene_, lengths_), settings.bidirectional);
    mutations_.add(make_lens_perturbation(*scene_), settings.lens);
    mutations_.add(make_caustic_perturbation(*scene_), settings.caustic);
    mutations_.add(make_multi_chain_perturbation(*scene_), settings.multi_chain);
    mutations_.add(make_lens_subpath_mutation(*scene_, lengths_), settings.lens_subpath);
    if (settings.bidirectional == 0) {
      throw Error(
          "without bidirectional mutations a chain cannot reach every path: give "
          "'bidirectional' more than 0");
    }
  }

  void render_pass(uint32_t pass, Film& film, const PassContext& context) override {
    film.prepare_splats();
    if (direct_) direct_->render_pass(pass, film, context);
    if (lengths_.min > lengths_.max) return;
    Parallel& parallel = *context.parallel;
    seeding_.draw(settings_.seed_paths, context.seed, pass, parallel);
    if (chains_.empty() && seeding_.normalization() > 0) start_chains(pass, context.seed);
    run_chains(film, parallel);
  }

 private:
  void start_chains(uint32_t pass, uint64_t seed) {
    const size_t count = settings_.chains;
    for (size_t i = 0; i < count; ++i) {
      // A render that is resumed starts new chains.
      chains_.emplace_back(mutations_, seeding_.start(i, count),
                           Rng(seed, (uint64_t{1} << 32) + pass, i));
    }
  }

  void run_chains(Film& film, Parallel& parallel) {
    const double pixels = static_cast<double>(film.width()) * film.height();
    const auto steps = static_cast<uint64_t>(
        std::max(1.0, pixels * settings_.mutations / static_cast<double>(settings_.chains)));
    const double scale = seeding_.normalization();
    parallel.for_each(chains_.size(), [&](size_t i) {
      FilmObserver observer(film, scale, Rng(i, steps, chains_[i].steps()));
      chains_[i].run(steps, observer);
      observer.flush();
    });
    film.add_splat_count(steps * settings_.chains);
  }

  std::shared_ptr<const Scene> scene_;
  MltSettings settings_;
  PathLengths lengths_;
  Seeding seeding_;
  MutationSet mutations_;
  std::unique_ptr<Integrator> direct_;
  std::vector<MarkovChain> chains_;
};

}  // namespace

IntegratorInfo mlt_info() {
  return {"mlt", "Metropolis light transport",
          "Chains of paths that explore what they have found: good at light through small openings "
          "and caustics by long paths, above all with guide paths.",
          [](const RenderHints& hints) -> std::unique_ptr<IntegratorSettings> {
            auto settings = std::make_unique<MltSettings>();
            if (hints.max_depth && *hints.max_depth > 0) {
              settings->max_length = std::min(*hints.max_depth, 64);
            }
            return settings;
          },
          [](std::shared_ptr<const Scene> scene,
             const IntegratorSettings& settings) -> std::unique_ptr<Integrator> {
            return std::make_unique<Mlt>(std::move(scene),
                                         dynamic_cast<const MltSettings&>(settings));
          }};
}

}  // namespace guidelight
