#include "renderer/session/open_scene.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "renderer/error.h"
#include "renderer/integrators/integrator.h"
#include "renderer/io/scene_file.h"

namespace guidelight {

namespace {

/// Names that other renderers have for what our path tracer computes.
constexpr std::array<std::string_view, 5> kPathTracing = {"path", "volpath", "volpath_simple",
                                                          "volpathmis", "direct"};

bool is_path_tracing(const std::string& name) {
  return name.empty() || std::ranges::find(kPathTracing, name) != kPathTracing.end();
}

bool is_available(const std::string& name) {
  return is_path_tracing(name) ||
         std::ranges::any_of(integrators(), [&](const auto& info) { return info.name == name; });
}

/// Tells versions of a file apart: FNV-1a over its bytes, hexadecimal; zeros if it cannot be read.
std::string hash_of_file(const std::string& path) {
  std::error_code ignored;
  std::ifstream file;
  // Opening a pipe would wait for its other end.
  if (std::filesystem::is_regular_file(path, ignored)) file.open(path, std::ios::binary);
  uint64_t hash = file.is_open() ? 0xcbf29ce484222325ull : 0;
  std::array<char, 1 << 16> bytes;
  while (file.read(bytes.data(), bytes.size()), file.gcount() > 0) {
    for (std::streamsize i = 0; i < file.gcount(); ++i) {
      hash = (hash ^ static_cast<uint8_t>(bytes[static_cast<size_t>(i)])) * 0x100000001b3ull;
    }
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace

std::shared_ptr<SceneDescription> open_scene(const std::string& path,
                                             const std::map<std::string, std::string>& defines) {
  // Before it is read: of a file that changes meanwhile, the hash is at worst that of the version
  // before, which is then refused where the present one is asked for.
  const std::string hash = hash_of_file(path);
  auto scene = std::make_shared<SceneDescription>(read_scene(path, defines));
  scene->file_hash = hash;
  scene->path = std::filesystem::absolute(path).lexically_normal().string();
  scene->defines = defines;
  RenderHints& hints = scene->hints;
  // Direct light is path tracing that ends after one scattering.
  if (hints.integrator == "direct" && !hints.max_depth) hints.max_depth = 2;
  if (!is_available(hints.integrator)) {
    scene->warnings.push_back(fmt::format(
        "{}: the integrator '{}' is not available; 'path' stands in.", path, hints.integrator));
  } else if (!is_path_tracing(hints.integrator)) {
    scene->warnings.push_back(
        fmt::format("{}: the scene asks for the integrator '{}'; renders begin with 'path' unless "
                    "another is chosen.",
                    path, hints.integrator));
  }
  return scene;
}

}  // namespace guidelight
