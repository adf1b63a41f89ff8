#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "renderer/session/render_session.h"

namespace guidelight {

/// The argument that names guides: --guides FILE, or else the file beside the scene if there is
/// one.
struct GuideArguments {
  std::string path;

  void add_to(CLI::App& command);
  /// The file for a scene; empty if there is none.
  std::string file_for(const Scene& scene) const;
  /// Null if there is no file. Prints a warning for each guide that does not fit the scene. Throws
  /// Error.
  GuideList read(const Scene& scene) const;
};

}  // namespace guidelight
