#pragma once

#include <optional>

namespace guidelight {

/// The tabs of the right column. Follow begin() by ImGui::EndTabBar() and tab() by
/// ImGui::EndTabItem(), where they return true.
class Tabs {
 public:
  enum Name { Image, Guides, Photons, Compare };

  bool begin();
  /// Whether this one is shown.
  bool tab(Name name);
  void show(Name name) { requested_ = name; }
  Name shown() const { return shown_; }

 private:
  std::optional<Name> requested_;
  Name shown_ = Image;
};

}  // namespace guidelight
