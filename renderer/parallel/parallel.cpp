#include "renderer/parallel/parallel.h"

#include <immintrin.h>
#include <sys/resource.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>

#include <atomic>
#include <condition_variable>
#include <mutex>

#include "renderer/parallel/worker_counter.h"

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace guidelight {

struct WorkControl::State {
  std::mutex mutex;
  std::condition_variable changed;
  std::atomic<bool> stop{false};
  std::atomic<bool> paused{false};
};

WorkControl::WorkControl() : state_(std::make_unique<State>()) {}
WorkControl::~WorkControl() = default;

void WorkControl::request_stop() {
  const std::lock_guard lock(state_->mutex);
  state_->stop = true;
  state_->changed.notify_all();
}

bool WorkControl::stop_requested() const { return state_->stop; }

void WorkControl::set_paused(bool paused) {
  const std::lock_guard lock(state_->mutex);
  state_->paused = paused;
  state_->changed.notify_all();
}

bool WorkControl::may_continue() {
  if (state_->paused && !state_->stop) {
    std::unique_lock lock(state_->mutex);
    state_->changed.wait(lock, [&] { return !state_->paused || state_->stop; });
  }
  return !state_->stop;
}

namespace {

/// Flushes denormals for one piece of work and puts the caller's floating-point mode back.
class DenormalsFlushed {
 public:
  DenormalsFlushed() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | 0x8040); }  // FTZ | DAZ
  ~DenormalsFlushed() { _mm_setcsr(saved_); }
  DenormalsFlushed(const DenormalsFlushed&) = delete;
  DenormalsFlushed& operator=(const DenormalsFlushed&) = delete;

 private:
  unsigned saved_;
};

/// Tells the thread sanitizer that a loop hands the caller's memory to its pieces of work, and
/// theirs back to the caller. oneTBB sees to that, but Debian's is not instrumented. Does nothing
/// in other builds.
class LoopHandOver {
 public:
  LoopHandOver() { release(&begin_); }
  ~LoopHandOver() { acquire(&end_); }
  LoopHandOver(const LoopHandOver&) = delete;
  LoopHandOver& operator=(const LoopHandOver&) = delete;

  void piece_begins() { acquire(&begin_); }
  void piece_ends() { release(&end_); }

 private:
#ifdef __SANITIZE_THREAD__
  static void acquire(void* key) { __tsan_acquire(key); }
  static void release(void* key) { __tsan_release(key); }
#else
  static void acquire(void*) {}
  static void release(void*) {}
#endif
  char begin_ = 0;  // only their addresses matter
  char end_ = 0;
};

/// Lowers the priority of every thread that enters the arena. On Linux a nice value belongs to a
/// thread.
class BackgroundPriority : public tbb::task_scheduler_observer {
 public:
  explicit BackgroundPriority(tbb::task_arena& arena) : tbb::task_scheduler_observer(arena) {
    observe(true);
  }
  ~BackgroundPriority() override { observe(false); }
  void on_scheduler_entry(bool) override { setpriority(PRIO_PROCESS, 0, 10); }
};

}  // namespace

struct Parallel::Arena {
  tbb::task_arena tasks;
  std::unique_ptr<BackgroundPriority> background;
};

Parallel::Parallel(int threads, WorkControl* control, Priority priority)
    : arena_(std::make_unique<Arena>()), control_(control) {
  arena_->tasks.initialize(threads > 0 ? threads : tbb::task_arena::automatic);
  if (priority == Priority::Background) {
    arena_->background = std::make_unique<BackgroundPriority>(arena_->tasks);
  }
}

Parallel::~Parallel() = default;

int Parallel::threads() const { return arena_->tasks.max_concurrency(); }

void Parallel::for_each(size_t count, const std::function<void(size_t)>& body) {
  LoopHandOver hand_over;
  arena_->tasks.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<size_t>(0, count, 1),
        [&](const tbb::blocked_range<size_t>& range) {
          for (size_t i = range.begin(); i < range.end(); ++i) {
            if (control_ && !control_->may_continue()) throw Stopped();
            const DenormalsFlushed flushed;
            const WorkerCounter::Place place(tbb::this_task_arena::current_thread_index());
            hand_over.piece_begins();
            body(i);
            hand_over.piece_ends();
          }
        },
        tbb::simple_partitioner());
  });
}

}  // namespace guidelight
