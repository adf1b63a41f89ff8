#include "ui/techniques/technique_browser.h"

#include <fmt/format.h>

#include <algorithm>

#include "ui/format.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr ImU32 kMerging = IM_COL32(120, 190, 255, 255);

bool contains(Vec2 corner, Vec2 size, Vec2 point) {
  return glm::all(glm::greaterThanEqual(point, corner)) &&
         glm::all(glm::lessThan(point, corner + size));
}

void draw_headings(const PyramidLayout& layout, float left, ImDrawList& list) {
  const float line = ImGui::GetTextLineHeight();
  for (int s = 0; s < layout.columns(); ++s) {
    const Vec2 corner = layout.corner(0, s);
    centered_text(list, corner + Vec2(layout.size().x / 2, -0.75f * line), palette::kDim,
                  fmt::format("s {}", s));
  }
  for (size_t row = 0; row < layout.rows().size(); ++row) {
    const auto [length, is_merging] = layout.rows()[row];
    const std::string text =
        is_merging ? "merged" : fmt::format("{} segment{}", length, length == 1 ? "" : "s");
    const float y = layout.corner(row, 0).y + (layout.size().y - line) / 2;
    list.AddText({left, std::round(y)}, is_merging ? kMerging : palette::kDim, text.c_str());
  }
}

}  // namespace

void TechniqueBrowser::draw(Document& document, const ViewTransform& transform, ImDrawList& list,
                            const Room& room) {
  TechniqueView& view = document.technique_view();
  take_pictures();
  const Vec2 middle = room.corner + 0.5f * room.size;
  const Vec2 picture_size(document.settings().width, document.settings().height);
  if (!pictures_) {
    centered_text(list, middle, palette::kDim, "The techniques are shown after the next pass.");
  } else if (pictures_->thumbnails.empty()) {
    centered_text(list, middle, palette::kDim, "No technique has found any light yet.");
  } else if (view.enlarged) {
    draw_large(view, picture_size, transform, list, room);
    if (room.click) view.enlarged.reset();
  } else {
    draw_pyramid(view, picture_size.x / picture_size.y, list, room);
  }
}

void TechniqueBrowser::take_pictures() {
  if (pictures_ == gallery_.pictures()) return;
  pictures_ = gallery_.pictures();
  if (!pictures_) return;
  if (pictures_->stack.height > 0) stack_.upload(pictures_->stack);
  if (pictures_->enlarged) large_.upload(pictures_->large);
}

void TechniqueBrowser::draw_pyramid(TechniqueView& view, float aspect, ImDrawList& list,
                                    const Room& room) const {
  const float line = ImGui::GetTextLineHeight();
  const float margin = scaled(14);
  const Vec2 labels(ImGui::CalcTextSize("6 segments").x + margin, 4 * line);
  const auto& thumbnails = pictures_->thumbnails;
  std::vector<TechniqueImages::Technique> techniques;
  for (const auto& thumbnail : thumbnails) techniques.push_back(thumbnail.technique);
  const PyramidLayout layout(techniques, room.corner + margin + labels,
                             room.size - 2.0f * margin - labels, aspect, scaled(6));
  draw_headings(layout, room.corner.x + margin, list);
  std::string text =
      "A row for each length of paths, a column for each number of light vertices.\n"
      "Point at one for its figures, click to enlarge it.";
  for (size_t i = 0; i < thumbnails.size(); ++i) {
    const Vec2 corner = layout.corner(techniques[i]);
    const bool lit = room.hovered && contains(corner, layout.size(), room.mouse);
    draw_thumbnail(i, corner, corner + layout.size(), list);
    if (techniques[i].is_merging || lit) {
      list.AddRect(to_imgui(corner), to_imgui(corner + layout.size()),
                   lit ? palette::kAccent : kMerging, 0, 0, scaled(lit ? 2 : 1));
    }
    if (lit) text = caption(i, view.weighted);
    if (room.click && contains(corner, layout.size(), *room.click)) view.enlarged = techniques[i];
  }
  list.AddText(to_imgui(room.corner + margin), palette::kText, text.c_str());
}

void TechniqueBrowser::draw_thumbnail(size_t index, Vec2 corner, Vec2 other,
                                      ImDrawList& list) const {
  // Half a texel away from the edges, where the neighbours would shine in.
  const Vec2 texel = 0.5f / Vec2(pictures_->stack.width, pictures_->stack.height);
  const auto count = static_cast<float>(pictures_->thumbnails.size());
  const Vec2 from = Vec2(0, static_cast<float>(index) / count) + texel;
  const Vec2 to = Vec2(1, static_cast<float>(index + 1) / count) - texel;
  list.AddImage(stack_.id(), to_imgui(corner), to_imgui(other), to_imgui(from), to_imgui(to));
}

void TechniqueBrowser::draw_large(const TechniqueView& view, Vec2 picture_size,
                                  const ViewTransform& transform, ImDrawList& list,
                                  const Room& room) {
  const Vec2 corner = transform.to_screen(Vec2(0));
  const Vec2 other = transform.to_screen(picture_size);
  const auto& thumbnails = pictures_->thumbnails;
  const auto found =
      std::ranges::find(thumbnails, *view.enlarged, &TechniquePictures::Thumbnail::technique);
  const auto index = static_cast<size_t>(found - thumbnails.begin());
  if (pictures_->enlarged == view.enlarged) {
    const float texel = (other.x - corner.x) / static_cast<float>(pictures_->large.width);
    large_.set_smooth(texel != 1 && texel < 2);
    list.AddImage(large_.id(), to_imgui(corner), to_imgui(other));
  } else if (found != thumbnails.end()) {
    draw_thumbnail(index, corner, other, list);  // until the large one comes
  }
  const std::string figures =
      found == thumbnails.end() ? describe(*view.enlarged) : caption(index, view.weighted);
  draw_hint(list, room.corner + Vec2(room.size.x / 2, 3 * ImGui::GetTextLineHeight()),
            figures + "\nClick or press Esc to go back.");
}

std::string TechniqueBrowser::caption(size_t index, bool weighted) const {
  const auto& [technique, mean_color] = pictures_->thumbnails[index];
  const float mean = luminance(mean_color);
  std::string text = fmt::format("{}\nMean {} W/(m² sr)", describe(technique), format_value(mean));
  if (weighted && pictures_->luminance > 0) {
    text += ", " + format_percent(mean / pictures_->luminance) + " of the light shown here";
  }
  return text;
}

}  // namespace guidelight
