#include "tests/end_to_end/x11_driver.h"

#include <X11/XKBlib.h>
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>

#include <cmath>
#include <stdexcept>
#include <thread>

namespace guidelight {
namespace {

using namespace std::chrono_literals;

/// Means of the channels of 16×16 blocks.
std::vector<double> block_means(const ScreenPicture& picture, Point corner, Point size) {
  constexpr int kBlock = 16;
  std::vector<double> means;
  for (int y = corner.y; y + kBlock <= corner.y + size.y; y += kBlock) {
    for (int x = corner.x; x + kBlock <= corner.x + size.x; x += kBlock) {
      means.push_back(mean_brightness(picture, {x, y}, {kBlock, kBlock}));
    }
  }
  return means;
}

}  // namespace

// -- Looking.

double mean_brightness(const ScreenPicture& picture, Point corner, Point size) {
  double sum = 0;
  for (int y = corner.y; y < corner.y + size.y; ++y) {
    for (int x = corner.x; x < corner.x + size.x; ++x) {
      const uint32_t pixel = picture.at({x, y});
      sum += ((pixel >> 16) & 255) + ((pixel >> 8) & 255) + (pixel & 255);
    }
  }
  return sum / 3 / (static_cast<double>(size.x) * size.y);
}

double block_difference(const ScreenPicture& a, const ScreenPicture& b, Point corner, Point size) {
  const std::vector<double> means_a = block_means(a, corner, size);
  const std::vector<double> means_b = block_means(b, corner, size);
  double sum = 0;
  for (size_t i = 0; i < means_a.size(); ++i) sum += std::abs(means_a[i] - means_b[i]);
  return sum / static_cast<double>(means_a.size());
}

size_t count_color(const ScreenPicture& picture, uint32_t color) {
  size_t count = 0;
  for (const uint32_t pixel : picture.pixels) count += pixel == color;
  return count;
}

// -- The connection.

struct X11Driver::Impl {
  Display* display;
  Window window = 0;
  std::chrono::milliseconds between_events{50};

  Atom atom(const char* name) const { return XInternAtom(display, name, False); }
  Window root() const { return DefaultRootWindow(display); }

  KeyCode code_of(const std::string& name) const {
    const KeySym symbol = XStringToKeysym(name.c_str());
    const KeyCode code = XKeysymToKeycode(display, symbol);
    if (code == 0) throw std::runtime_error("the keyboard has no key '" + name + "'");
    return code;
  }

  void pause() const { std::this_thread::sleep_for(between_events); }

  void send_key(KeyCode code, bool down) const {
    pause();
    XTestFakeKeyEvent(display, code, down ? True : False, CurrentTime);
    XFlush(display);
  }

  void send_message(Atom type, long a, long b = 0, long c = 0, long d = 0, long e = 0) const {
    XClientMessageEvent message{};
    message.type = ClientMessage;
    message.display = display;
    message.window = window;
    message.message_type = type;
    message.format = 32;
    const long data[] = {a, b, c, d, e};
    std::copy(std::begin(data), std::end(data), message.data.l);
    XSendEvent(display, window, False, NoEventMask, reinterpret_cast<XEvent*>(&message));
    XFlush(display);
  }
};

void announce_dpi(const std::string& display, int dpi) {
  Display* const connection = XOpenDisplay(display.c_str());
  if (!connection) throw std::runtime_error("cannot open display " + display);
  const std::string resources = "Xft.dpi:\t" + std::to_string(dpi) + "\n";
  XChangeProperty(connection, DefaultRootWindow(connection), XA_RESOURCE_MANAGER, XA_STRING, 8,
                  PropModeReplace, reinterpret_cast<const unsigned char*>(resources.data()),
                  static_cast<int>(resources.size()));
  XCloseDisplay(connection);
}

X11Driver::X11Driver(const std::string& display) : impl_(std::make_unique<Impl>()) {
  impl_->display = XOpenDisplay(display.c_str());
  if (!impl_->display) throw std::runtime_error("cannot connect to the display " + display);
}

X11Driver::~X11Driver() { XCloseDisplay(impl_->display); }

// -- The window.

/// The first mapped child of the root that is large: without a window manager nothing else is
/// there.
bool X11Driver::find_window() {
  return wait_until([&] {
    Window root = 0, parent = 0;
    Window* children = nullptr;
    unsigned count = 0;
    XQueryTree(impl_->display, impl_->root(), &root, &parent, &children, &count);
    for (unsigned i = 0; i < count; ++i) {
      XWindowAttributes attributes{};
      XGetWindowAttributes(impl_->display, children[i], &attributes);
      if (attributes.map_state == IsViewable && attributes.width > 200) {
        impl_->window = children[i];
      }
    }
    if (children) XFree(children);
    if (impl_->window) {
      XSetInputFocus(impl_->display, impl_->window, RevertToPointerRoot, CurrentTime);
    }
    return impl_->window != 0;
  });
}

std::string X11Driver::title() const {
  Atom type = 0;
  int format = 0;
  unsigned long count = 0, left = 0;
  unsigned char* text = nullptr;
  XGetWindowProperty(impl_->display, impl_->window, impl_->atom("_NET_WM_NAME"), 0, 1024, False,
                     impl_->atom("UTF8_STRING"), &type, &format, &count, &left, &text);
  const std::string title = text ? std::string(reinterpret_cast<char*>(text), count) : "";
  if (text) XFree(text);
  return title;
}

void X11Driver::close_window() {
  impl_->send_message(impl_->atom("WM_PROTOCOLS"),
                      static_cast<long>(impl_->atom("WM_DELETE_WINDOW")), CurrentTime);
}

void X11Driver::resize_window(Point size) {
  XResizeWindow(impl_->display, impl_->window, size.x, size.y);
  XFlush(impl_->display);
}

ScreenPicture X11Driver::capture() const {
  XWindowAttributes attributes{};
  XGetWindowAttributes(impl_->display, impl_->root(), &attributes);
  return capture_area({0, 0}, {attributes.width, attributes.height});
}

ScreenPicture X11Driver::capture_area(Point corner, Point size) const {
  XImage* image = XGetImage(impl_->display, impl_->root(), corner.x, corner.y, size.x, size.y,
                            AllPlanes, ZPixmap);
  ScreenPicture picture{size.x, size.y, {}};
  picture.pixels.reserve(static_cast<size_t>(picture.width) * picture.height);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      picture.pixels.push_back(static_cast<uint32_t>(XGetPixel(image, x, y)) & 0xffffff);
    }
  }
  XDestroyImage(image);
  return picture;
}

ScreenPicture X11Driver::capture_when_still() const {
  ScreenPicture before = capture();
  wait_until([&] {
    std::this_thread::sleep_for(400ms);
    ScreenPicture now = capture();
    const bool still = now.pixels == before.pixels;
    before = std::move(now);
    return still;
  });
  return before;
}

// -- The hands.

void X11Driver::set_pace(std::chrono::milliseconds between_events) {
  impl_->between_events = between_events;
}

void X11Driver::hold_key(const std::string& name, bool down) {
  impl_->send_key(impl_->code_of(name), down);
}

void X11Driver::press_key(const std::string& name, const std::vector<std::string>& modifiers) {
  for (const std::string& modifier : modifiers) hold_key(modifier, true);
  hold_key(name, true);
  hold_key(name, false);
  for (const std::string& modifier : modifiers) hold_key(modifier, false);
}

void X11Driver::type(const std::string& text) {
  for (const char character : text) {
    // Latin 1 keysyms are the characters themselves.
    const KeySym symbol =
        character == '\n' ? XStringToKeysym("Return") : static_cast<KeySym>(character);
    const KeyCode code = XKeysymToKeycode(impl_->display, symbol);
    const bool shifted = XkbKeycodeToKeysym(impl_->display, code, 0, 0) != symbol;
    if (shifted) hold_key("Shift_L", true);
    impl_->send_key(code, true);
    impl_->send_key(code, false);
    if (shifted) hold_key("Shift_L", false);
  }
}

void X11Driver::move_mouse(Point to) {
  impl_->pause();
  XTestFakeMotionEvent(impl_->display, -1, to.x, to.y, CurrentTime);
  XFlush(impl_->display);
}

void X11Driver::hold_button(Mouse button, bool down) {
  impl_->pause();
  XTestFakeButtonEvent(impl_->display, static_cast<unsigned>(button), down ? True : False,
                       CurrentTime);
  XFlush(impl_->display);
}

void X11Driver::click(Point at, Mouse button) {
  move_mouse(at);
  impl_->pause();  // the viewer must have seen where the mouse is
  hold_button(button, true);
  impl_->pause();
  hold_button(button, false);
}

void X11Driver::drag(Point from, Point to, Mouse button,
                     const std::vector<std::string>& modifiers) {
  constexpr int kSteps = 12;
  move_mouse(from);
  for (const std::string& modifier : modifiers) hold_key(modifier, true);
  hold_button(button, true);
  for (int step = 1; step <= kSteps; ++step) {
    move_mouse(
        {from.x + (to.x - from.x) * step / kSteps, from.y + (to.y - from.y) * step / kSteps});
  }
  hold_button(button, false);
  for (const std::string& modifier : modifiers) hold_key(modifier, false);
}

// -- Drag and drop, the source's side of the XDnD protocol, version 5.

bool X11Driver::drop_file(const std::string& path, Point at) {
  Display* display = impl_->display;
  const Window source = XCreateSimpleWindow(display, impl_->root(), 0, 0, 1, 1, 0, 0, 0);
  const Atom selection = impl_->atom("XdndSelection");
  const Atom uri_list = impl_->atom("text/uri-list");
  XSetSelectionOwner(display, selection, source, CurrentTime);

  const auto source_id = static_cast<long>(source);
  impl_->send_message(impl_->atom("XdndEnter"), source_id, 5L << 24, static_cast<long>(uri_list));
  impl_->send_message(impl_->atom("XdndPosition"), source_id, 0,
                      (static_cast<long>(at.x) << 16) | at.y, CurrentTime,
                      static_cast<long>(impl_->atom("XdndActionCopy")));
  bool dropped = false;
  bool finished = false;
  wait_until([&] {
    while (XPending(display) > 0) {
      XEvent event;
      XNextEvent(display, &event);
      if (event.type == ClientMessage && event.xclient.message_type == impl_->atom("XdndStatus")) {
        if (!dropped) impl_->send_message(impl_->atom("XdndDrop"), source_id, 0, CurrentTime);
        dropped = true;
      } else if (event.type == ClientMessage &&
                 event.xclient.message_type == impl_->atom("XdndFinished")) {
        finished = true;
      } else if (event.type == SelectionRequest) {
        const XSelectionRequestEvent& request = event.xselectionrequest;
        const std::string uri = "file://" + path + "\r\n";
        XChangeProperty(display, request.requestor, request.property, uri_list, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(uri.data()),
                        static_cast<int>(uri.size()));
        XSelectionEvent answer{};
        answer.type = SelectionNotify;
        answer.requestor = request.requestor;
        answer.selection = request.selection;
        answer.target = request.target;
        answer.property = request.property;
        answer.time = request.time;
        XSendEvent(display, request.requestor, False, NoEventMask,
                   reinterpret_cast<XEvent*>(&answer));
        XFlush(display);
      }
    }
    return finished;
  });
  XDestroyWindow(display, source);
  XFlush(display);
  return finished;
}

}  // namespace guidelight
