#pragma once

#include <optional>
#include <span>
#include <string>

#include "renderer/math/vector.h"

/// The one place where keys and mouse buttons are bound. Menus, tooltips and the key sheet are
/// generated from it.
namespace guidelight {

enum class Action {
  OpenScene,
  ReloadScene,
  SaveCheckpoint,
  ResumeCheckpoint,
  Screenshot,
  WindowCapture,
  SaveFigure,
  ExportHalf,
  ExportFloat,
  Quit,
  Undo,
  Redo,
  NewGuide,
  ShowGuides,
  HarvestTool,
  KeepPath,
  DuplicateGuide,
  DeleteGuide,
  ShowPhotons,
  CycleViews,
  ViewFromRender,
  ShowTechniques,
  RecordTechniques,
  PauseResume,
  Restart,
  RegionTool,
  ClearRegion,
  FrameSelection,
  ResetCamera,
  ExposureUp,
  ExposureDown,
  NormaliseExposure,
  PreviousLayer,
  NextLayer,
  ClipWarning,
  Inspector,
  LoadReference,
  PinPicture,
  ZoomFit,
  ZoomActual,
  KeySheet,
  HideUi,
  LargerUi,
  SmallerUi,
};

/// Keys that mean something while a tool is at work.
enum class ToolCommand { Finish, RemoveLast, Cancel };

struct ToolKey {
  ToolCommand command;
  int key;  // GLFW key code
  const char* label;
};

struct KeyBinding {
  Action action;
  int key;            // GLFW key code
  int modifiers;      // GLFW_MOD_ bits, exactly these
  const char* group;  // heading in the key sheet
  const char* label;  // as in menus
};

/// A movement of the mouse over the picture.
enum class Gesture { UseTool, Orbit, Pan, Fly, Dolly, PanImage, ZoomImage };

enum class MouseInput { Left, Right, Middle, Wheel };

struct MouseBinding {
  Gesture gesture;
  MouseInput input;
  int modifiers;  // GLFW_MOD_ bits
  const char* group;
  const char* label;
};

/// Held while flying: the way to go in camera space (x right, y up, z forward).
struct FlyKey {
  int key;
  Vec3 direction;
  const char* label;
};

std::span<const KeyBinding> key_bindings();
std::span<const MouseBinding> mouse_bindings();
std::span<const FlyKey> fly_keys();
std::span<const ToolKey> tool_keys();
std::optional<ToolCommand> tool_command_for(int key, int modifiers);

/// While flying Shift is fast and Ctrl is slow.
float fly_speed_factor(int modifiers);

std::optional<Action> action_for(int key, int modifiers);
/// Whether an action is done again and again while its key is held.
bool repeats(Action action);
/// Modifiers that no binding of the input mentions are ignored for drags with the right button, so
/// that Shift and Ctrl can change the speed of flying.
std::optional<Gesture> gesture_for(MouseInput input, int modifiers);

/// "Ctrl+Shift+E", of the first binding of the action.
std::string shortcut_text(Action action);
const char* action_label(Action action);
std::string key_text(int key, int modifiers);
std::string mouse_text(const MouseBinding& binding);

}  // namespace guidelight
