#include "app/render_arguments.h"

namespace guidelight {

void RenderArguments::add_to(CLI::App& command) {
  command.add_option("--integrator", integrator, "Algorithm to render with")->capture_default_str();
  command.add_option("--set", settings, "Set a parameter of the integrator: key=value")
      ->allow_extra_args(false);
  command.add_option("--threads", threads, "Render threads, 0 for all processors")
      ->check(CLI::Range(0, kMostThreads))
      ->capture_default_str();
  command.add_option("--seed", seed, "Seed of the random numbers")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

RenderJob RenderArguments::make_job(std::shared_ptr<const Scene> scene) const {
  RenderJob job;
  const IntegratorInfo& info =
      check_argument("--integrator", [&] { return std::cref(find_integrator(integrator)); });
  std::shared_ptr<IntegratorSettings> parameters = info.make_settings(scene->description().hints);
  for (const std::string& setting : settings) {
    const auto [key, value] = split_assignment("--set", setting);
    check_argument("--set", [&] { set_parameter(*parameters, key, value); });
  }
  job.scene = std::move(scene);
  job.integrator = integrator;
  job.settings = std::move(parameters);
  job.threads = threads;
  job.seed = seed;
  return job;
}

}  // namespace guidelight
