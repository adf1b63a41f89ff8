#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/scene_arguments.h"
#include "renderer/session/render_session.h"

namespace guidelight {

inline constexpr int kMostThreads = 1024;

/// The arguments that say how to render, alike in `render` and `view`.
struct RenderArguments {
  std::string integrator = "path";
  std::vector<std::string> settings;  // key=value
  int threads = 0;
  uint64_t seed = 0;

  void add_to(CLI::App& command);
  /// A job for the scene with these settings. Throws Error for an unknown integrator, key or value.
  RenderJob make_job(std::shared_ptr<const Scene> scene) const;
};

}  // namespace guidelight
