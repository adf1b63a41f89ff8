#pragma once

#include <imgui.h>

#include <functional>

#include "renderer/image/image.h"

namespace guidelight {

/// The framebuffer in use, upper row first.
DisplayImage read_framebuffer(int width, int height);

/// Draws with ImGui's means into a picture of its own instead of the window. To be called between
/// the beginning and the end of a frame.
DisplayImage paint_offscreen(int width, int height, ImU32 background,
                             const std::function<void(ImDrawList&)>& paint);

}  // namespace guidelight
