#pragma once

#include <string>

#include "renderer/image/tonemap.h"
#include "renderer/io/image_file.h"
#include "renderer/session/render_session.h"

namespace guidelight {

/// What travels with every picture: scene, its hash and variables, integrator and parameters,
/// passes, seconds, seed, camera. Keys are lower case, e.g. "scene", "scene_hash", "define.detail",
/// "integrator", "set.max_depth", "passes".
Metadata describe_render(const RenderJob& job, const Snapshot& snapshot);

/// Writes all layers, linear, with metadata; only the job's region, if it has one. Throws Error.
void export_exr(const std::string& path, const RenderJob& job, const Snapshot& snapshot,
                bool half_precision = true);

/// Writes one layer as a screen shows it, with metadata. Throws Error.
void export_png(const std::string& path, const RenderJob& job, const Snapshot& snapshot,
                const DisplaySettings& display, Layer layer = Layer::Beauty);

/// Throws Error unless techniques of this integrator can be written to `path`.
void check_techniques(const std::string& path, const std::string& integrator);

/// Writes the job's techniques as layers, weighted and raw: "connection_s2_t3.weighted" … Throws
/// Error, also if the method has no techniques to keep apart.
void export_techniques(const std::string& path, const RenderJob& job, const Snapshot& snapshot);

/// By the ending of `path`, .exr or .png. Throws Error for any other.
void export_picture(const std::string& path, const RenderJob& job, const Snapshot& snapshot,
                    bool full_float = false);

/// Whether `path` has an ending that export_picture knows, in capitals or not.
bool is_picture_path(const std::string& path);

/// Throws Error unless is_picture_path.
void check_picture_path(const std::string& path);

}  // namespace guidelight
