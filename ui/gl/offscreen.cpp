#include "ui/gl/offscreen.h"

#include <epoxy/gl.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>

#include "ui/gl/raster_target.h"

namespace guidelight {

DisplayImage read_framebuffer(int width, int height) {
  DisplayImage image{width, height, std::vector<uint8_t>(size_t{4} * width * height)};
  const size_t row = size_t{4} * width;
  std::vector<uint8_t> upward(image.rgba.size());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, upward.data());
  for (int y = 0; y < height; ++y) {
    std::copy_n(upward.data() + row * (height - 1 - y), row, image.rgba.data() + row * y);
  }
  for (size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
  return image;
}

DisplayImage paint_offscreen(int width, int height, ImU32 background,
                             const std::function<void(ImDrawList&)>& paint) {
  const ImVec2 size(static_cast<float>(width), static_cast<float>(height));
  ImDrawList list(ImGui::GetDrawListSharedData());
  list._ResetForNewFrame();
  list.PushTextureID(ImGui::GetIO().Fonts->TexID);
  list.PushClipRect({0, 0}, size);
  paint(list);
  list.PopClipRect();
  list.PopTextureID();

  ImDrawList* lists[] = {&list};
  ImDrawData data;
  data.Valid = true;
  data.CmdLists = lists;
  data.CmdListsCount = 1;
  data.TotalVtxCount = list.VtxBuffer.Size;
  data.TotalIdxCount = list.IdxBuffer.Size;
  data.DisplaySize = size;
  data.FramebufferScale = {1, 1};

  RasterTarget target;
  const ImVec4 color = ImGui::ColorConvertU32ToFloat4(background);
  target.begin(width, height, Vec4(color.x, color.y, color.z, 1));
  ImGui_ImplOpenGL3_RenderDrawData(&data);
  DisplayImage image = read_framebuffer(width, height);
  RasterTarget::end();
  return image;
}

}  // namespace guidelight
