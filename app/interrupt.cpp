#include "app/interrupt.h"

#include <time.h>

#include <atomic>
#include <csignal>

namespace guidelight {

namespace {

// A signal handler can reach nothing but globals.
volatile std::sig_atomic_t g_interrupted = 0;
std::atomic<int64_t> g_interrupted_at = 0;  // [ms]

int64_t now_in_ms() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1000000;
}

/// One key or command may send a signal twice, to the process and to its group. A second one that
/// comes later means it.
void on_signal(int signal) {
  constexpr int64_t kAtOnce = 500;  // [ms]
  if (!g_interrupted) {
    g_interrupted_at = now_in_ms();
    g_interrupted = 1;
  } else if (now_in_ms() - g_interrupted_at > kAtOnce) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

InterruptGuard::InterruptGuard() {
  g_interrupted = 0;
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool InterruptGuard::interrupted() const { return g_interrupted != 0; }

}  // namespace guidelight
