#include "app/progress_bar.h"

#include <fmt/core.h>
#include <unistd.h>

namespace guidelight {

namespace {

constexpr int kBarWidth = 24;
constexpr double kLineInterval = 5;  // [s]

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  return fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

std::string status_text(const Snapshot& snapshot) {
  const double rate = snapshot.seconds > 0 ? snapshot.samples / snapshot.seconds : 0;
  std::string text =
      fmt::format("{} passes, {}, {:.2f} M paths/s, noise {:.2f} %", snapshot.passes,
                  duration_text(snapshot.seconds), rate * 1e-6, 100 * snapshot.relative_error);
  if (snapshot.progress > 0.01f && snapshot.progress < 1) {
    text += fmt::format(", {} left", duration_text(snapshot.seconds * (1 / snapshot.progress - 1)));
  }
  return text;
}

}  // namespace

ProgressBar::ProgressBar() : is_terminal_(isatty(STDERR_FILENO) != 0) {}

void ProgressBar::show(const Snapshot& snapshot) {
  if (is_terminal_) {
    const int filled = static_cast<int>(kBarWidth * snapshot.progress);
    fmt::print(stderr, "\r\033[K[{}{}] {:3.0f} %  {}", std::string(filled, '#'),
               std::string(kBarWidth - filled, '.'), 100 * snapshot.progress,
               status_text(snapshot));
    std::fflush(stderr);
  } else if (snapshot.seconds >= next_line_ && snapshot.passes > 0) {
    fmt::print(stderr, "{:3.0f} %  {}\n", 100 * snapshot.progress, status_text(snapshot));
    next_line_ = snapshot.seconds + kLineInterval;
  }
}

void ProgressBar::finish(const Snapshot& snapshot) {
  next_line_ = 0;
  show(snapshot);
  if (is_terminal_) fmt::print(stderr, "\n");
}

}  // namespace guidelight
