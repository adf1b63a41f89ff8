#pragma once

#include "renderer/io/guide_file.h"
#include "renderer/scene/scene.h"
#include "tests/end_to_end/viewer_fixture.h"

namespace guidelight {

/// The viewer with a room: a round lamp, a floor, a wall behind and a mirror to the right. It is
/// known where on the screen each of its points is seen.
class RoomTest : public ViewerTest {
 protected:
  static constexpr Vec3 kLamp{0, 1.7f, 0};
  static constexpr Vec3 kFloor{-0.7f, 0, 0.4f};
  static constexpr Vec3 kWall{-0.9f, 1.2f, -2};
  static constexpr Vec3 kMirror{1.5f, 0.9f, 1};

  /// Opens it and pauses the render, which leaves the machine to the window.
  void open_room(const std::vector<std::string>& arguments = {});

  Point in_picture(Vec3 point) const;
  /// The scout view stands where the render camera is and has a lens of its own.
  Point in_scout(Vec3 point) const;
  /// On the lamp's near side, as the camera sees it.
  static Vec3 lamp_front() { return kLamp + 0.25f * glm::normalize(Vec3(0, 1, 4) - kLamp); }

  /// As they are in the file beside the scene.
  std::vector<GuidePath> saved_guides() const;
  bool wait_for_guides(size_t count) const;
  void expect_usable(const GuidePath& guide) const;
  /// Takes up the guide tool and clicks.
  void place(std::initializer_list<Point> clicks);

  std::string path_;
  std::shared_ptr<const Scene> scene_;
};

}  // namespace guidelight
