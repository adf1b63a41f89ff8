#include "renderer/integrators/metropolis/chain_pass.h"

#include <algorithm>

namespace guidelight {

namespace {

/// Emitters and direct light.
constexpr int kDirectLength = 2;

/// The path tracer has no shortest path.
bool separates(const ChainSettings& settings) {
  return settings.separate_direct && settings.min_length == 1;
}

/// Paths of up to two segments, by the path tracer.
std::unique_ptr<Integrator> direct_light(std::shared_ptr<const Scene> scene, int max_length) {
  const IntegratorInfo& info = find_integrator("path");
  const auto settings = info.make_settings({});
  set_parameter(*settings, "max_depth", std::to_string(std::min(max_length, kDirectLength)));
  return info.create(std::move(scene), *settings);
}

}  // namespace

ChainSettings::ChainSettings(const RenderHints& hints) {
  if (hints.max_depth && *hints.max_depth > 0)
    max_length = std::min(*hints.max_depth, kLongestPath);
}

std::vector<Parameter> ChainSettings::parameters() {
  return {
      {"max_length", "Longest path", "Longest path in segments.", "segments", &max_length, 1,
       kLongestPath},
      {"min_length", "Shortest path",
       "Shortest path in segments: 1 shows emitters, 2 begins with direct light.", "segments",
       &min_length, 1, kLongestPath},
      {"separate_direct", "Direct light apart",
       "Emitters and direct light are path traced, which is quicker where they are easy; not with "
       "a shortest path.",
       "", &separate_direct},
      {"direct_samples", "Direct samples",
       "Samples of the path traced part per pixel and pass; they cost little beside the mutations.",
       "per pixel", &direct_samples, 1, 1000, true,
       separates(*this) ? "" : "Direct light is not path traced apart."},
      {"mutations", "Mutations", "Mutations per pixel and pass.", "per pixel", &mutations, 0.1,
       1000, true},
      {"chains", "Chains", "Independent chains, which share the mutations.", "", &chains, 1, 4096,
       true},
      {"seed_paths", "Seed paths",
       "Independent paths per pass, from which the brightness of the picture and the starts of the "
       "chains are taken; at most half as many as mutations.",
       "per pass", &seed_paths, 100, 10000000, true},
  };
}

ChainPass::ChainPass(std::shared_ptr<const Scene> scene, const ChainSettings& settings)
    : settings_(settings),
      lengths_{separates(settings) ? kDirectLength + 1 : settings.min_length, settings.max_length},
      seeding_(*scene, lengths_) {
  if (separates(settings)) direct_ = direct_light(std::move(scene), settings.max_length);
}

uint64_t ChainPass::steps_per_chain(const Film& film) const {
  const double steps = static_cast<double>(film.width()) * film.height() * settings_.mutations;
  return static_cast<uint64_t>(std::max(1.0, steps / settings_.chains));
}

bool ChainPass::prepare(uint32_t pass, Film& film, const PassContext& context) {
  film.prepare_splats();
  if (direct_) {
    const auto samples = static_cast<uint32_t>(settings_.direct_samples);
    for (uint32_t i = 0; i < samples; ++i) {
      direct_->render_pass(pass * samples + i, film, context);
    }
  }
  if (lengths_.min > lengths_.max) return false;
  const uint64_t half = steps_per_chain(film) * settings_.chains / 2;
  const auto seeds = std::min<uint64_t>(settings_.seed_paths, std::max<uint64_t>(half, 1));
  seeds_.assign(seeds, {});
  seeding_.draw(seeds, context.seed, pass, *context.parallel,
                [&](size_t i, const Path& path, double pdf) {
                  seeds_[i] = {splat_of(path), path.target(), pdf};
                });
  return true;
}

}  // namespace guidelight
