#include "ui/viewer.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <thread>
#include <utility>

#include "renderer/error.h"
#include "ui/actions.h"
#include "ui/figure.h"
#include "ui/guides/guide_saver.h"
#include "ui/guides/harvester.h"
#include "ui/layout.h"
#include "ui/memory_keeper.h"
#include "ui/panels/panels.h"
#include "ui/picture_developer.h"
#include "ui/recent_files.h"
#include "ui/theme.h"
#include "ui/tools/guide_tool.h"
#include "ui/tools/harvest_tool.h"
#include "ui/tools/region_tool.h"
#include "ui/ui_queue.h"
#include "ui/widgets.h"
#include "ui/window.h"

namespace guidelight {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::microseconds kShortestFrame{16'000};
constexpr double kLongSleep = 5;      // [s] when nothing happens …
constexpr double kShortSleep = 0.5;   // … while a message or a text cursor is shown, …
constexpr double kBriefSleep = 0.05;  // … and while the camera waits for the render
constexpr int kFramesAfterEvent = 2;  // ImGui needs a second one to settle

class Viewer {
 public:
  explicit Viewer(const ViewerOptions& options);
  ~Viewer() { queue_->close(); }

  void run();
  /// Whether threads are left that nobody can wait for.
  bool leaves_threads_behind() const { return opener_.threads_running(); }

 private:
  void draw_frame();
  void draw_panels();
  void draw_views();
  void save_figure();
  void update_title();
  void wait_for_next_frame(Clock::time_point last_frame);
  double seconds_to_sleep() const;

  bool animating() const { return view_.animating() || scout_.animating(); }
  void handle_key(int key, int modifiers, bool is_repeat);
  void perform(Action action) {
    attempt([&] { guidelight::perform(action, bench_); });
  }
  void attempt(const std::function<void()>& act);
  void leave_techniques();
  void show_new_scene();
  void show_reloaded_scene();
  void take_reference(const std::string& path);

  std::shared_ptr<UiQueue> queue_ = std::make_shared<UiQueue>(&Window::wake);
  Window window_;
  Document document_{&Window::wake};
  PictureDeveloper developer_;
  Toolbox toolbox_;
  DisplayScene display_{*queue_, document_.messages()};
  Comparison comparison_{document_, *queue_};
  TechniqueGallery techniques_{document_, queue_};
  RenderView view_{window_, display_, comparison_, techniques_};
  ScoutView scout_{window_, display_};
  Exporter exporter_;
  CheckpointSaver checkpoints_;
  GuideSaver guide_saver_{document_, *queue_};
  Harvester harvester_{document_, *queue_};
  Opener opener_;
  MemoryKeeper memory_;
  std::function<void(double seconds)> on_frame_;
  RecentFiles recent_;
  FirstHint first_hint_{std::filesystem::path(RecentFiles::default_path()).parent_path().string()};
  FileDialog file_dialog_;
  Layout layout_;
  ViewLayout views_;
  Tabs tabs_;
  std::string title_;
  WindowState state_;
  Workbench bench_{window_,      state_,  document_,    toolbox_,    views_,
                   view_,        scout_,  tabs_,        comparison_, exporter_,
                   checkpoints_, opener_, file_dialog_, first_hint_};
  int frames_due_ = kFramesAfterEvent;
};

Viewer::Viewer(const ViewerOptions& options)
    : window_("Guidelight", options.ui_scale),
      developer_(
          *queue_,
          [this](std::shared_ptr<const Picture> picture) {
            if (document_.picture()) view_.show(std::move(picture));  // else of the last scene
          },
          [this](const std::string& reason) {
            document_.messages().error("The picture cannot be shown: " + reason);
          }),
      exporter_(document_, *queue_, current_folder()),
      checkpoints_(document_, queue_, current_folder()),
      opener_(document_, queue_,
              {[this] { show_new_scene(); }, [this] { show_reloaded_scene(); },
               [this](const std::string& path) { take_reference(path); }}),
      on_frame_(options.on_frame) {
  RenderSettings overrides;
  overrides.integrator = options.integrator;
  overrides.width = options.width;
  overrides.height = options.height;
  overrides.threads = options.threads;
  overrides.seed = options.seed;
  document_.override_settings(overrides);
  window_.on_key = [this](auto... key) { handle_key(key...); };
  window_.on_drop = [this](const std::vector<std::string>& paths) {
    if (!paths.empty()) attempt([&] { opener_.open(paths.front()); });
  };
  if (!options.scene_path.empty()) opener_.open(options.scene_path, options.defines);
}

// -- The loop.

void Viewer::run() {
  Clock::time_point frame_began = Clock::now();
  while (!window_.should_close()) {
    wait_for_next_frame(frame_began);
    frame_began = Clock::now();
    attempt([this] { queue_->run(); });
    if (!ImGui::IsAnyMouseDown() && !ImGui::IsAnyItemActive()) document_.seal_edits();
    document_.update(frame_began);
    checkpoints_.update(frame_began);
    guide_saver_.update(frame_began);
    harvester_.update(state_.panels_shown && tabs_.shown() == Tabs::Guides);
    display_.update(document_, frame_began);
    comparison_.update(frame_began);
    techniques_.update(frame_began);
    memory_.update(document_.status().generation, frame_began);
    if (document_.picture()) {
      developer_.request(document_.picture(), document_.shared_picture_job(),
                         document_.view().layer, document_.view().current());
    }
    update_title();
    draw_frame();
    if (on_frame_) on_frame_(std::chrono::duration<double>(Clock::now() - frame_began).count());
  }
}

/// What nobody expected to fail is said, and the window stays open.
void Viewer::attempt(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::exception& error) {
    document_.messages().error(error.what());
  }
}

/// Sleeps until something happens; no more than sixty frames are drawn in a second.
void Viewer::wait_for_next_frame(Clock::time_point last_frame) {
  if (--frames_due_ <= 0 && !animating() && !window_.events_pending()) {
    window_.wait_events(seconds_to_sleep());
    frames_due_ = kFramesAfterEvent;
  }
  std::this_thread::sleep_until(last_frame + kShortestFrame);
  window_.wait_events(0);
}

double Viewer::seconds_to_sleep() const {
  if (document_.restart_pending() || guide_saver_.pending() || display_.pending() ||
      techniques_.pending()) {
    return kBriefSleep;
  }
  const bool calm =
      document_.messages().shown().empty() && !ImGui::GetIO().WantTextInput && !memory_.pending();
  return calm ? kLongSleep : kShortSleep;
}

void Viewer::update_title() {
  const std::string title =
      document_.has_scene() ? document_.title() + " — Guidelight" : "Guidelight";
  if (title == title_) return;
  title_ = title;
  window_.set_title(title);
}

void Viewer::draw_frame() {
  window_.begin_frame();
  const auto act = [this](Action action) { perform(action); };
  float menu_height = 0;
  if (state_.panels_shown) {
    draw_menu_bar(
        document_, recent_, act, [this](const std::string& path) { opener_.open(path); }, views_);
    menu_height = ImGui::GetFrameHeight();
  }
  layout_.update(state_.panels_shown, menu_height);
  draw_views();
  if (state_.panels_shown) draw_panels();
  if (std::exchange(state_.figure_requested, false)) save_figure();
  file_dialog_.draw(recent_);
  if (state_.key_sheet_shown) draw_key_sheet(state_.key_sheet_shown);

  if (state_.capture_requested) {
    state_.capture_requested = false;
    DisplayImage capture;
    window_.end_frame(&capture);
    exporter_.save_drawing(std::move(capture), view_.picture().get(), "-window");
  } else {
    window_.end_frame();
  }
}

void Viewer::save_figure() {
  if (!view_.picture()) {
    document_.messages().warning("There is no picture for a figure yet.");
    return;
  }
  const Picture& picture = *view_.picture();
  exporter_.save_drawing(paint_figure(document_, picture), &picture, "-figure");
}

void Viewer::draw_views() {
  const Area& area = layout_.view();
  views_.update(area);
  document_.view().hovered_pixel.reset();
  if (views_.shows_render()) {
    begin_area("view", views_.render(), Padding::None, palette::kBackdrop);
    view_.draw(document_, toolbox_);
    if (document_.has_scene() && document_.guides()->empty() && !document_.technique_view().shown) {
      first_hint_.draw(from_imgui(views_.render().corner), views_.render().size.x);
    }
    ImGui::End();
  }
  if (views_.shows_scout()) {
    begin_area("scout", views_.scout(), Padding::None, palette::kBackdrop);
    scout_.draw(document_, toolbox_);
    ImGui::End();
  }
  const float margin = scaled(12);
  draw_messages(document_.messages(),
                {area.corner.x + margin, area.corner.y + area.size.y - margin},
                std::min(area.size.x - 2 * margin, scaled(620)));
}

void Viewer::draw_panels() {
  const auto act = [this](Action action) { perform(action); };
  begin_area("left", layout_.left(), Padding::Panel, palette::kPanel);
  draw_render_commands(document_, toolbox_.holds<RegionTool>(), act);
  const auto& parameters = document_.settings().parameters;
  const float column =
      settings_column(parameters ? parameters->clone()->parameters() : std::vector<Parameter>());
  draw_scene_panel(document_, column);
  draw_integrator_panel(document_, column);
  draw_render_panel(document_, checkpoints_.autosave_minutes(), column);
  ImGui::End();

  begin_area("right", layout_.right(), Padding::Panel, palette::kPanel);
  if (tabs_.begin()) {
    if (tabs_.tab(Tabs::Image)) {
      draw_image_panel(document_, act);
      draw_histogram_panel(document_, view_.picture().get());
      draw_techniques_panel(document_, act);
      if (state_.inspector_shown) draw_inspector_panel(document_);
      ImGui::EndTabItem();
    }
    if (tabs_.tab(Tabs::Guides)) {
      draw_guides_panel(document_, {toolbox_.holds<GuideTool>(), toolbox_.holds<HarvestTool>()},
                        guide_saver_.path(), act);
      ImGui::EndTabItem();
    }
    if (tabs_.tab(Tabs::Photons)) {
      draw_photons_panel(document_, display_);
      ImGui::EndTabItem();
    }
    if (tabs_.tab(Tabs::Compare)) {
      draw_compare_panel(document_, comparison_, act);
      draw_statistics_panel(document_);
      ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
  }
  ImGui::End();

  begin_area("status", layout_.status(), Padding::Bar, palette::kPanel);
  draw_status_bar(document_, view_.transform().scale(), opener_.loading());
  ImGui::End();
}

// -- What the person does.

void Viewer::handle_key(int key, int modifiers, bool is_repeat) {
  frames_due_ = kFramesAfterEvent;
  if (animating() || file_dialog_.is_open()) return;
  const auto command = tool_command_for(key, modifiers);
  if (command == ToolCommand::Cancel && close_lists()) return;
  if (command == ToolCommand::Cancel && document_.technique_view().shown) {
    leave_techniques();
    return;
  }
  if (command && document_.has_scene() && toolbox_.tool().take(document_, *command)) {
    toolbox_.tidy();
    return;
  }
  const auto action = action_for(key, modifiers);
  // A drag goes on in the view where it began.
  if (action == Action::CycleViews && ImGui::IsAnyMouseDown()) return;
  if (action && (!is_repeat || repeats(*action))) perform(*action);
}

/// Cameras and what the render is compared with stay as they are.
void Viewer::show_reloaded_scene() {
  toolbox_.use_default();
  view_.show(nullptr);
  display_.show(document_.opened().scene);
}

void Viewer::take_reference(const std::string& path) {
  comparison_.load_reference(path);
  tabs_.show(Tabs::Compare);
}

/// From the large picture of one to all of them, from there to the render.
void Viewer::leave_techniques() {
  TechniqueView& view = document_.technique_view();
  view.shown = view.enlarged.has_value();
  view.enlarged.reset();
}

void Viewer::show_new_scene() {
  toolbox_.use_default();
  view_.show(nullptr);
  view_.transform().fit();
  display_.show(document_.opened().scene);
  scout_.show(document_);
  comparison_.forget();
  try {
    recent_.add(document_.opened().path);
  } catch (const std::exception& error) {
    document_.messages().warning(error.what());
  }
}

}  // namespace

int run_viewer(const ViewerOptions& options) {
  if (!options.integrator.empty()) find_integrator(options.integrator);  // throws for unknown names
  bool leave_at_once = false;
  {
    Viewer viewer(options);
    viewer.run();
    leave_at_once = viewer.leaves_threads_behind();
  }
  // A scene that is still being read cannot be interrupted; nothing else is left to be done.
  if (leave_at_once) std::_Exit(0);
  return 0;
}

}  // namespace guidelight
