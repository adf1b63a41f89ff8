#include "renderer/session/open_scene.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "renderer/error.h"
#include "renderer/integrators/integrator.h"
#include "renderer/io/scene_file.h"

namespace guidelight {

namespace {

/// Names that other renderers have for what our path tracer computes.
constexpr std::array<std::string_view, 5> kPathTracing = {"path", "volpath", "volpath_simple",
                                                          "volpathmis", "direct"};

bool is_available(const std::string& name) {
  return name.empty() || std::ranges::find(kPathTracing, name) != kPathTracing.end() ||
         std::ranges::any_of(integrators(), [&](const auto& info) { return info.name == name; });
}

}  // namespace

std::shared_ptr<SceneDescription> open_scene(const std::string& path,
                                             const std::map<std::string, std::string>& defines) {
  auto scene = std::make_shared<SceneDescription>(read_scene(path, defines));
  scene->path = std::filesystem::absolute(path).lexically_normal().string();
  scene->defines = defines;
  RenderHints& hints = scene->hints;
  // Direct light is path tracing that ends after one scattering.
  if (hints.integrator == "direct" && !hints.max_depth) hints.max_depth = 2;
  if (!is_available(hints.integrator)) {
    scene->warnings.push_back(fmt::format(
        "{}: the integrator '{}' is not available; 'path' stands in.", path, hints.integrator));
  }
  return scene;
}

}  // namespace guidelight
