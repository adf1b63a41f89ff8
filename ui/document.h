#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "renderer/image/technique_images.h"
#include "renderer/image/tonemap.h"
#include "renderer/integrators/pixel_history.h"
#include "renderer/metropolis/harvest.h"
#include "renderer/scene/scene.h"
#include "renderer/session/checkpoints.h"
#include "renderer/session/render_session.h"
#include "renderer/transport/guide_check.h"
#include "ui/camera_controller.h"
#include "ui/guides/guide_editing.h"
#include "ui/messages.h"
#include "ui/undo_stack.h"

namespace guidelight {

/// A scene that was read and built, ready to be shown.
struct OpenedScene {
  std::string path;
  std::map<std::string, std::string> defines;  // variables it was read with
  std::shared_ptr<const Scene> scene;
  GuideList guides;           // from the file beside it; null if there is none
  std::string guide_problem;  // why that file could not be read; empty if it could
};

/// What to render, as a person sets it: everything of a RenderJob but the scene.
struct RenderSettings {
  std::string integrator;
  std::shared_ptr<const IntegratorSettings> parameters;
  int width = 0;  // of the picture [pixels]
  int height = 0;
  uint64_t seed = 0;
  int threads = 0;  // 0: all processors
  RenderTargets targets;
  std::optional<PixelRegion> region;
};

/// How the picture is looked at. Changing it never restarts the render.
struct ViewSettings {
  Layer layer = Layer::Beauty;
  std::optional<glm::ivec2> inspected_pixel;
  std::optional<glm::ivec2> hovered_pixel;
  /// Dragged to see the light paths of more than a pixel.
  std::optional<PixelRegion> harvested_region;

  ViewSettings();
  /// Whose light paths one may want to see: the rectangle's, else the pixel's.
  std::optional<PixelRegion> harvested() const;
  /// Whatever was picked is of another picture.
  void forget_picked();
  /// Of the layer shown. Layers that hold radiance share theirs, the others have their own.
  DisplaySettings& current() { return display_[slot()]; }
  const DisplaySettings& current() const { return display_[slot()]; }
  const DisplaySettings& of_radiance() const {
    return display_[static_cast<size_t>(Layer::Beauty)];
  }

 private:
  size_t slot() const;
  std::array<DisplaySettings, kLayerCount> display_;
};

/// The light paths of a part of the picture.
struct Harvest {
  std::optional<PixelRegion> region;  // empty while nobody wants to see any
  std::vector<HarvestedPath> paths;   // the strongest first
  std::optional<size_t> selected;
  bool searching = false;
  bool is_news = false;  // until the list has been brought into sight
};

/// What photons are looked at by: their power, their bounce, whether they make caustics, or the
/// guide that their path followed.
enum class PhotonColoring { Power, Bounce, Kind, Guide };

/// How photons are looked at.
struct PhotonView {
  bool shown = false;
  bool points = true;
  bool density = false;  // as colours of the surfaces
  PhotonColoring coloring = PhotonColoring::Power;
  float point_size = 3;  // [pixels]
  int cap = 50'000;      // of those drawn

  bool operator==(const PhotonView&) const = default;
};

/// How the techniques of a bidirectional method are looked at.
struct TechniqueView {
  bool shown = false;  // instead of the picture
  bool weighted = true;
  std::optional<TechniqueImages::Technique> enlarged;  // else all of them
};

/// How guides are looked at and placed; not part of what is saved.
struct GuideView {
  std::optional<size_t> selected;
  std::optional<size_t> solo;  // only this one is followed
  bool shown = true;
  bool candidates_shown = true;
  int swing_bounces = 3;
  SpecularChoice choice = SpecularChoice::Refract;
};

inline constexpr float kLargestExposure = 20;  // [EV] up and down

/// Depth, sample count and variance: numbers rather than colours.
bool is_data_layer(Layer layer);
/// "coffee" for ".../coffee/scene_v3.xml", "box" for ".../box.xml".
std::string scene_title(const std::string& path);

/// What is open: the scene, the camera, the settings and the render that follows from them. Panels
/// and tools read it and send it edits. It belongs to the UI thread and knows nothing of windows.
class Document {
 public:
  using Clock = std::chrono::steady_clock;

  /// `published` is called from the render thread whenever there is a new snapshot.
  explicit Document(std::function<void()> published);

  // -- The scene.
  /// What was asked for on the command line instead of what scenes say; for every scene opened
  /// later.
  void override_settings(const RenderSettings& settings) { overrides_ = settings; }
  /// Shows another scene from its own camera with its own settings, and renders it.
  void open(OpenedScene opened);
  /// Shows a new version of the scene. The camera and what the person has set stay, unless the file
  /// now says something else.
  void reload(OpenedScene opened);
  /// Grows with every scene opened.
  uint64_t openings() const { return openings_; }
  bool has_scene() const { return opened_.scene != nullptr; }
  const OpenedScene& opened() const { return opened_; }
  const Scene& scene() const { return *opened_.scene; }
  /// The scene through the camera as it is now; null without a scene.
  std::shared_ptr<const Scene> current_scene() const;
  std::string title() const { return scene_title(opened_.path); }

  // -- The camera. Edits restart the render with a coarse picture first.
  const CameraController& camera() const { return camera_; }
  void move_camera(const std::function<void(CameraController&)>& move);
  void reset_camera();
  /// Sets the distance of the pivot to what is in the middle of the picture.
  void find_pivot();

  // -- The render.
  const RenderSettings& settings() const { return settings_; }
  /// Takes over changed settings. Restarts the render, unless only the targets have changed.
  void set_settings(const RenderSettings& settings);
  /// Changes to another algorithm with its own defaults for the scene.
  void set_integrator(const std::string& name);
  void restart() { restart_pending_ = has_scene(); }
  bool restart_pending() const { return restart_pending_; }
  /// Goes on from a checkpoint, read from `path`, instead of from nothing. A checkpoint that is not
  /// of this scene, camera and settings is refused in the messages.
  void resume(Checkpoint checkpoint, const std::string& path);
  /// Has the progress written to a checkpoint when the pass is done. `done` is called on the render
  /// thread, with the reason if it failed and empty otherwise. False if nothing is being rendered.
  bool save_checkpoint(const std::string& path, std::function<void(const std::string&)> done);
  void set_paused(bool paused);
  bool paused() const { return paused_; }

  /// Carries out pending restarts and takes over what was rendered; to be called once per frame.
  void update(Clock::time_point now);
  /// The latest state of the render; never null.
  const Snapshot& status() const { return *status_; }
  /// The latest picture; null before the first.
  const std::shared_ptr<const Snapshot>& picture() const { return picture_; }
  /// What the latest picture is of, even if a newer job has been started since.
  const RenderJob& picture_job() const { return *shared_picture_job(); }
  std::shared_ptr<const RenderJob> shared_picture_job() const { return jobs_.front().job; }

  // -- Guide paths. Changing them never restarts the render.
  /// Never null.
  const GuideList& guides() const { return edits_.state().guides; }
  /// Steps of one nonempty `kind` are undone together until seal_edits().
  void edit_guides(std::vector<GuidePath> guides, const std::string& label,
                   const std::string& kind = "");
  /// Why a guide cannot be followed, beside guides().
  const std::vector<GuideFault>& guide_faults(size_t guide) const { return faults_[guide]; }
  GuideView& guide_view() { return guide_view_; }
  const GuideView& guide_view() const { return guide_view_; }
  /// Light paths as the selected guide proposes them.
  const GuideCandidates& candidates() const { return candidates_.drawn; }
  /// As they were in the scene's file.
  const GuideList& guides_as_opened() const { return guides_as_opened_; }
  void set_solo(std::optional<size_t> guide);

  Harvest& harvest() { return harvest_; }
  const Harvest& harvest() const { return harvest_; }

  /// Of the selected guide or else light path, with some room around; without, of the scene.
  Bounds bounds_of_selection() const;

  // -- Photons.
  const PhotonView& photon_view() const { return photon_view_; }
  /// Photons cost nothing while they are not shown.
  void set_photon_view(const PhotonView& view);

  // -- Techniques.
  TechniqueView& technique_view() { return technique_view_; }
  const TechniqueView& technique_view() const { return technique_view_; }
  /// From the next pass on techniques are kept apart, or no more; also those of later renders.
  void record_techniques(bool record);
  bool records_techniques() const { return records_techniques_; }
  /// Of the render started last; null if they are not recorded, or if it has none.
  const std::shared_ptr<TechniqueImages>& techniques() const { return techniques_; }
  /// Has something done on the render thread when the pass is done; it is forgotten if the render
  /// fails or is replaced.
  void between_passes(std::function<void()> act);

  /// How the density estimates of the inspected or the hovered pixel have developed; empty for
  /// others, and for methods without.
  std::vector<PixelHistory::Entry> pixel_history(glm::ivec2 pixel) const;

  // -- Undo, of guides and render settings.
  void undo();
  void redo();
  std::string undo_label() const { return edits_.undo_label(); }
  std::string redo_label() const { return edits_.redo_label(); }
  /// Ends a step of many small changes, a drag for instance.
  void seal_edits() { edits_.seal(); }

  // -- The look of the picture.
  ViewSettings& view() { return view_; }
  const ViewSettings& view() const { return view_; }
  void step_layer(int step);
  /// [EV], within kLargestExposure.
  void step_exposure(float step);
  /// Shows another layer; a data layer that was never seen before gets a range that suits it.
  void show_layer(Layer layer);
  /// Exposure to middle grey, or the range of false colours to the values of the layer.
  void normalise();

  Messages& messages() { return messages_; }
  const Messages& messages() const { return messages_; }

 private:
  Camera current_camera() const;
  RenderSettings settings_for(const Scene& scene) const;
  void start(Clock::time_point now);
  void apply_settings(const RenderSettings& settings);
  void take_guides();
  void take_edits(const std::vector<GuidePath>& guides_before);
  void find_again(const std::vector<GuidePath>& before);
  void follow_guides();
  void update_candidates();
  void watch_pixels();
  std::shared_ptr<TechniqueImages> make_technique_images() const;
  GuideList followed_guides() const;

  struct Edits {
    GuideList guides;
    RenderSettings settings;
  };

  OpenedScene opened_;
  uint64_t openings_ = 0;
  GuideList guides_as_opened_;
  CameraController camera_;
  UndoStack<Edits> edits_{{std::make_shared<const std::vector<GuidePath>>(), {}}};
  std::vector<std::vector<GuideFault>> faults_;
  GuideView guide_view_;
  Harvest harvest_;
  PhotonView photon_view_;
  TechniqueView technique_view_;
  bool records_techniques_ = false;
  std::shared_ptr<TechniqueImages> techniques_;
  std::shared_ptr<PixelHistory> history_ = std::make_shared<PixelHistory>();  // of this job
  std::vector<PixelHistory::Pixel> watched_;                                  // in history_
  struct {
    std::optional<size_t> of;  // guide
    GuideCandidates drawn;
  } candidates_;
  RenderSettings settings_;
  RenderSettings overrides_;
  ViewSettings view_;
  std::array<bool, kLayerCount> range_known_{};
  Messages messages_;

  bool paused_ = false;
  bool restart_pending_ = false;
  struct PendingResume {
    Checkpoint checkpoint;
    std::string path;
  };
  std::optional<PendingResume> resume_;  // for the next start
  struct StartedJob {
    uint64_t number;
    std::shared_ptr<RenderJob> job;  // its guides are the newest while it is rendered
  };
  std::deque<StartedJob> jobs_;  // from the picture's to the last one started
  Clock::time_point job_started_;
  uint64_t failure_reported_ = 0;  // job
  std::shared_ptr<const Snapshot> status_ = std::make_shared<const Snapshot>();
  std::shared_ptr<const Snapshot> picture_;
  RenderSession session_;  // last: it stops before the rest goes
};

}  // namespace guidelight
