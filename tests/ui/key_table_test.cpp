#include "ui/key_table.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <set>

namespace guidelight {
namespace {

TEST(KeyTable, NoKeyMeansTwoThings) {
  std::set<std::pair<int, int>> keys;
  for (const KeyBinding& binding : key_bindings()) {
    EXPECT_TRUE(keys.insert({binding.key, binding.modifiers}).second) << binding.label;
  }
}

TEST(KeyTable, NoMouseInputMeansTwoThings) {
  std::set<std::pair<int, int>> inputs;
  for (const MouseBinding& binding : mouse_bindings()) {
    EXPECT_TRUE(inputs.insert({static_cast<int>(binding.input), binding.modifiers}).second)
        << binding.label;
  }
}

TEST(KeyTable, FindsActionsByKeyAndModifiers) {
  EXPECT_EQ(action_for(GLFW_KEY_E, 0), Action::ExposureUp);
  EXPECT_EQ(action_for(GLFW_KEY_E, GLFW_MOD_SHIFT), Action::ExposureDown);
  EXPECT_EQ(action_for(GLFW_KEY_E, GLFW_MOD_CONTROL), Action::ExportHalf);
  EXPECT_EQ(action_for(GLFW_KEY_E, GLFW_MOD_ALT), std::nullopt);
  EXPECT_EQ(action_for(GLFW_KEY_E, GLFW_MOD_CAPS_LOCK), Action::ExposureUp) << "locks do not count";
}

TEST(KeyTable, WritesKeysAsPeopleDo) {
  EXPECT_EQ(shortcut_text(Action::ExportFloat), "Ctrl+Shift+E");
  EXPECT_EQ(shortcut_text(Action::WindowCapture), "Shift+F12");
  EXPECT_EQ(shortcut_text(Action::PauseResume), "Space");
  EXPECT_EQ(shortcut_text(Action::NextLayer), "]");
  for (const KeyBinding& binding : key_bindings()) {
    EXPECT_EQ(shortcut_text(binding.action), key_text(binding.key, binding.modifiers));
  }
}

TEST(KeyTable, FlyingTakesAnyModifiers) {
  EXPECT_EQ(gesture_for(MouseInput::Right, 0), Gesture::Fly);
  EXPECT_EQ(gesture_for(MouseInput::Right, GLFW_MOD_SHIFT), Gesture::Fly);
  EXPECT_GT(fly_speed_factor(GLFW_MOD_SHIFT), 1);
  EXPECT_LT(fly_speed_factor(GLFW_MOD_CONTROL), 1);
}

TEST(KeyTable, AltDragsTheCameraAndPlainClicksUseTheTool) {
  EXPECT_EQ(gesture_for(MouseInput::Left, 0), Gesture::UseTool);
  EXPECT_EQ(gesture_for(MouseInput::Left, GLFW_MOD_ALT), Gesture::Orbit);
  EXPECT_EQ(gesture_for(MouseInput::Middle, GLFW_MOD_ALT), Gesture::Pan);
  EXPECT_EQ(gesture_for(MouseInput::Wheel, 0), Gesture::Dolly);
  EXPECT_EQ(gesture_for(MouseInput::Wheel, GLFW_MOD_CONTROL), Gesture::ZoomImage);
}

}  // namespace
}  // namespace guidelight
