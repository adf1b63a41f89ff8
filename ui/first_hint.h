#pragma once

#include <string>

#include "renderer/math/vector.h"

namespace guidelight {

/// Three lines for those who have never placed a guide path, until they take up the tool for it or
/// click them away.
class FirstHint {
 public:
  /// Remembers in a file of the folder that the hint has been understood.
  explicit FirstHint(const std::string& state_folder);

  void dismiss();
  /// In the upper left corner of a view, in its ImGui window; left out where there is not enough
  /// room.
  void draw(Vec2 corner, float room);

 private:
  bool draw_cross(Vec2 upper_right) const;

  std::string mark_;
  bool shown_;
};

}  // namespace guidelight
