#pragma once

#include <chrono>
#include <deque>
#include <string>

namespace guidelight {

/// Sentences for the person at the window: what went wrong, what was written where.
class Messages {
 public:
  using Clock = std::chrono::steady_clock;
  enum class Kind { Note, Warning, Error };
  struct Message {
    Kind kind;
    std::string text;
    Clock::time_point posted;
    uint64_t id;
  };

  void note(std::string text) { add(Kind::Note, std::move(text)); }
  void warning(std::string text) { add(Kind::Warning, std::move(text)); }
  void error(std::string text) { add(Kind::Error, std::move(text)); }

  /// Oldest first.
  const std::deque<Message>& shown() const { return messages_; }
  void dismiss(uint64_t id);
  /// Drops what has been shown long enough: notes after 6 s, the others after 20 s.
  void expire(Clock::time_point now);

 private:
  void add(Kind kind, std::string text);

  std::deque<Message> messages_;
  uint64_t next_id_ = 1;
};

}  // namespace guidelight
