#include "ui/guides/new_guide.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/transport/guide_color.h"

namespace guidelight {
namespace {

bool is_taken(const std::vector<GuidePath>& guides, const std::string& name) {
  return std::ranges::find(guides, name, &GuidePath::name) != guides.end();
}

}  // namespace

void add_guide(Document& document, GuidePath guide, const std::string& label) {
  std::vector<GuidePath> guides = *document.guides();
  size_t number = guides.size() + 1;
  while (is_taken(guides, fmt::format("Guide {}", number))) ++number;
  guide.name = fmt::format("Guide {}", number);
  guide.color = guide_color(number - 1);
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
