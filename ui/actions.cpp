#include "ui/actions.h"

#include <filesystem>

#include "ui/guides/new_guide.h"
#include "ui/panels/panels.h"
#include "ui/tools/guide_tool.h"
#include "ui/tools/harvest_tool.h"
#include "ui/tools/region_tool.h"

namespace guidelight {
namespace {

constexpr float kExposureStep = 0.25f;  // [EV]
constexpr float kScaleStep = 1.1f;

// One function per group of the key table; each says whether the action was one of its own.

void choose_file(const Workbench& bench, FileRequest request, const std::string& start,
                 std::function<void(const std::string&)> chosen) {
  request.chosen = std::move(chosen);
  bench.file_dialog.open(std::move(request), start);
}

bool perform_on_files(Action action, const Workbench& bench) {
  switch (action) {
    case Action::OpenScene:
      choose_file(bench, open_scene_request(),
                  std::filesystem::path(bench.document.opened().path).parent_path().string(),
                  [&opener = bench.opener](const std::string& path) { opener.open(path); });
      return true;
    case Action::ReloadScene:
      bench.opener.reload();
      return true;
    case Action::SaveCheckpoint:
      choose_file(bench, save_checkpoint_request(), bench.checkpoints.suggested_path(),
                  [&saver = bench.checkpoints](const std::string& path) { saver.save(path); });
      return true;
    case Action::ResumeCheckpoint:
      choose_file(bench, resume_checkpoint_request(), current_folder(),
                  [&opener = bench.opener](const std::string& path) { opener.resume(path); });
      return true;
    case Action::Screenshot:
      bench.exporter.save_png(bench.render_view.picture());
      return true;
    case Action::WindowCapture:
      bench.state.capture_requested = true;
      return true;
    case Action::SaveFigure:
      bench.state.figure_requested = true;
      return true;
    case Action::ExportHalf:
      bench.exporter.save_exr(true);
      return true;
    case Action::ExportFloat:
      bench.exporter.save_exr(false);
      return true;
    case Action::Quit:
      bench.window.close();
      return true;
    default:
      return false;
  }
}

/// Takes up a tool that drags a rectangle over the picture, or puts it aside.
template <class Kind>
void toggle_rectangle_tool(const Workbench& bench) {
  if (bench.toolbox.holds<Kind>()) {
    bench.toolbox.use_default();
    return;
  }
  bench.toolbox.use(std::make_unique<Kind>());
  if (!bench.views.shows_render()) bench.views.show(ShownViews::Render);
}

bool perform_on_guides(Action action, const Workbench& bench) {
  Document& document = bench.document;
  switch (action) {
    case Action::NewGuide:
      bench.first_hint.dismiss();
      if (bench.toolbox.holds<GuideTool>()) {
        bench.toolbox.use_default();
      } else {
        bench.toolbox.use(std::make_unique<GuideTool>());
        document.guide_view().shown = true;
        bench.tabs.show(Tabs::Guides);
      }
      return true;
    case Action::ShowGuides:
      document.guide_view().shown = !document.guide_view().shown;
      return true;
    case Action::HarvestTool:
      toggle_rectangle_tool<HarvestTool>(bench);
      bench.tabs.show(Tabs::Guides);
      return true;
    case Action::KeepPath: {
      const Harvest& harvest = document.harvest();
      add_guide(document, harvest.paths[harvest.selected.value_or(0)].guide, "kept light path");
      return true;
    }
    case Action::DuplicateGuide:
      duplicate_guide(document, *document.guide_view().selected);
      return true;
    case Action::DeleteGuide:
      delete_guide(document, *document.guide_view().selected);
      return true;
    default:
      return false;
  }
}

void clear_region(const Workbench& bench) {
  bench.toolbox.use_default();
  RenderSettings settings = bench.document.settings();
  if (!settings.region) return;
  settings.region.reset();
  bench.document.set_settings(settings);
}

bool perform_on_render(Action action, const Workbench& bench) {
  Document& document = bench.document;
  switch (action) {
    case Action::Undo:
      document.undo();
      return true;
    case Action::Redo:
      document.redo();
      return true;
    case Action::PauseResume:
      document.set_paused(!document.paused());
      return true;
    case Action::Restart:
      document.restart();
      return true;
    case Action::RegionTool:
      toggle_rectangle_tool<RegionTool>(bench);
      return true;
    case Action::ClearRegion:
      clear_region(bench);
      return true;
    default:
      return false;
  }
}

/// Whether camera commands are meant for the scout view.
bool works_in_scout(const Workbench& bench) {
  return !bench.views.shows_render() || bench.scout_view.hovered();
}

void frame_selection(const Workbench& bench) {
  const Bounds bounds = bench.document.bounds_of_selection();
  if (works_in_scout(bench)) {
    bench.scout_view.frame(bounds);
  } else {
    bench.document.move_camera([&](CameraController& camera) { camera.frame(bounds); });
  }
}

void show_photons(const Workbench& bench) {
  PhotonView photons = bench.document.photon_view();
  photons.shown = !photons.shown;
  bench.document.set_photon_view(photons);
  if (photons.shown) bench.tabs.show(Tabs::Photons);
}

void show_techniques(const Workbench& bench) {
  TechniqueView& view = bench.document.technique_view();
  view.shown = !view.shown;
  view.enlarged.reset();
  if (!view.shown) return;
  bench.tabs.show(Tabs::Image);
  if (!bench.views.shows_render()) bench.views.show(ShownViews::Render);
}

bool perform_on_views(Action action, const Workbench& bench) {
  switch (action) {
    case Action::CycleViews:
      bench.views.cycle();
      return true;
    case Action::ShowPhotons:
      show_photons(bench);
      return true;
    case Action::ShowTechniques:
      show_techniques(bench);
      return true;
    case Action::RecordTechniques:
      bench.document.record_techniques(!bench.document.records_techniques());
      return true;
    case Action::ViewFromRender:
      bench.scout_view.stand_at_render_camera(bench.document);
      return true;
    case Action::FrameSelection:
      frame_selection(bench);
      return true;
    case Action::ResetCamera:
      if (works_in_scout(bench)) {
        bench.scout_view.stand_at_render_camera(bench.document);
      } else {
        bench.document.reset_camera();
      }
      return true;
    case Action::ZoomFit:
      bench.render_view.transform().fit();
      return true;
    case Action::ZoomActual:
      bench.render_view.transform().zoom_to(1);
      return true;
    default:
      return false;
  }
}

bool perform_on_picture(Action action, const Workbench& bench) {
  Document& document = bench.document;
  DisplaySettings& display = document.view().current();
  switch (action) {
    case Action::ExposureUp:
      document.step_exposure(kExposureStep);
      return true;
    case Action::ExposureDown:
      document.step_exposure(-kExposureStep);
      return true;
    case Action::NormaliseExposure:
      document.normalise();
      return true;
    case Action::PreviousLayer:
      document.step_layer(-1);
      return true;
    case Action::NextLayer:
      document.step_layer(1);
      return true;
    case Action::ClipWarning:
      display.show_clipped = !display.show_clipped;
      return true;
    case Action::Inspector:
      bench.state.inspector_shown =
          !bench.state.inspector_shown || bench.tabs.shown() != Tabs::Image;
      bench.tabs.show(Tabs::Image);
      return true;
    case Action::LoadReference:
      choose_file(bench, load_reference_request(), current_folder(),
                  [&comparison = bench.comparison, &tabs = bench.tabs](const std::string& path) {
                    comparison.load_reference(path);
                    tabs.show(Tabs::Compare);
                  });
      return true;
    case Action::PinPicture:
      bench.comparison.pin();
      bench.tabs.show(Tabs::Compare);
      return true;
    default:
      return false;
  }
}

bool perform_on_window(Action action, const Workbench& bench) {
  switch (action) {
    case Action::KeySheet:
      bench.state.key_sheet_shown = !bench.state.key_sheet_shown;
      return true;
    case Action::HideUi:
      bench.state.panels_shown = !bench.state.panels_shown;
      return true;
    case Action::LargerUi:
      bench.window.set_scale(bench.window.scale() * kScaleStep);
      return true;
    case Action::SmallerUi:
      bench.window.set_scale(bench.window.scale() / kScaleStep);
      return true;
    default:
      return false;
  }
}

}  // namespace

std::string current_folder() {
  std::error_code ignored;
  return std::filesystem::current_path(ignored).string();
}

void perform(Action action, const Workbench& bench) {
  if (!why_disabled(action, bench.document).empty()) return;
  for (const auto perform_group : {perform_on_files, perform_on_guides, perform_on_render,
                                   perform_on_views, perform_on_picture, perform_on_window}) {
    if (perform_group(action, bench)) return;
  }
}

}  // namespace guidelight
