#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <string>

namespace guidelight {

/// Sentences for the person at the window: what went wrong, what was written where.
class Messages {
 public:
  using Clock = std::chrono::steady_clock;
  enum class Kind { Note, Warning, Error };
  /// What a person may do about it, as a button.
  struct Offer {
    std::string label;
    std::function<void()> act;
  };
  struct Message {
    Kind kind;
    std::string text;
    Offer offer;  // without a label for none
    Clock::time_point posted;
    uint64_t id;
  };

  void note(std::string text, Offer offer = {}) {
    add(Kind::Note, std::move(text), std::move(offer));
  }
  void warning(std::string text) { add(Kind::Warning, std::move(text), {}); }
  void error(std::string text) { add(Kind::Error, std::move(text), {}); }

  /// Oldest first.
  const std::deque<Message>& shown() const { return messages_; }
  void dismiss(uint64_t id);
  /// Drops what has been shown long enough: notes after 6 s, those with an offer and the others
  /// after 20 s.
  void expire(Clock::time_point now);

 private:
  void add(Kind kind, std::string text, Offer offer);

  std::deque<Message> messages_;
  uint64_t next_id_ = 1;
};

}  // namespace guidelight
