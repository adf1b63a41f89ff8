#pragma once

#include <array>
#include <deque>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "renderer/image/image.h"
#include "renderer/math/vector.h"

struct GLFWwindow;

namespace guidelight {

/// The window with its OpenGL context and ImGui: opens, waits for events, begins and ends frames.
class Window {
 public:
  /// ui_scale 0 takes the monitor's. Throws Error if no window can be opened.
  Window(const std::string& title, float ui_scale);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  bool should_close() const;
  void close();
  void set_title(const std::string& title);

  /// Sleeps until something happens or the time is over; a negative time does not sleep at all.
  void wait_events(double seconds);
  /// Ends the sleep of wait_events; from any thread.
  static void wake();

  void begin_frame();
  /// Whether events wait for the next frame: each frame takes keys up to one change of a mouse
  /// button, so that quick hands and slow frames do not change their order.
  bool events_pending() const { return !events_.empty(); }
  /// Draws what ImGui was told since begin_frame and shows it; fills `capture` with it, if given.
  void end_frame(DisplayImage* capture = nullptr);

  float scale() const { return scale_; }
  /// Rebuilds fonts and theme before the next frame. From then on the monitor's scale is ignored.
  void set_scale(float scale);

  /// Keys as they are pressed or repeated: GLFW key code and modifiers. Not called for keys that a
  /// text field takes.
  std::function<void(int key, int modifiers, bool is_repeat)> on_key;
  /// Files dropped on the window.
  std::function<void(std::vector<std::string>)> on_drop;

  bool key_down(int key) const;
  /// Where a mouse button (GLFW's and ImGui's number) was pressed or released last [pixels]. ImGui
  /// knows only where the mouse is when a frame begins, which may be elsewhere by then.
  Vec2 press_position(int button) const { return presses_[button]; }
  Vec2 release_position(int button) const { return releases_[button]; }
  /// GLFW_MOD_ bits held at the moment.
  int modifiers() const;

 private:
  struct Key {
    int key;
    int code;
    int modifiers;
  };
  void install_callbacks();
  void take_scale(float scale);
  struct ButtonChange {
    int button;
    int action;
    int modifiers;
    Vec2 position;
  };
  struct KeyChange {
    Key key;
    int action;
  };
  void take_key(const Key& key, int action);
  void take_button(const ButtonChange& change);
  void release_late_keys();
  void deliver_events();

  GLFWwindow* window_ = nullptr;
  float scale_ = 1;
  bool scale_changed_ = true;
  bool follows_monitor_;  // nobody has chosen a scale
  static constexpr int kButtons = 8;
  Vec2 mouse_{0};  // as of the last event
  std::deque<std::variant<KeyChange, ButtonChange>> events_;
  std::array<Vec2, kButtons> presses_{};
  std::array<Vec2, kButtons> releases_{};
  std::vector<Key> pressed_;        // since the last frame
  std::vector<Key> late_releases_;  // that ImGui learns after the next
};

}  // namespace guidelight
