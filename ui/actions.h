#pragma once

#include "ui/checkpoint_saver.h"
#include "ui/compare/comparison.h"
#include "ui/export.h"
#include "ui/first_hint.h"
#include "ui/key_table.h"
#include "ui/opener.h"
#include "ui/panels/file_dialog.h"
#include "ui/panels/tabs.h"
#include "ui/render_view.h"
#include "ui/scout/scout_view.h"
#include "ui/view_layout.h"

namespace guidelight {

/// What of the window is shown, or is about to be done with it.
struct WindowState {
  bool panels_shown = true;
  bool inspector_shown = true;
  bool key_sheet_shown = false;
  // In the next frame:
  bool capture_requested = false;  // of the whole window
  bool figure_requested = false;
};

/// What actions work on.
struct Workbench {
  Window& window;
  WindowState& state;
  Document& document;
  Toolbox& toolbox;
  ViewLayout& views;
  RenderView& render_view;
  ScoutView& scout_view;
  Tabs& tabs;
  Comparison& comparison;
  Exporter& exporter;
  CheckpointSaver& checkpoints;
  Opener& opener;
  FileDialog& file_dialog;
  FirstHint& first_hint;
};

/// Does what a key, a button or an entry of a menu asks for; nothing where that makes no sense
/// (why_disabled).
void perform(Action action, const Workbench& bench);

/// The folder that the viewer was started in, where its files go.
std::string current_folder();

}  // namespace guidelight
