#include "ui/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <epoxy/gl.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>

#include "renderer/error.h"
#include "ui/gl/offscreen.h"
#include "ui/theme.h"

namespace guidelight {
namespace {

constexpr int kPreferredWidth = 1440;
constexpr int kPreferredHeight = 900;
constexpr float kSmallestScale = 0.5f;
constexpr float kLargestScale = 4;

std::string glfw_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason given";
}

/// As large as the interface's scale asks for, but never larger than the monitor.
std::pair<int, int> window_size(float scale) {
  int width = static_cast<int>(kPreferredWidth * scale);
  int height = static_cast<int>(kPreferredHeight * scale);
  if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
    int x = 0, y = 0, room_width = width, room_height = height;
    glfwGetMonitorWorkarea(monitor, &x, &y, &room_width, &room_height);
    if (room_width > 0) width = std::min(width, room_width);
    if (room_height > 0) height = std::min(height, room_height);
  }
  return {width, height};
}

float monitor_scale() {
  float x = 1, y = 1;
  if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) glfwGetMonitorContentScale(monitor, &x, &y);
  return std::max(x, y);
}

Window& window_of(GLFWwindow* handle) {
  return *static_cast<Window*>(glfwGetWindowUserPointer(handle));
}

}  // namespace

Window::Window(const std::string& title, float ui_scale) : follows_monitor_(ui_scale <= 0) {
  if (!glfwInit()) {
    throw Error(
        "cannot open a window ({}): start it in a graphical session, or use `guidelight render`",
        glfw_error());
  }
  scale_ = std::clamp(ui_scale > 0 ? ui_scale : monitor_scale(), kSmallestScale, kLargestScale);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  const auto [width, height] = window_size(scale_);
  window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (!window_) {
    const std::string reason = glfw_error();
    glfwTerminate();
    throw Error(
        "cannot open a window with OpenGL 3.3 ({}): install a graphics driver, or Mesa's software "
        "rasteriser (libgl1-mesa-dri)",
        reason);
  }
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  glfwSetWindowUserPointer(window_, this);
  ImGui_ImplGlfw_InitForOpenGL(window_, true);
  install_callbacks();
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

Window::~Window() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void Window::install_callbacks() {
  glfwSetKeyCallback(window_, [](GLFWwindow* handle, int key, int code, int action, int modifiers) {
    window_of(handle).events_.push_back(KeyChange{{key, code, modifiers}, action});
  });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* handle, double x, double y) {
    window_of(handle).mouse_ = {x, y};
  });
  glfwSetMouseButtonCallback(
      window_, [](GLFWwindow* handle, int button, int action, int modifiers) {
        Window& window = window_of(handle);
        window.events_.push_back(ButtonChange{button, action, modifiers, window.mouse_});
      });
  glfwSetDropCallback(window_, [](GLFWwindow* handle, int count, const char** paths) {
    Window& window = window_of(handle);
    if (window.on_drop) window.on_drop(std::vector<std::string>(paths, paths + count));
  });
  glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* handle, float x, float y) {
    Window& window = window_of(handle);
    if (window.follows_monitor_) window.take_scale(std::max(x, y));
  });
}

/// ImGui looks at keys once per frame, so one that is pressed and released between two frames would
/// be lost: it is released for ImGui after that frame. Not during it: ImGui demands that modifiers
/// stay as they are until it ends.
void Window::take_key(const Key& key, int action) {
  const bool press_unseen = std::ranges::find(pressed_, key.key, &Key::key) != pressed_.end();
  if (action == GLFW_RELEASE && press_unseen) {
    late_releases_.push_back(key);
    return;
  }
  ImGui_ImplGlfw_KeyCallback(window_, key.key, key.code, action, key.modifiers);
  if (action == GLFW_RELEASE) return;
  pressed_.push_back(key);
  if (!ImGui::GetIO().WantTextInput && on_key)
    on_key(key.key, key.modifiers, action == GLFW_REPEAT);
}

void Window::release_late_keys() {
  pressed_.clear();
  for (const Key& key : late_releases_) {
    ImGui_ImplGlfw_KeyCallback(window_, key.key, key.code, GLFW_RELEASE, key.modifiers);
  }
  late_releases_.clear();
}

void Window::take_button(const ButtonChange& change) {
  const auto [button, action, modifiers, position] = change;
  if (button < kButtons) (action == GLFW_PRESS ? presses_ : releases_)[button] = position;
  ImGui_ImplGlfw_MouseButtonCallback(window_, button, action, modifiers);
}

void Window::deliver_events() {
  while (!events_.empty()) {
    const auto event = events_.front();
    events_.pop_front();
    if (const auto* change = std::get_if<ButtonChange>(&event)) {
      take_button(*change);
      return;
    }
    const auto& [key, action] = std::get<KeyChange>(event);
    take_key(key, action);
  }
}

bool Window::should_close() const { return glfwWindowShouldClose(window_); }
void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }
void Window::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

void Window::wait_events(double seconds) {
  if (seconds > 0) {
    glfwWaitEventsTimeout(seconds);
  } else {
    glfwPollEvents();
  }
}

void Window::wake() { glfwPostEmptyEvent(); }

void Window::begin_frame() {
  deliver_events();
  if (scale_changed_) {
    scale_changed_ = false;
    apply_theme(scale_);
    load_fonts(scale_);
    ImGui_ImplOpenGL3_DestroyDeviceObjects();  // among them the glyphs; NewFrame makes them anew
  }
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Window::end_frame(DisplayImage* capture) {
  ImGui::Render();
  release_late_keys();
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  glViewport(0, 0, width, height);
  const ImVec4 backdrop = ImGui::ColorConvertU32ToFloat4(palette::kBackdrop);
  glClearColor(backdrop.x, backdrop.y, backdrop.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  if (capture) {
    glReadBuffer(GL_BACK);
    *capture = read_framebuffer(width, height);
  }
  glfwSwapBuffers(window_);
}

void Window::set_scale(float scale) {
  follows_monitor_ = false;
  take_scale(scale);
}

void Window::take_scale(float scale) {
  scale_ = std::clamp(scale, kSmallestScale, kLargestScale);
  scale_changed_ = true;
  wake();
}

bool Window::key_down(int key) const { return glfwGetKey(window_, key) == GLFW_PRESS; }

int Window::modifiers() const {
  const ImGuiIO& io = ImGui::GetIO();
  return (io.KeyCtrl ? GLFW_MOD_CONTROL : 0) | (io.KeyShift ? GLFW_MOD_SHIFT : 0) |
         (io.KeyAlt ? GLFW_MOD_ALT : 0);
}

}  // namespace guidelight
