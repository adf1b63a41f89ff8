#include <fmt/core.h>

#include "app/commands.h"
#include "app/scene_arguments.h"
#include "renderer/scene/scene.h"

namespace guidelight {

namespace {

const char* camera_model_name(CameraModel model) {
  switch (model) {
    case CameraModel::Perspective:
      return "perspective";
    case CameraModel::ThinLens:
      return "thin lens";
    case CameraModel::Orthographic:
      return "orthographic";
  }
  return "unknown";
}

std::string bytes_text(size_t bytes) {
  if (bytes < 1024) return fmt::format("{} B", bytes);
  if (bytes < 1024 * 1024) return fmt::format("{:.1f} KiB", bytes / 1024.0);
  return fmt::format("{:.1f} MiB", bytes / (1024.0 * 1024.0));
}

void print_info(const SceneArguments& arguments) {
  const auto scene = Scene::build(arguments.read());
  const SceneDescription& description = scene->description();
  const Scene::Statistics statistics = scene->statistics();
  const Bounds bounds = scene->bounds();
  fmt::print("scene       {}\n", description.path);
  fmt::print("shapes      {}\n", statistics.shapes);
  fmt::print("triangles   {}\n", statistics.triangles);
  fmt::print("instances   {}\n", statistics.instances);
  fmt::print("bsdfs       {}\n", description.bsdfs.size());
  fmt::print("textures    {}\n", description.textures.size());
  fmt::print("lights      {}\n", statistics.lights);
  fmt::print("memory      {}\n", bytes_text(statistics.bytes));
  if (!bounds.empty()) {
    fmt::print("bounds      ({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g})\n", bounds.lower.x,
               bounds.lower.y, bounds.lower.z, bounds.upper.x, bounds.upper.y, bounds.upper.z);
  }
  const Vec3 position = scene->camera().position();
  fmt::print("camera      {} at ({:.4g}, {:.4g}, {:.4g}), {} x {} pixels\n",
             camera_model_name(description.camera.model), position.x, position.y, position.z,
             description.film.width, description.film.height);
  if (!description.hints.integrator.empty()) {
    fmt::print("asks for    {}\n", description.hints.integrator);
  }
  fmt::print("warnings    {}\n", description.warnings.size());
  for (const std::string& warning : description.warnings) fmt::print("  {}\n", warning);
}

}  // namespace

void add_info_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("info", "List what a scene file holds");
  const auto arguments = std::make_shared<SceneArguments>();
  arguments->add_to(*command);
  command->callback([arguments] { print_info(*arguments); });
}

}  // namespace guidelight
