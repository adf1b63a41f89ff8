#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace guidelight {

/// What the command line says about the viewer.
struct ViewerOptions {
  std::string scene_path;                      // empty: the window opens without a scene
  std::map<std::string, std::string> defines;  // <default> variables of that scene
  std::string integrator;                      // empty: the default
  int width = 0;                               // of the picture; 0: as the scene says
  int height = 0;
  int threads = 0;  // 0: all
  uint64_t seed = 0;
  float ui_scale = 0;                            // 0: as the monitor says
  std::function<void(double seconds)> on_frame;  // told how long each frame took, for benchmarks
};

/// Opens the window and returns when it is closed: the exit status of the program, 0.
/// Throws Error if no window can be opened, for instance without a display.
int run_viewer(const ViewerOptions& options);

}  // namespace guidelight
