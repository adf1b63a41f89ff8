#pragma once

#include <functional>

#include "renderer/session/render_session.h"

namespace guidelight {

/// Renders one job pass after pass on the calling thread, until a target is reached or `control` asks to
/// stop (then Stopped is thrown, after the unfinished pass was published).
///
/// `publish` receives a snapshot after coarse pictures, after the first pass, and then so that publishing
/// takes a small share of the time. `seconds` tells the time spent, pauses excluded.
void render_progressively(const RenderJob& job, WorkControl& control,
                          const std::function<double()>& seconds,
                          const std::function<void(Snapshot)>& publish);

}  // namespace guidelight
