#include "ui/proposal_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "ui/format.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

struct ColumnText {
  const char* heading;
  const char* help;
};
constexpr std::array<ColumnText, 3> kNumberColumns = {{
    {"Tried", "Share of all proposals of the chains"},
    {"Taken", "Mean probability that such a proposal is accepted"},
    {"Light", "Share of the chains' light that such proposals have found"},
}};

double number_in(const ProposalRow& row, ProposalColumn column) {
  switch (column) {
    case ProposalColumn::Proposed:
      return row.statistics.share;
    case ProposalColumn::Accepted:
      return row.statistics.acceptance;
    default:
      return row.statistics.contribution;
  }
}

void right_aligned(const std::string& text) {
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, room));
  ImGui::TextUnformatted(text.c_str());
}

void draw_headings(const char* heading) {
  ImGui::TableSetupColumn(heading, ImGuiTableColumnFlags_WidthStretch);
  const float widest_number = ImGui::CalcTextSize("0.00 %").x;
  // As much as ImGui keeps free for the arrow of the order.
  const float arrow =
      std::ceil(0.65f * ImGui::GetFontSize() + ImGui::GetStyle().FramePadding.x) + 1;
  for (const ColumnText& column : kNumberColumns) {
    const float width = std::max(widest_number, ImGui::CalcTextSize(column.heading).x + arrow);
    const bool is_default = column.heading == kNumberColumns.back().heading;
    ImGui::TableSetupColumn(column.heading,
                            ImGuiTableColumnFlags_WidthFixed |
                                ImGuiTableColumnFlags_PreferSortDescending |
                                (is_default ? ImGuiTableColumnFlags_DefaultSort : 0),
                            width);
  }
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (int column = 0; column < 4; ++column) {
    ImGui::TableSetColumnIndex(column);
    ImGui::TableHeader(ImGui::TableGetColumnName(column));
    if (column > 0) tooltip(kNumberColumns[column - 1].help);
  }
}

bool draw_row(const ProposalRow& row) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (row.color != 0) {
    const float line = ImGui::GetTextLineHeight();
    const Vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    ImGui::GetWindowDrawList()->AddCircleFilled(to_imgui(corner + Vec2(scaled(5), line / 2)),
                                                scaled(4), row.color);
    ImGui::Dummy({scaled(10), line});
    ImGui::SameLine(0, scaled(4));
  }
  const std::string name = shortened(row.name, ImGui::GetContentRegionAvail().x);
  const bool clicked = ImGui::Selectable((name + "##row").c_str(), row.selected,
                                         ImGuiSelectableFlags_SpanAllColumns);
  if (name != row.name) tooltip(row.name);
  const ProposalStatistics& statistics = row.statistics;
  for (const double share : {statistics.share, statistics.acceptance, statistics.contribution}) {
    ImGui::TableNextColumn();
    right_aligned(format_percent(share));
  }
  return clicked;
}

}  // namespace

std::vector<size_t> sorted_rows(const std::vector<ProposalRow>& rows, ProposalColumn by,
                                bool ascending) {
  std::vector<size_t> order(rows.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](size_t a, size_t b) {
    if (!ascending) std::swap(a, b);
    if (by == ProposalColumn::Name) return rows[a].name < rows[b].name;
    return number_in(rows[a], by) < number_in(rows[b], by);
  });
  return order;
}

std::optional<size_t> draw_proposal_table(const char* id, const char* heading,
                                          const std::vector<ProposalRow>& rows) {
  constexpr auto kFlags = ImGuiTableFlags_Sortable | ImGuiTableFlags_NoSavedSettings;
  std::optional<size_t> clicked;
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {scaled(3), scaled(2)});
  const bool open = ImGui::BeginTable(id, 4, kFlags);
  ImGui::PopStyleVar();
  if (!open) return clicked;
  draw_headings(heading);
  ProposalColumn by = ProposalColumn::Light;
  bool ascending = false;
  if (const auto* sorting = ImGui::TableGetSortSpecs(); sorting && sorting->SpecsCount > 0) {
    by = static_cast<ProposalColumn>(sorting->Specs[0].ColumnIndex);
    ascending = sorting->Specs[0].SortDirection == ImGuiSortDirection_Ascending;
  }
  for (const size_t i : sorted_rows(rows, by, ascending)) {
    ImGui::PushID(static_cast<int>(i));
    if (draw_row(rows[i])) clicked = i;
    ImGui::PopID();
  }
  ImGui::EndTable();
  return clicked;
}

}  // namespace guidelight
