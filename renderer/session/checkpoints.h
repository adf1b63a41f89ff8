#pragma once

#include <string>

#include "renderer/io/checkpoint_file.h"
#include "renderer/session/render_session.h"

namespace guidelight {

/// What must agree for two renders to be parts of one: describe_render without what may differ,
/// such as passes and seed.
Metadata identity_of(const RenderJob& job);

/// Writes the progress of `job` to a checkpoint at `path` whenever it is called. Throws Error.
SaveProgress save_to(const std::string& path, const RenderJob& job);

/// The progress with which `job` goes on where the checkpoint ended. Throws Error, naming `path`
/// and what differs, if it was saved from another scene, integrator, setting, size or seed.
RenderProgress resume_from(const Checkpoint& checkpoint, const RenderJob& job,
                           const std::string& path);

/// What describe_render said when the checkpoint was saved, from which a session can be restored.
Metadata describe_checkpoint(const Checkpoint& checkpoint);

}  // namespace guidelight
