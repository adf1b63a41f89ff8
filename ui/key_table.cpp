#include "ui/key_table.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace guidelight {
namespace {

constexpr int kShift = GLFW_MOD_SHIFT;
constexpr int kControl = GLFW_MOD_CONTROL;
constexpr int kAlt = GLFW_MOD_ALT;

constexpr auto kKeyBindings = std::to_array<KeyBinding>({
    {Action::OpenScene, GLFW_KEY_O, kControl, "File", "Open scene…"},
    {Action::ReloadScene, GLFW_KEY_R, kControl, "File", "Reload scene"},
    {Action::SaveCheckpoint, GLFW_KEY_S, kControl, "File", "Save checkpoint…"},
    {Action::ResumeCheckpoint, GLFW_KEY_O, kControl | kShift, "File", "Resume checkpoint…"},
    {Action::Screenshot, GLFW_KEY_F12, 0, "File", "Save picture as PNG"},
    {Action::WindowCapture, GLFW_KEY_F12, kShift, "File", "Save window as PNG"},
    {Action::SaveFigure, GLFW_KEY_F12, kControl, "File", "Save figure with guides"},
    {Action::ExportHalf, GLFW_KEY_E, kControl, "File", "Export EXR, half"},
    {Action::ExportFloat, GLFW_KEY_E, kControl | kShift, "File", "Export EXR, float"},
    {Action::Quit, GLFW_KEY_Q, kControl, "File", "Quit"},

    {Action::Undo, GLFW_KEY_Z, kControl, "Edit", "Undo"},
    {Action::Redo, GLFW_KEY_Z, kControl | kShift, "Edit", "Redo"},

    {Action::NewGuide, GLFW_KEY_G, 0, "Guides", "Place a guide path"},
    {Action::ShowGuides, GLFW_KEY_G, kShift, "Guides", "Show or hide the guides"},
    {Action::HarvestTool, GLFW_KEY_H, 0, "Guides", "Find the light of a rectangle"},
    {Action::KeepPath, GLFW_KEY_K, 0, "Guides", "Keep the light path as a guide"},
    {Action::DuplicateGuide, GLFW_KEY_D, kControl, "Guides", "Duplicate the guide"},
    {Action::DeleteGuide, GLFW_KEY_DELETE, 0, "Guides", "Delete the guide"},

    {Action::PauseResume, GLFW_KEY_SPACE, 0, "Render", "Pause or resume"},
    {Action::Restart, GLFW_KEY_BACKSPACE, 0, "Render", "Restart"},
    {Action::RegionTool, GLFW_KEY_R, 0, "Render", "Draw a render region"},
    {Action::ClearRegion, GLFW_KEY_R, kShift, "Render", "Render the whole picture"},

    {Action::CycleViews, GLFW_KEY_TAB, 0, "View", "Render, scout or both views"},
    {Action::ShowPhotons, GLFW_KEY_P, 0, "View", "Show or hide the photons"},
    {Action::ViewFromRender, GLFW_KEY_V, 0, "View", "Scout from the render camera"},
    {Action::ShowTechniques, GLFW_KEY_T, 0, "View", "Show the techniques"},
    {Action::RecordTechniques, GLFW_KEY_T, kShift, "View", "Record the techniques apart"},

    {Action::FrameSelection, GLFW_KEY_F, 0, "Camera", "Frame selection or scene"},
    {Action::ResetCamera, GLFW_KEY_HOME, 0, "Camera", "Reset the camera"},

    {Action::ExposureUp, GLFW_KEY_E, 0, "Image", "Brighter by ¼ EV"},
    {Action::ExposureDown, GLFW_KEY_E, kShift, "Image", "Darker by ¼ EV"},
    {Action::NormaliseExposure, GLFW_KEY_N, 0, "Image", "Normalise exposure"},
    {Action::PreviousLayer, GLFW_KEY_LEFT_BRACKET, 0, "Image", "Previous layer"},
    {Action::NextLayer, GLFW_KEY_RIGHT_BRACKET, 0, "Image", "Next layer"},
    {Action::ClipWarning, GLFW_KEY_C, 0, "Image", "Mark clipped pixels"},
    {Action::Inspector, GLFW_KEY_I, 0, "Image", "Inspect pixels"},
    {Action::LoadReference, GLFW_KEY_L, kControl, "Image", "Load a reference…"},
    {Action::PinPicture, GLFW_KEY_B, 0, "Image", "Pin the picture to compare"},
    {Action::ZoomFit, GLFW_KEY_0, 0, "Image", "Fit to the window"},
    {Action::ZoomActual, GLFW_KEY_1, 0, "Image", "Actual pixels"},

    {Action::KeySheet, GLFW_KEY_F1, 0, "Window", "Keys"},
    {Action::HideUi, GLFW_KEY_F2, 0, "Window", "Hide the panels"},
    {Action::LargerUi, GLFW_KEY_EQUAL, kControl, "Window", "Larger interface"},
    {Action::SmallerUi, GLFW_KEY_MINUS, kControl, "Window", "Smaller interface"},
});

// Many window managers keep Alt+drag for themselves, hence the second bindings of orbit and pan.
constexpr auto kMouseBindings = std::to_array<MouseBinding>({
    {Gesture::Orbit, MouseInput::Left, kAlt, "Camera", "Orbit"},
    {Gesture::Orbit, MouseInput::Middle, 0, "Camera", "Orbit"},
    {Gesture::Pan, MouseInput::Middle, kAlt, "Camera", "Pan"},
    {Gesture::Pan, MouseInput::Middle, kShift, "Camera", "Pan"},
    {Gesture::Dolly, MouseInput::Wheel, 0, "Camera", "Dolly"},
    {Gesture::Fly, MouseInput::Right, 0, "Camera", "Look around and fly"},
    {Gesture::UseTool, MouseInput::Left, 0, "Image", "Pick a pixel, use the tool"},
    {Gesture::ZoomImage, MouseInput::Wheel, kControl, "Image", "Zoom the picture"},
    {Gesture::PanImage, MouseInput::Middle, kControl, "Image", "Move the picture"},
});

const std::array<FlyKey, 6> kFlyKeys = {{
    {GLFW_KEY_W, {0, 0, 1}, "forward"},
    {GLFW_KEY_S, {0, 0, -1}, "back"},
    {GLFW_KEY_A, {-1, 0, 0}, "left"},
    {GLFW_KEY_D, {1, 0, 0}, "right"},
    {GLFW_KEY_E, {0, 1, 0}, "up"},
    {GLFW_KEY_Q, {0, -1, 0}, "down"},
}};

constexpr auto kToolKeys = std::to_array<ToolKey>({
    {ToolCommand::Finish, GLFW_KEY_ENTER, "end it (or double-click)"},
    {ToolCommand::Finish, GLFW_KEY_KP_ENTER, nullptr},
    {ToolCommand::RemoveLast, GLFW_KEY_BACKSPACE, "take back the last vertex"},
    {ToolCommand::Cancel, GLFW_KEY_ESCAPE, "cancel"},
});

std::string modifier_text(int modifiers) {
  std::string text;
  if (modifiers & kControl) text += "Ctrl+";
  if (modifiers & kAlt) text += "Alt+";
  if (modifiers & kShift) text += "Shift+";
  return text;
}

std::string key_name(int key) {
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25) return fmt::format("F{}", key - GLFW_KEY_F1 + 1);
  switch (key) {
    case GLFW_KEY_SPACE:
      return "Space";
    case GLFW_KEY_BACKSPACE:
      return "Backspace";
    case GLFW_KEY_HOME:
      return "Home";
    case GLFW_KEY_TAB:
      return "Tab";
    case GLFW_KEY_ENTER:
      return "Enter";
    case GLFW_KEY_ESCAPE:
      return "Esc";
    case GLFW_KEY_DELETE:
      return "Del";
    case GLFW_KEY_EQUAL:
      return "+";
    case GLFW_KEY_MINUS:
      return "-";
    default:
      return std::string(1, static_cast<char>(key));  // GLFW's codes of printable keys are ASCII
  }
}

const KeyBinding& binding_of(Action action) {
  return *std::ranges::find(kKeyBindings, action, &KeyBinding::action);
}

}  // namespace

std::span<const KeyBinding> key_bindings() { return kKeyBindings; }
std::span<const MouseBinding> mouse_bindings() { return kMouseBindings; }
std::span<const FlyKey> fly_keys() { return kFlyKeys; }
std::span<const ToolKey> tool_keys() { return kToolKeys; }

std::optional<ToolCommand> tool_command_for(int key, int modifiers) {
  if (modifiers & (kShift | kControl | kAlt)) return std::nullopt;
  const auto found = std::ranges::find(kToolKeys, key, &ToolKey::key);
  return found == kToolKeys.end() ? std::nullopt : std::optional(found->command);
}

float fly_speed_factor(int modifiers) {
  if (modifiers & kShift) return 4.0f;
  if (modifiers & kControl) return 0.25f;
  return 1.0f;
}

std::optional<Action> action_for(int key, int modifiers) {
  constexpr int kKnown = kShift | kControl | kAlt;
  if (key == GLFW_KEY_KP_ADD) key = GLFW_KEY_EQUAL;
  if (key == GLFW_KEY_KP_SUBTRACT) key = GLFW_KEY_MINUS;
  for (const KeyBinding& binding : kKeyBindings) {
    if (binding.key == key && binding.modifiers == (modifiers & kKnown)) return binding.action;
  }
  return std::nullopt;
}

bool repeats(Action action) {
  switch (action) {
    case Action::Undo:
    case Action::Redo:
    case Action::ExposureUp:
    case Action::ExposureDown:
    case Action::PreviousLayer:
    case Action::NextLayer:
    case Action::LargerUi:
    case Action::SmallerUi:
      return true;
    default:
      return false;
  }
}

std::optional<Gesture> gesture_for(MouseInput input, int modifiers) {
  constexpr int kKnown = kShift | kControl | kAlt;
  if (input == MouseInput::Right) return Gesture::Fly;
  for (const MouseBinding& binding : kMouseBindings) {
    if (binding.input == input && binding.modifiers == (modifiers & kKnown)) return binding.gesture;
  }
  return std::nullopt;
}

std::string shortcut_text(Action action) {
  const KeyBinding& binding = binding_of(action);
  return key_text(binding.key, binding.modifiers);
}

const char* action_label(Action action) { return binding_of(action).label; }

std::string key_text(int key, int modifiers) { return modifier_text(modifiers) + key_name(key); }

std::string mouse_text(const MouseBinding& binding) {
  static constexpr const char* kInputs[] = {"left drag", "right drag", "middle drag", "wheel"};
  std::string text = modifier_text(binding.modifiers) + kInputs[static_cast<int>(binding.input)];
  if (binding.gesture == Gesture::UseTool) text = "left button";
  return text;
}

}  // namespace guidelight
