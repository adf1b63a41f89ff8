#include <fmt/core.h>

#include <algorithm>

#include "app/commands.h"
#include "app/render_arguments.h"
#include "renderer/parallel/process_memory.h"
#include "ui/viewer.h"

namespace guidelight {
namespace {

struct ViewArguments {
  SceneArguments scene;
  ViewerOptions options;
  bool frame_times = false;
};

void print_frame_times(std::vector<double> seconds) {
  if (seconds.empty()) return;
  std::ranges::sort(seconds);
  const auto at = [&](double share) {
    return 1e3 * seconds[static_cast<size_t>(share * static_cast<double>(seconds.size() - 1))];
  };
  fmt::print("{} frames: median {:.1f} ms, 95 % below {:.1f} ms, longest {:.1f} ms\n",
             seconds.size(), at(0.5), at(0.95), at(1));
}

int open_window(ViewArguments& arguments) {
  return_large_blocks_to_the_system();
  ViewerOptions& options = arguments.options;
  options.scene_path = arguments.scene.path;
  for (const std::string& define : arguments.scene.defines) {
    options.defines.insert(split_assignment("-D", define));
  }
  if (!arguments.scene.size.empty()) {
    std::tie(options.width, options.height) = parse_size(arguments.scene.size);
  }
  if (!options.integrator.empty()) {
    check_argument("--integrator", [&] { find_integrator(options.integrator); });
  }
  std::vector<double> frames;
  if (arguments.frame_times) options.on_frame = [&](double seconds) { frames.push_back(seconds); };
  const int status = run_viewer(options);
  print_frame_times(std::move(frames));
  return status;
}

}  // namespace

void add_view_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("view", "Open the viewer's window (the default)");
  const auto arguments = std::make_shared<ViewArguments>();
  arguments->scene.add_to(*command, false);
  command->add_option("--integrator", arguments->options.integrator, "Algorithm to begin with");
  command->add_option("--threads", arguments->options.threads, "Render threads; 0 takes all")
      ->check(CLI::Range(0, kMostThreads));
  command->add_option("--seed", arguments->options.seed, "Seed of the random numbers")
      ->check(CLI::NonNegativeNumber);
  command
      ->add_option("--ui-scale", arguments->options.ui_scale, "Size of the interface, 1 is normal")
      ->check(CLI::Range(0.5f, 4.0f));
  command->add_flag("--frame-times", arguments->frame_times,
                    "Print how long the frames of the interface took, at the end");
  command->callback([arguments] { open_window(*arguments); });
}

}  // namespace guidelight
