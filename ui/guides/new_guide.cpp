#include "ui/guides/new_guide.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace guidelight {
namespace {

// Of equal brightness, told apart by people who confuse red and green (Okabe and Ito 2008).
const std::array kGuideColors = {Color(0.90f, 0.62f, 0.00f), Color(0.34f, 0.71f, 0.91f),
                                 Color(0.00f, 0.75f, 0.55f), Color(0.94f, 0.89f, 0.26f),
                                 Color(0.80f, 0.47f, 0.65f), Color(0.84f, 0.37f, 0.00f)};

bool is_taken(const std::vector<GuidePath>& guides, const std::string& name) {
  return std::ranges::find(guides, name, &GuidePath::name) != guides.end();
}

}  // namespace

void add_guide(Document& document, GuidePath guide, const std::string& label) {
  std::vector<GuidePath> guides = *document.guides();
  size_t number = guides.size() + 1;
  while (is_taken(guides, fmt::format("Guide {}", number))) ++number;
  guide.name = fmt::format("Guide {}", number);
  guide.color = kGuideColors[(number - 1) % kGuideColors.size()];
  guides.push_back(std::move(guide));
  document.edit_guides(std::move(guides), label);
  document.guide_view().selected = document.guides()->size() - 1;
}

void duplicate_guide(Document& document, size_t guide) {
  add_guide(document, document.guides()->at(guide), "duplicate guide");
}

void delete_guide(Document& document, size_t guide) {
  std::vector<GuidePath> guides = *document.guides();
  guides.erase(guides.begin() + static_cast<std::ptrdiff_t>(guide));
  document.guide_view().selected.reset();
  document.set_solo({});
  document.edit_guides(std::move(guides), "delete guide");
}

}  // namespace guidelight
