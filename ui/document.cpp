#include "ui/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <tuple>
#include <utility>

#include "ui/histogram.h"

namespace guidelight {
namespace {

/// A camera that keeps moving lets each position show its first picture, unless that takes longer.
constexpr std::chrono::milliseconds kLongestWaitForPicture{250};

/// Whether they differ in nothing but when to stop.
bool render_the_same(const RenderSettings& a, const RenderSettings& b) {
  const auto picture = [](const RenderSettings& s) {
    return std::tie(s.integrator, s.parameters, s.width, s.height, s.seed, s.threads, s.region);
  };
  return picture(a) == picture(b);
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

size_t ViewSettings::slot() const {
  return static_cast<size_t>(is_radiance_layer(layer) ? Layer::Beauty : layer);
}

// -- The scene.

Document::Document(std::function<void()> published) : session_(std::move(published)) {}

void Document::open(OpenedScene opened) {
  opened_ = std::move(opened);
  settings_ = settings_for(scene());
  view_.inspected_pixel.reset();
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
  move(camera_);
  restart();
}

void Document::reset_camera() {
  if (!has_scene()) return;
  const Bounds bounds = scene().bounds();
  const Camera& camera = scene().camera();
  camera_ = CameraController(camera, glm::length(bounds.center() - camera.position()));
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
  if (render_the_same(settings, settings_)) {
    settings_.targets = settings.targets;
    session_.set_targets(settings.targets);
    return;
  }
  const bool resized = settings.width != settings_.width || settings.height != settings_.height;
  settings_ = settings;
  if (resized) {
    settings_.region.reset();
    view_.inspected_pixel.reset();
  }
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
  session_.save([save = save_to(path, jobs_.back().job),
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
  jobs_.push_back({number, std::move(job)});
  job_started_ = now;
  restart_pending_ = false;
}

const RenderJob& Document::picture_job() const { return jobs_.front().job; }

// -- The look of the picture.

void Document::step_layer(int step) {
  const int next = (static_cast<int>(view_.layer) + step + kLayerCount) % kLayerCount;
  show_layer(static_cast<Layer>(next));
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
