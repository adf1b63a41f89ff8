#include "ui/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <tuple>
#include <utility>

#include "renderer/io/guide_file.h"
#include "ui/histogram.h"

namespace guidelight {
namespace {

constexpr int kCandidates = 100;  // drawn of the selected guide

constexpr int kLongestTechnique = 6;           // segments
constexpr int kMostTechniquePixels = 320'000;  // of each of up to 42 pictures, 24 bytes per pixel

/// A camera that keeps moving lets each position show its first picture, unless that takes longer.
constexpr std::chrono::milliseconds kLongestWaitForPicture{250};

/// Whether they differ in nothing but when to stop.
bool render_the_same(const RenderSettings& a, const RenderSettings& b) {
  const auto picture = [](const RenderSettings& s) {
    return std::tie(s.integrator, s.parameters, s.width, s.height, s.seed, s.threads, s.region);
  };
  return picture(a) == picture(b);
}

bool is_resized(const RenderSettings& a, const RenderSettings& b) {
  return a.width != b.width || a.height != b.height;
}

/// What was changed, as undo names it.
std::string name_of_change(const RenderSettings& a, const RenderSettings& b) {
  if (a.integrator != b.integrator) return "choice of algorithm";
  if (a.parameters != b.parameters) return "integrator parameter";
  if (a.width != b.width || a.height != b.height) return "picture size";
  if (a.region != b.region) return "render region";
  if (a.seed != b.seed) return "seed";
  if (a.threads != b.threads) return "thread count";
  return "render target";
}

}  // namespace

// -- Names and defaults.

bool is_data_layer(Layer layer) {
  return layer == Layer::Depth || layer == Layer::SampleCount || layer == Layer::Variance;
}

std::string scene_title(const std::string& path) {
  const std::filesystem::path file(path);
  const std::string stem = file.stem().string();
  const std::string folder = std::filesystem::absolute(file).parent_path().filename().string();
  return stem.starts_with("scene") && !folder.empty() ? folder : stem;
}

ViewSettings::ViewSettings() {
  for (const Layer data : kAllLayers) {
    if (is_data_layer(data)) {
      display_[static_cast<size_t>(data)].curve = ToneCurve::FalseColor;
    }
  }
  DisplaySettings& normal = display_[static_cast<size_t>(Layer::Normal)];
  normal.curve = ToneCurve::Gamma;
  normal.gamma = 1;
}

std::optional<PixelRegion> ViewSettings::harvested() const {
  if (harvested_region || !inspected_pixel) return harvested_region;
  return PixelRegion{inspected_pixel->x, inspected_pixel->y, inspected_pixel->x + 1,
                     inspected_pixel->y + 1};
}

void ViewSettings::forget_picked() {
  inspected_pixel.reset();
  harvested_region.reset();
}

size_t ViewSettings::slot() const {
  return static_cast<size_t>(is_radiance_layer(layer) ? Layer::Beauty : layer);
}

// -- The scene.

Document::Document(std::function<void()> published) : session_(std::move(published)) {}

void Document::open(OpenedScene opened) {
  opened_ = std::move(opened);
  settings_ = settings_for(scene());
  const auto none = std::make_shared<const std::vector<GuidePath>>();
  guides_as_opened_ = opened_.guides ? opened_.guides : none;
  edits_.reset({guides_as_opened_, settings_});
  ++openings_;
  guide_view_.selected.reset();
  guide_view_.solo.reset();
  take_guides();
  view_.forget_picked();
  range_known_ = {};
  resume_.reset();
  picture_ = nullptr;
  jobs_.clear();
  set_paused(false);
  reset_camera();
  const size_t warnings = scene().description().warnings.size();
  if (warnings > 0) {
    messages_.warning(fmt::format("{} opened with {} warning{}; the scene panel lists them.",
                                  title(), warnings, warnings == 1 ? "" : "s"));
  }
  if (!opened_.guide_problem.empty()) messages_.error(opened_.guide_problem);
}

void Document::reload(OpenedScene opened) {
  const auto before = opened_.scene;
  const CameraController camera = camera_;
  RenderSettings settings = settings_;
  open(std::move(opened));
  const bool same_camera =
      before->camera().description().to_world == scene().camera().description().to_world;
  const bool same_size = before->camera().width() == scene().camera().width() &&
                         before->camera().height() == scene().camera().height();
  if (same_camera) camera_ = camera;
  if (!same_size) {
    settings.width = settings_.width;
    settings.height = settings_.height;
    settings.region.reset();
  }
  settings_ = settings;
  edits_.reset({guides_as_opened_, settings_});
}

RenderSettings Document::settings_for(const Scene& scene) const {
  RenderSettings settings;
  settings.integrator =
      overrides_.integrator.empty() ? integrators().front().name : overrides_.integrator;
  settings.parameters =
      find_integrator(settings.integrator).make_settings(scene.description().hints);
  const bool sized = overrides_.width > 0 && overrides_.height > 0;
  settings.width = sized ? overrides_.width : scene.camera().width();
  settings.height = sized ? overrides_.height : scene.camera().height();
  settings.seed = overrides_.seed;
  settings.threads = overrides_.threads;
  return settings;
}

std::shared_ptr<const Scene> Document::current_scene() const {
  return has_scene() ? scene().with_camera(current_camera()) : nullptr;
}

// -- The camera.

Camera Document::current_camera() const {
  return scene()
      .camera()
      .with_resolution(settings_.width, settings_.height)
      .with_transform(camera_.to_world());
}

void Document::move_camera(const std::function<void(CameraController&)>& move) {
  if (!has_scene()) return;
  camera_.move(move);
  restart();
}

void Document::reset_camera() {
  if (!has_scene()) return;
  const Bounds bounds = scene().bounds();
  const Camera& camera = scene().camera();
  camera_ =
      CameraController(camera, glm::length(bounds.center() - camera.position()), bounds.radius());
  find_pivot();
  restart();
}

void Document::find_pivot() {
  const auto scene = current_scene();
  if (!scene) return;
  if (const auto distance = pivot_distance(*scene)) camera_.set_pivot_distance(*distance);
}

// -- The render.

void Document::set_settings(const RenderSettings& settings) {
  if (render_the_same(settings, settings_) && settings.targets == settings_.targets) return;
  const std::string change = name_of_change(settings_, settings);
  RenderSettings next = settings;
  // A region is of the size that it was drawn in, unless a new one comes with the new size.
  if (is_resized(settings_, next) && next.region == settings_.region) next.region.reset();
  apply_settings(next);
  edits_.commit({guides(), settings_}, change, change);
}

void Document::apply_settings(const RenderSettings& settings) {
  if (render_the_same(settings, settings_)) {
    settings_.targets = settings.targets;
    session_.set_targets(settings.targets);
    return;
  }
  if (is_resized(settings_, settings)) view_.forget_picked();
  settings_ = settings;
  restart();
}

void Document::set_integrator(const std::string& name) {
  RenderSettings changed = settings_;
  changed.integrator = name;
  changed.parameters = find_integrator(name).make_settings(scene().description().hints);
  set_settings(changed);
}

void Document::resume(Checkpoint checkpoint, const std::string& path) {
  resume_ = {std::move(checkpoint), path};
  set_paused(false);
  restart();
}

bool Document::save_checkpoint(const std::string& path,
                               std::function<void(const std::string&)> done) {
  const bool rendering =
      !jobs_.empty() && !restart_pending_ && status_->state != SessionState::Failed;
  if (!rendering) return false;
  session_.save([save = save_to(path, *jobs_.back().job),
                 done = std::move(done)](const RenderProgress& progress) {
    std::string problem;
    try {
      save(progress);
    } catch (const std::exception& error) {
      problem = error.what();
    }
    done(problem);
  });
  return true;
}

void Document::set_paused(bool paused) {
  paused_ = paused;
  if (paused) {
    session_.pause();
  } else {
    session_.resume();
  }
}

void Document::update(Clock::time_point now) {
  messages_.expire(now);
  update_candidates();
  watch_pixels();
  status_ = session_.snapshot();
  const bool of_this_scene = !jobs_.empty() && status_->job >= jobs_.front().number;
  if (of_this_scene && status_->has_picture()) picture_ = status_;
  while (picture_ && jobs_.size() > 1 && jobs_.front().number < picture_->job) {
    jobs_.pop_front();
  }
  if (status_->state == SessionState::Failed && failure_reported_ != status_->job) {
    failure_reported_ = status_->job;
    messages_.error("Rendering failed: " + status_->error);
  }
  if (!range_known_[static_cast<size_t>(view_.layer)]) show_layer(view_.layer);
  const bool answered = jobs_.empty() || status_->job == jobs_.back().number ||
                        now - job_started_ > kLongestWaitForPicture;
  if (restart_pending_ && answered) start(now);
}

void Document::start(Clock::time_point now) {
  RenderJob job;
  job.scene = current_scene();
  job.integrator = settings_.integrator;
  job.settings = settings_.parameters;
  job.seed = settings_.seed;
  job.threads = settings_.threads;
  job.targets = settings_.targets;
  job.region = settings_.region;
  job.guides = followed_guides();
  history_ = std::make_shared<PixelHistory>();
  watched_.clear();
  watch_pixels();
  job.history = history_;
  job.techniques = techniques_ = make_technique_images();
  job.coarse_first = true;
  if (resume_) {
    const auto [checkpoint, path] = *std::exchange(resume_, std::nullopt);
    try {
      job.resume_from = resume_from(checkpoint, job, path);
      job.coarse_first = false;
      messages_.note(fmt::format("Goes on from pass {} of {}", checkpoint.next_pass, path));
    } catch (const std::exception& error) {
      messages_.error(error.what());
    }
  }
  const uint64_t number = session_.start(job);
  job.resume_from.reset();  // the film of a checkpoint is large, and of no more use here
  job.techniques.reset();   // pictures carry none
  job.guides = guides();    // what travels with pictures; solo is a way of looking
  jobs_.push_back({number, std::make_shared<RenderJob>(std::move(job))});
  job_started_ = now;
  restart_pending_ = false;
}

// -- Guide paths.

void Document::edit_guides(std::vector<GuidePath> guides, const std::string& label,
                           const std::string& kind) {
  auto list = std::make_shared<const std::vector<GuidePath>>(std::move(guides));
  edits_.commit({std::move(list), settings_}, label, kind);
  take_guides();
}

void Document::set_solo(std::optional<size_t> guide) {
  guide_view_.solo = guide;
  follow_guides();
}

/// Looks at a changed list and has it followed.
void Document::take_guides() {
  faults_.clear();
  candidates_ = {};
  if (!has_scene()) return;
  for (const GuidePath& guide : *guides()) faults_.push_back(check_guide(scene(), guide));
  const auto drop_missing = [&](std::optional<size_t>& index) {
    if (index && *index >= guides()->size()) index.reset();
  };
  drop_missing(guide_view_.selected);
  drop_missing(guide_view_.solo);
  follow_guides();
}

void Document::follow_guides() {
  session_.set_guides(followed_guides());
  if (!jobs_.empty()) jobs_.back().job->guides = guides();
}

void Document::update_candidates() {
  const auto& selected = guide_view_.selected;
  if (candidates_.of == selected) return;
  candidates_ = {selected, {}};
  if (selected) {
    candidates_.drawn = sample_candidates(opened_.scene, (*guides())[*selected], kCandidates);
  }
}

GuideList Document::followed_guides() const {
  if (!guide_view_.solo) return guides();
  auto alone = *guides();
  for (size_t i = 0; i < alone.size(); ++i) alone[i].enabled = i == *guide_view_.solo;
  return std::make_shared<const std::vector<GuidePath>>(std::move(alone));
}

Bounds Document::bounds_of_selection() const {
  constexpr float kRoom = 0.1f;  // of the size, on each side
  const GuidePath* path = nullptr;
  if (harvest_.selected) path = &harvest_.paths[*harvest_.selected].guide;
  if (guide_view_.selected) path = &(*guides())[*guide_view_.selected];
  Bounds bounds;
  if (path) {
    for (const GuideVertex& vertex : path->vertices) bounds.extend(vertex.position);
  }
  if (bounds.empty() || !(bounds.radius() > 0)) return scene().bounds();
  const Vec3 room(kRoom * bounds.radius());
  return {bounds.lower - room, bounds.upper + room};
}

// -- Photons.

void Document::set_photon_view(const PhotonView& view) {
  photon_view_ = view;
  session_.request_photons(view.shown ? static_cast<size_t>(view.cap) : 0);
}

// -- Techniques.

void Document::record_techniques(bool record) {
  records_techniques_ = record;
  techniques_ = make_technique_images();
  session_.set_techniques(techniques_);
}

/// Of large pictures squares of pixels are kept as one.
std::shared_ptr<TechniqueImages> Document::make_technique_images() const {
  if (!records_techniques_ || !has_scene()) return nullptr;
  if (!find_integrator(settings_.integrator).combines_techniques) return nullptr;
  const double pixels = static_cast<double>(settings_.width) * settings_.height;
  const int block = static_cast<int>(std::ceil(std::sqrt(pixels / kMostTechniquePixels)));
  return std::make_shared<TechniqueImages>(settings_.width, settings_.height, kLongestTechnique,
                                           block);
}

void Document::between_passes(std::function<void()> act) {
  session_.save([act = std::move(act)](const RenderProgress&) { act(); });
}

// -- What is recorded of single pixels.

void Document::watch_pixels() {
  std::vector<PixelHistory::Pixel> watched;
  for (const auto& pixel : {view_.inspected_pixel, view_.hovered_pixel}) {
    if (!pixel || (!watched.empty() && view_.inspected_pixel == pixel)) continue;
    watched.push_back({pixel->x, pixel->y});
  }
  if (watched == watched_) return;
  watched_ = watched;
  history_->watch(watched);
}

std::vector<PixelHistory::Entry> Document::pixel_history(glm::ivec2 pixel) const {
  return history_->of({pixel.x, pixel.y});
}

// -- Undo.

void Document::undo() {
  const std::string label = edits_.undo_label();
  const GuideList before = guides();
  if (!edits_.undo()) return;
  take_edits(*before);
  messages_.note("Undid: " + label);
}

void Document::redo() {
  const std::string label = edits_.redo_label();
  const GuideList before = guides();
  if (!edits_.redo()) return;
  take_edits(*before);
  messages_.note("Did again: " + label);
}

/// Makes the state that undo or redo came to the one that is shown.
void Document::take_edits(const std::vector<GuidePath>& guides_before) {
  apply_settings(edits_.state().settings);
  find_again(guides_before);
  take_guides();
}

/// What was selected in another list, in the one of now.
void Document::find_again(const std::vector<GuidePath>& before) {
  const std::vector<GuidePath>& now = *guides();
  if (before.size() == now.size()) return;
  const auto find = [&](std::optional<size_t>& index) {
    if (!index) return;
    const std::string wanted = guides_text({before[*index]});
    const auto found =
        std::ranges::find(now, wanted, [](const GuidePath& guide) { return guides_text({guide}); });
    index.reset();
    if (found != now.end()) index = found - now.begin();
  };
  find(guide_view_.selected);
  find(guide_view_.solo);
}

// -- The look of the picture.

void Document::step_layer(int step) {
  const int next = (static_cast<int>(view_.layer) + step + kLayerCount) % kLayerCount;
  show_layer(static_cast<Layer>(next));
}

void Document::step_exposure(float step) {
  float& exposure = view_.current().exposure;
  exposure = std::clamp(exposure + step, -kLargestExposure, kLargestExposure);
}

void Document::show_layer(Layer layer) {
  view_.layer = layer;
  bool& known = range_known_[static_cast<size_t>(layer)];
  if (known) return;
  if (!is_data_layer(layer)) {
    known = true;
  } else if (picture_ && !picture_->coarse) {
    normalise();
    known = true;
  }
}

void Document::normalise() {
  if (!picture_) return;
  const Image& image = picture_->layer(view_.layer);
  DisplaySettings& display = view_.current();
  if (display.curve == ToneCurve::FalseColor) {
    const auto [low, high] = value_range(image);
    const float gain = std::exp2(display.exposure);
    display.false_color_min = low * gain;
    display.false_color_max = high * gain;
  } else {
    display.exposure = auto_exposure(image);
  }
}

}  // namespace guidelight
