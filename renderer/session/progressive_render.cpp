#include "renderer/session/progressive_render.h"

#include <algorithm>

#include "renderer/error.h"
#include "renderer/image/technique_images.h"
#include "renderer/parallel/worker_counter.h"
#include "renderer/session/stopwatch.h"
#include "renderer/transport/guide_mixture.h"

namespace guidelight {

namespace {

/// Publishing takes at most this share of the time once a render is under way …
constexpr double kPublishShare = 0.02;
/// … but nobody waits longer than this for a new picture, and less at the beginning [s].
double longest_silence(double seconds_rendered) {
  return std::clamp(0.25 * seconds_rendered, 0.1, 1.0);
}

/// The error estimate of fewer passes says too little to stop by.
constexpr uint32_t kFewestPassesForError = 16;

class ProgressiveRender {
 public:
  ProgressiveRender(const RenderJob& job, WorkControl& control, RenderObserver& observer)
      : job_(job),
        info_(find_integrator(job.integrator)),
        settings_(job.settings ? job.settings->clone()
                               : info_.make_settings(job.scene->description().hints)),
        parallel_(job.threads, &control, job.priority),
        rays_(parallel_.threads()),
        scene_(job.scene->with_ray_counter(rays_)),
        observer_(observer) {
    status_.full_width = job.scene->camera().width();
    status_.full_height = job.scene->camera().height();
  }

  [[noreturn]] void run() {
    const Camera& camera = job_.scene->camera();
    auto film = std::make_shared<Film>(camera.width(), camera.height(), camera.film().filter);
    const uint32_t first_pass = resume(*film);
    try {
      if (job_.coarse_first) show_coarse_pictures();
    } catch (const Stopped&) {
      save_on_request(film, first_pass);
      throw;
    }
    status_.passes = first_pass;
    const auto integrator = info_.create(scene_, *settings_);
    PassContext context{.seed = job_.seed,
                        .parallel = &parallel_,
                        .region = job_.region,
                        .history = job_.history.get()};
    if (first_pass > 0 && target_reached(*film)) {
      show(*film, SessionState::Finished);
      rest_until_there_is_more_to_do(film, first_pass);
    }
    for (uint32_t pass = first_pass;; ++pass) {
      follow_guides(observer_.guides(), context);
      const std::shared_ptr<TechniqueImages> techniques = observer_.techniques();
      context.techniques = techniques.get();
      const size_t photons_wanted = observer_.photons_wanted();
      PhotonRequest photons(photons_wanted);
      context.photons = photons_wanted > 0 ? &photons : nullptr;
      try {
        integrator->render_pass(pass, *film, context);
      } catch (const Stopped&) {
        // The part of the pass that is in the film must not be rendered again with the same
        // numbers.
        save_on_request(film, pass + 1);
        if (observer_.wants_unfinished()) {
          show(*film, SessionState::Idle);
          save(film, pass + 1);
        }
        throw;
      }
      film->finish_pass();
      if (techniques) techniques->finish_pass();
      status_.photons =
          context.photons ? std::make_shared<PhotonCloud>(std::move(photons.cloud())) : nullptr;
      status_.chains = integrator->chain_statistics();
      status_.passes = pass + 1;
      const bool finished = target_reached(*film);
      if (finished || pass == first_pass || publishing_is_due()) {
        show(*film, finished ? SessionState::Finished : SessionState::Rendering);
      }
      if (finished || since_saved_.seconds() >= job_.save_interval) save(film, pass + 1);
      save_on_request(film, pass + 1);
      if (finished) rest_until_there_is_more_to_do(film, pass + 1);
    }
  }

 private:
  /// Takes over the progress of an earlier render; returns the pass to go on with.
  uint32_t resume(Film& film) {
    if (!job_.resume_from) return 0;
    film.merge(*job_.resume_from->film);
    return job_.resume_from->next_pass;
  }

  /// Prepares guides that are not those of the last pass.
  void follow_guides(const GuideList& guides, PassContext& context) {
    if (guides == guides_) return;
    guides_ = guides;
    context.guides = guides ? GuideMixture::build(scene_, *guides) : nullptr;
  }

  void save(const std::shared_ptr<const Film>& film, uint32_t next_pass) {
    if (!job_.save) return;
    job_.save({film, next_pass, seconds()});
    since_saved_.restart();
  }

  void save_on_request(const std::shared_ptr<const Film>& film, uint32_t next_pass) {
    for (const SaveProgress& wanted : observer_.take_save_requests()) {
      wanted({film, next_pass, seconds()});
    }
  }

  void rest_until_there_is_more_to_do(const std::shared_ptr<const Film>& film, uint32_t next_pass) {
    do {
      observer_.rest();
      save_on_request(film, next_pass);
    } while (target_reached(*film));
    show(*film, SessionState::Rendering);
  }

  double seconds() const {
    return observer_.seconds() + (job_.resume_from ? job_.resume_from->seconds : 0.0);
  }

  /// Pictures of 1/8, 1/4 and 1/2 of the size, one sample per pixel: something to see at once.
  void show_coarse_pictures() {
    const Camera& camera = job_.scene->camera();
    const PassContext context{job_.seed, &parallel_, std::nullopt};
    status_.coarse = true;
    for (int divisor = 8; divisor > 1; divisor /= 2) {
      const int width = std::max(1, camera.width() / divisor);
      const int height = std::max(1, camera.height() / divisor);
      const auto scene = job_.scene->with_camera(camera.with_resolution(width, height));
      Film film(width, height, camera.film().filter);
      info_.create(scene, *settings_)->render_pass(0, film, context);
      show(film, SessionState::Rendering);
    }
    status_.coarse = false;
  }

  /// Also sets the progress towards the nearest target.
  bool target_reached(const Film& film) {
    const RenderTargets targets = observer_.targets();
    double progress = 0;
    if (targets.passes > 0) progress = static_cast<double>(status_.passes) / targets.passes;
    if (targets.seconds > 0) progress = std::max(progress, seconds() / targets.seconds);
    if (targets.relative_error > 0 && status_.passes >= kFewestPassesForError) {
      // The error falls with the square root of the work, so the work done goes with its square.
      const double error = film.estimated_relative_error();
      progress = std::max(progress, error > 0 ? sqr(targets.relative_error / error) : 1.0);
    }
    status_.progress = static_cast<float>(std::min(progress, 1.0));
    return progress >= 1;
  }

  bool publishing_is_due() const {
    const double silence = since_published_.seconds();
    return silence * kPublishShare >= publish_cost_ ||
           silence >= longest_silence(observer_.seconds());
  }

  void show(const Film& film, SessionState state) {
    const Stopwatch publishing;
    status_.layers = develop(film);
    status_.state = state;
    status_.seconds = seconds();
    const double spent = observer_.seconds();  // without those of a checkpoint
    status_.rays_per_second = spent > 0 ? static_cast<double>(rays_.total()) / spent : 0;
    status_.samples = film.total_samples();
    status_.rejected_samples = film.rejected();
    status_.relative_error = film.estimated_relative_error();
    observer_.publish(status_);
    publish_cost_ = publishing.seconds();
    since_published_.restart();
  }

  /// All layers, in bands of rows over all threads. Not through parallel_, whose loops end when the
  /// job is to stop.
  std::shared_ptr<const Snapshot::Layers> develop(const Film& film) const {
    constexpr int kBand = 64;  // rows
    auto layers = std::make_shared<Snapshot::Layers>();
    for (const Layer layer : kAllLayers) {
      (*layers)[static_cast<size_t>(layer)] =
          Image(film.width(), film.height(), layer_channels(layer));
    }
    Parallel(job_.threads, nullptr, job_.priority)
        .for_each((film.height() + kBand - 1) / kBand, [&](size_t band) {
          const int y0 = static_cast<int>(band) * kBand;
          const int y1 = std::min(y0 + kBand, film.height());
          for (const Layer layer : kAllLayers) {
            film.develop_rows(layer, y0, y1, (*layers)[static_cast<size_t>(layer)]);
          }
        });
    return layers;
  }

  const RenderJob& job_;
  const IntegratorInfo& info_;
  std::unique_ptr<IntegratorSettings> settings_;
  Parallel parallel_;
  WorkerCounter rays_;
  std::shared_ptr<const Scene> scene_;  // the job's, counting its rays
  RenderObserver& observer_;
  Snapshot status_;
  GuideList guides_;
  Stopwatch since_published_;
  Stopwatch since_saved_;
  double publish_cost_ = 0;  // of the last time [s]
};

}  // namespace

void render_progressively(const RenderJob& job, WorkControl& control, RenderObserver& observer) {
  if (!job.scene) throw Error("there is no scene to render: open one first");
  ProgressiveRender(job, control, observer).run();
}

}  // namespace guidelight
