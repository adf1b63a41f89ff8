#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// A person at an X11 desktop, for tests: a display of its own, hands on keyboard and mouse
/// (XTEST), eyes on the screen, and a program that is started and watched.
namespace guidelight {

/// Polls until the condition holds; false if it does not within the time.
bool wait_until(const std::function<bool()>& condition,
                std::chrono::milliseconds longest = std::chrono::seconds(20));

/// A running program; it is killed when this goes.
class ChildProcess {
 public:
  /// `environment` is added to that of this process; `folder` is where it runs; what it prints goes
  /// to the file `output`, or is shown if that is empty.
  ChildProcess(const std::vector<std::string>& command, const std::vector<std::string>& environment,
               const std::string& folder, const std::string& output = "");
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Exit status, or 128 + signal; empty if it still runs after this time.
  std::optional<int> wait(std::chrono::milliseconds longest);
  /// Processor time used so far [s].
  double cpu_seconds() const;
  /// Memory that is resident now [bytes].
  size_t resident_bytes() const;

 private:
  pid_t pid_;
  std::optional<int> status_;
};

/// Xvfb on a free display number.
class VirtualDisplay {
 public:
  /// Null if Xvfb cannot be started.
  static std::unique_ptr<VirtualDisplay> start(int width, int height);
  ~VirtualDisplay();
  const std::string& name() const { return name_; }  // ":99"

 private:
  VirtualDisplay(std::string name, pid_t pid) : name_(std::move(name)), pid_(pid) {}
  std::string name_;
  pid_t pid_;
};

struct Point {
  int x;
  int y;
};

/// The screen at one moment, 0xRRGGBB, top row first.
struct ScreenPicture {
  int width = 0;
  int height = 0;
  std::vector<uint32_t> pixels;

  uint32_t at(Point p) const { return pixels[static_cast<size_t>(p.y) * width + p.x]; }
};

/// Mean of the channels over a rectangle, 0..255.
double mean_brightness(const ScreenPicture& picture, Point corner, Point size);
/// Mean absolute difference of the means of 16×16 blocks over a rectangle, 0..255: noise hardly
/// counts.
double block_difference(const ScreenPicture& a, const ScreenPicture& b, Point corner, Point size);
size_t count_color(const ScreenPicture& picture, uint32_t color);

/// What a desktop tells programs about its monitor: 96 for scale 1.
void announce_dpi(const std::string& display, int dpi);

enum class Mouse { Left = 1, Middle = 2, Right = 3, WheelUp = 4, WheelDown = 5 };

class X11Driver {
 public:
  explicit X11Driver(const std::string& display);
  ~X11Driver();
  X11Driver(const X11Driver&) = delete;
  X11Driver& operator=(const X11Driver&) = delete;

  /// Waits for a mapped window of that program and remembers it; false if none comes.
  bool find_window();
  std::string title() const;
  void close_window();
  void resize_window(Point size);

  ScreenPicture capture() const;
  ScreenPicture capture_area(Point corner, Point size) const;
  /// Waits until the screen stands still for a moment.
  ScreenPicture capture_when_still() const;

  /// The wait before every event: 50 ms, longer than a frame of the viewer on a busy machine.
  void set_pace(std::chrono::milliseconds between_events);
  /// Names as in keysymdef.h: "e", "space", "F12", "bracketright".
  void press_key(const std::string& name, const std::vector<std::string>& modifiers = {});
  void hold_key(const std::string& name, bool down);
  void type(const std::string& text);

  void move_mouse(Point to);
  void hold_button(Mouse button, bool down);
  void click(Point at, Mouse button = Mouse::Left);
  void drag(Point from, Point to, Mouse button, const std::vector<std::string>& modifiers = {});

  /// Drops a file on the window as a file manager does (XDnD version 5); false if it was refused.
  bool drop_file(const std::string& path, Point at);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace guidelight
