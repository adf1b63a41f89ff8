#include <chrono>
#include <filesystem>
#include <thread>

#include "app/chain_report.h"
#include "app/commands.h"
#include "app/guide_arguments.h"
#include "app/interrupt.h"
#include "app/message.h"
#include "app/progress_bar.h"
#include "app/render_arguments.h"
#include "renderer/error.h"
#include "renderer/image/technique_images.h"
#include "renderer/io/atomic_file.h"
#include "renderer/session/checkpoints.h"
#include "renderer/session/picture_export.h"

namespace guidelight {

namespace {

constexpr uint32_t kDefaultPasses = 64;

struct RenderCommand {
  SceneArguments scene;
  RenderArguments render;
  GuideArguments guides;
  std::vector<std::string> outputs;
  RenderTargets targets;
  std::string techniques;
  std::string crop;
  std::string checkpoint;
  bool resume = false;
  bool full_float = false;
  bool statistics = false;

  void add_to(CLI::App& command) {
    scene.add_to(command);
    render.add_to(command);
    guides.add_to(command);
    command.add_option("-o,--output", outputs, "Picture to write, .exr or .png; may be repeated")
        ->required()
        ->allow_extra_args(false);
    auto* passes = command.add_option("--spp", targets.passes, "Stop after N samples per pixel");
    auto* seconds = command.add_option("--time", targets.seconds, "Stop after S seconds");
    auto* error = command.add_option("--error", targets.relative_error,
                                     "Stop at this estimated relative error, e.g. 0.02");
    passes->check(CLI::PositiveNumber)->excludes(seconds)->excludes(error);
    seconds->check(CLI::PositiveNumber)->excludes(error);
    error->check(CLI::PositiveNumber);
    command.add_option("--techniques", techniques,
                       "Write what each technique of bdpt or vcm brought to this .exr");
    command.add_option("--crop", crop, "Render only x0,y0,x1,y1 [pixels]");
    command.add_flag("--float", full_float, "Write 32-bit floats to .exr, not 16-bit");
    command.add_flag("--statistics", statistics,
                     "Print how the Markov chains of mlt, pssmlt or mps fared");
    auto* save = command.add_option("--checkpoint", checkpoint, "Save the progress to this file");
    command.add_flag("--resume", resume, "Go on from the checkpoint if it exists")->needs(save);
  }

  void run() const;

 private:
  RenderJob make_job() const;
};

RenderJob RenderCommand::make_job() const {
  RenderJob job = render.make_job(Scene::build(scene.read()));
  const SceneDescription& description = job.scene->description();
  for (const std::string& warning : description.warnings) {
    say("guidelight: warning: {}\n", warning);
  }
  job.guides = guides.read(*job.scene);
  job.priority = Priority::Normal;
  job.targets = targets;
  if (targets.passes == 0 && targets.seconds == 0 && targets.relative_error == 0) {
    job.targets.passes = description.hints.samples_per_pixel.value_or(kDefaultPasses);
  }
  const Camera& camera = job.scene->camera();
  if (!crop.empty()) job.region = parse_region("--crop", crop, camera.width(), camera.height());
  if (resume && std::filesystem::exists(checkpoint)) {
    job.resume_from = resume_from(read_checkpoint(checkpoint), job, checkpoint);
  }
  if (!techniques.empty()) {
    job.techniques = std::make_shared<TechniqueImages>(camera.width(), camera.height());
  }
  if (!checkpoint.empty()) job.save = save_to(checkpoint, job);
  return job;
}

void RenderCommand::run() const {
  for (const std::string& path : outputs) {
    check_argument("--output", [&] { check_picture_path(path); });
    check_writable(path);
  }
  if (!checkpoint.empty()) check_writable(checkpoint);
  if (!techniques.empty()) {
    check_argument("--techniques", [&] { check_techniques(techniques, render.integrator); });
    check_writable(techniques);
  }
  const RenderJob job = make_job();
  const InterruptGuard interrupt;
  ProgressBar progress;
  RenderSession session;
  session.start(job);
  uint64_t shown = 0;
  for (;;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const auto snapshot = session.snapshot();
    if (snapshot->state == SessionState::Finished || snapshot->state == SessionState::Failed) break;
    if (interrupt.interrupted()) {
      session.stop();
      break;
    }
    if (snapshot->generation != shown) progress.show(*snapshot);
    shown = snapshot->generation;
  }
  session.wait();
  const auto snapshot = session.snapshot();
  progress.finish(*snapshot);
  const bool failed = snapshot->state == SessionState::Failed;
  if (failed && !snapshot->has_picture()) throw Error(snapshot->error);
  if (snapshot->rejected_samples > 0) {
    say("guidelight: warning: {} samples were not finite and count as black\n",
        snapshot->rejected_samples);
  }
  if (statistics && snapshot->chains) fmt::print("{}", chain_report(*snapshot->chains));
  for (const std::string& path : outputs) {
    export_picture(path, job, *snapshot, full_float);
    fmt::print("{}\n", path);
  }
  if (!techniques.empty()) {
    export_techniques(techniques, job, *snapshot);
    fmt::print("{}\n", techniques);
  }
  // What had been rendered until then is not lost.
  if (failed) throw Error(snapshot->error);
  if (!snapshot->save_error.empty()) throw Error(snapshot->save_error);
}

}  // namespace

void add_render_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("render", "Render a scene to pictures");
  const auto arguments = std::make_shared<RenderCommand>();
  arguments->add_to(*command);
  command->callback([arguments] { arguments->run(); });
}

}  // namespace guidelight
