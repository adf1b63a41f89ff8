#include "app/progress_bar.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

#include "app/message.h"

namespace guidelight {

namespace {

constexpr int kLongestBar = 24;
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

int terminal_columns() {
  winsize size{};
  const bool is_known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return is_known ? size.ws_col : 80;
}

/// One row of the terminal, which could not be redrawn if it were wrapped: the bar gives way first,
/// then the end of the text.
std::string row_text(const Snapshot& snapshot, size_t columns) {
  std::string text = fmt::format("{:3.0f} %  {}", 100 * snapshot.progress, status_text(snapshot));
  constexpr size_t kFrame = 3;  // "[] "
  const size_t space = columns > text.size() + kFrame ? columns - text.size() - kFrame : 0;
  if (const auto width = std::min<int>(static_cast<int>(space), kLongestBar); width > 0) {
    const int filled = static_cast<int>(static_cast<float>(width) * snapshot.progress);
    text =
        fmt::format("[{}{}] {}", std::string(filled, '#'), std::string(width - filled, '.'), text);
  }
  return text.substr(0, columns);
}

}  // namespace

ProgressBar::ProgressBar() : is_terminal_(isatty(STDERR_FILENO) != 0) {}

void ProgressBar::show(const Snapshot& snapshot) {
  if (is_terminal_) {
    // Some terminals wrap when the last column is written.
    say("\r\033[K{}", row_text(snapshot, static_cast<size_t>(terminal_columns() - 1)));
  } else if (snapshot.seconds >= next_line_ && snapshot.passes > 0) {
    say("{:3.0f} %  {}\n", 100 * snapshot.progress, status_text(snapshot));
    next_line_ = snapshot.seconds + kLineInterval;
  }
}

void ProgressBar::finish(const Snapshot& snapshot) {
  next_line_ = 0;
  show(snapshot);
  if (is_terminal_) say("\n");
}

}  // namespace guidelight
