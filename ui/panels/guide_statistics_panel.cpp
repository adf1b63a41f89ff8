#include "ui/panels/panels.h"
#include "ui/proposal_table.h"
#include "ui/widgets.h"

namespace guidelight {

void draw_guide_statistics(Document& document) {
  if (!section("How they fare")) return;
  const auto& chains = document.status().chains;
  if (!chains) {
    wrapped_dim_text(
        "Markov chains (MLT, MPS) measure how often the light paths that a guide proposes are "
        "accepted, and how much light they find. Other algorithms weigh guided paths against all "
        "others instead of accepting or refusing them.");
    return;
  }
  std::vector<ProposalRow> rows;
  for (size_t i = 0; i < document.guides()->size(); ++i) {
    const GuidePath& guide = (*document.guides())[i];
    rows.push_back({guide.name,
                    i < chains->guides.size() ? chains->guides[i] : ProposalStatistics{},
                    to_imgui_color(guide.color), document.guide_view().selected == i});
  }
  const auto clicked = draw_proposal_table("guide statistics", "Guide", rows);
  if (clicked) document.guide_view().selected = clicked;
}

}  // namespace guidelight
