#include <fmt/core.h>

#include <filesystem>

#include "app/commands.h"
#include "app/guide_arguments.h"
#include "app/scene_arguments.h"
#include "renderer/error.h"
#include "renderer/io/guide_file.h"
#include "renderer/metropolis/harvest.h"
#include "renderer/metropolis/pilot.h"
#include "renderer/transport/guide_check.h"
#include "renderer/transport/guide_color.h"
#include "renderer/transport/guide_trace.h"

namespace guidelight {

namespace {

// -- guides check ---------------------------------------------------------------------------------

struct CheckCommand {
  SceneArguments scene_arguments;
  GuideArguments guides;

  void add_to(CLI::App& command) {
    scene_arguments.add_to(command);
    guides.add_to(command);
  }
  void run() const;
};

void CheckCommand::run() const {
  const auto scene = Scene::build(scene_arguments.read());
  const std::string file = guides.file_for(*scene);
  if (file.empty()) {
    throw Error("{} has no guides beside it: name a file with --guides", scene_arguments.path);
  }
  size_t faulty = 0;
  const auto list = read_guides(file);
  for (size_t i = 0; i < list.size(); ++i) {
    const auto faults = check_guide(*scene, list[i]);
    faulty += !faults.empty();
    fmt::print("{:3}  {}  {}\n", i, list[i].name, faults.empty() ? "good" : "faulty");
    for (const GuideFault& fault : faults) {
      fmt::print("     vertex {}: {}\n", fault.vertex, fault.message);
    }
  }
  if (faulty > 0) {
    throw Error("{}: {} of {} guides do not fit the scene: see above", file, faulty, list.size());
  }
}

// -- guides trace ---------------------------------------------------------------------------------

struct TraceCommand {
  SceneArguments scene_arguments;
  std::vector<float> from;
  std::vector<float> direction;
  std::vector<std::vector<float>> to;
  int bounces = 1;
  bool reflect = false;
  std::vector<float> cones = {5};
  GuidePath guide;
  std::string output;

  void add_to(CLI::App& command);
  void run() const;

 private:
  std::optional<GuidePath> trace(const Scene& scene) const;
};

void TraceCommand::add_to(CLI::App& command) {
  scene_arguments.add_to(command);
  command.add_option("--from", from, "Point on a light: x,y,z")
      ->delimiter(',')
      ->expected(3)
      ->required();
  auto* towards = command.add_option("--direction", direction, "Direction of the first segment")
                      ->delimiter(',')
                      ->expected(3);
  auto* bounce =
      command
          .add_option("--bounces", bounces, "Segments, from one surface that scatters to the next")
          ->check(CLI::Range(1, 32))
          ->capture_default_str();
  command.add_option("--to", to, "Point to aim a segment at: x,y,z; may be repeated")
      ->delimiter(',')
      ->type_size(3)
      ->excludes(towards)
      ->excludes(bounce);
  command.add_flag("--reflect", reflect, "Follow the reflection where glass also refracts");
  command
      .add_option("--cone", cones,
                  "Half-angle of each segment's cone [degrees], the last for all "
                  "that follow")
      ->delimiter(',')
      ->check(CLI::Range(1e-3, 90.0));
  command.add_option("--disc", guide.disc_radius, "Radius of the disc on the light [scene units]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--weight", guide.weight, "Share among the guides")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command.add_option("--name", guide.name, "Name of the guide");
  command.add_option("-o,--output", output, "File of guides to add it to, made if there is none");
}

std::optional<GuidePath> TraceCommand::trace(const Scene& scene) const {
  const auto vector = [](const std::vector<float>& v) { return Vec3(v[0], v[1], v[2]); };
  const auto choice = reflect ? SpecularChoice::Reflect : SpecularChoice::Refract;
  if (!direction.empty()) {
    const Vec3 towards = vector(direction);
    const float length = glm::length(towards);
    if (!(length > 0) || !std::isfinite(length)) {
      throw Error("--direction has no length: give it one");
    }
    return trace_guide(scene, vector(from), glm::normalize(towards), bounces, choice);
  }
  std::vector<Vec3> targets;
  for (const auto& target : to) targets.push_back(vector(target));
  if (targets.empty()) throw Error("no way to go: give --direction or --to");
  if (targets[0] == vector(from)) throw Error("--to is where --from is: give another point");
  return trace_guide_through(scene, vector(from), targets, choice);
}

void set_cones(GuidePath& guide, const std::vector<float>& degrees) {
  size_t segment = 0;
  for (GuideVertex& vertex : guide.vertices) {
    if (vertex.event != PathEvent::Scatter) continue;
    vertex.cone = glm::radians(degrees[std::min(segment++, degrees.size() - 1)]);
  }
}

void TraceCommand::run() const {
  const auto scene = Scene::build(scene_arguments.read());
  const auto traced = trace(*scene);
  if (!traced)
    throw Error(
        "no light shines from there, or its path meets no surface that scatters: give a point on a "
        "light and another direction");
  GuidePath result = guide;
  result.vertices = traced->vertices;
  set_cones(result, cones);
  for (const GuideFault& fault : check_guide(*scene, result)) {
    throw Error("vertex {} of the path: {}", fault.vertex, fault.message);
  }
  if (output.empty()) {
    fmt::print("{}", guides_text({result}));
    return;
  }
  std::vector<GuidePath> list;
  if (std::filesystem::exists(output)) list = read_guides(output);
  result.color = guide_color(list.size());
  list.push_back(result);
  write_guides(output, list);
  fmt::print("{}: {} guides\n", output, list.size());
}

// -- ways of light --------------------------------------------------------------------------------

/// What harvest and pilot do with what they find.
struct WaysOutput {
  size_t count = 10;
  std::string file;

  void add_to(CLI::App& command) {
    command.add_option("--count", count, "Ways to keep, the strongest first")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command.add_option("-o,--output", file, "File of guides to add them to, made if there is none");
  }
  /// Lists them and adds them to the file.
  void take(const std::vector<HarvestedPath>& found) const;
};

void WaysOutput::take(const std::vector<HarvestedPath>& found) const {
  std::vector<GuidePath> list;
  if (!file.empty() && std::filesystem::exists(file)) list = read_guides(file);
  for (const HarvestedPath& path : found) {
    fmt::print("{:6.2f} %  {}\n", 100 * path.share, path.guide.name);
    list.push_back(path.guide);
    list.back().color = guide_color(list.size() - 1);
  }
  if (file.empty()) return;
  write_guides(file, list);
  fmt::print("{}: {} guides\n", file, list.size());
}

// -- guides harvest -------------------------------------------------------------------------------

struct HarvestCommand {
  SceneArguments scene_arguments;
  std::string pixel;
  std::string crop;
  int samples = 200000;
  WaysOutput output;

  void add_to(CLI::App& command);
  void run() const;

 private:
  PixelRegion region(const Camera& camera) const;
};

void HarvestCommand::add_to(CLI::App& command) {
  scene_arguments.add_to(command);
  auto* one = command.add_option("--pixel", pixel, "Light of this pixel: x,y");
  command.add_option("--crop", crop, "Light of these pixels: x0,y0,x1,y1")->excludes(one);
  command.add_option("--samples", samples, "Paths to draw")
      ->check(CLI::Range(1, 1000000000))
      ->capture_default_str();
  output.add_to(command);
}

PixelRegion HarvestCommand::region(const Camera& camera) const {
  const int width = camera.width();
  const int height = camera.height();
  if (!crop.empty()) return parse_region("--crop", crop, width, height);
  if (!pixel.empty()) return parse_pixel("--pixel", pixel, width, height);
  throw Error("no part of the picture is named: give --pixel or --crop");
}

void HarvestCommand::run() const {
  const auto scene = Scene::build(scene_arguments.read());
  const auto found = harvest(*scene, region(scene->camera()), samples, output.count, false);
  if (found.empty()) throw Error("no light was found there: draw more paths with --samples");
  output.take(found);
}

// -- guides pilot ---------------------------------------------------------------------------------

struct PilotCommand {
  SceneArguments scene_arguments;
  uint64_t mutations = 500000;
  WaysOutput output;

  void add_to(CLI::App& command) {
    scene_arguments.add_to(command);
    command.add_option("--mutations", mutations, "Length of the run")
        ->check(CLI::Range(1, 1000000000))
        ->capture_default_str();
    output.add_to(command);
  }
  void run() const;
};

void PilotCommand::run() const {
  const auto scene = Scene::build(scene_arguments.read());
  const auto found = pilot_guides(*scene, mutations, output.count, false);
  if (found.empty()) {
    throw Error("no indirect light was found that a guide could lead: try 'guides trace'");
  }
  output.take(found);
}

template <typename Command>
void add(CLI::App& group, const char* name, const char* help) {
  CLI::App* command = group.add_subcommand(name, help);
  const auto arguments = std::make_shared<Command>();
  arguments->add_to(*command);
  command->callback([arguments] { arguments->run(); });
}

}  // namespace

void add_guides_command(CLI::App& app) {
  CLI::App* group = app.add_subcommand("guides", "Check, trace, harvest and find guide paths");
  group->require_subcommand(1);
  add<CheckCommand>(*group, "check", "Say of each guide whether it fits the scene");
  add<TraceCommand>(*group, "trace", "Trace a guide from a point on a light");
  add<HarvestCommand>(*group, "harvest",
                      "List the ways on which light reaches a part of the picture");
  add<PilotCommand>(*group, "pilot", "Make guides from the paths of a short run of chains");
}

}  // namespace guidelight
