#include "ui/messages.h"

#include <algorithm>

namespace guidelight {
namespace {

constexpr size_t kMostShown = 4;

std::chrono::seconds lifetime(const Messages::Message& message) {
  const bool is_brief = message.kind == Messages::Kind::Note && message.offer.label.empty();
  return std::chrono::seconds(is_brief ? 6 : 20);
}

}  // namespace

void Messages::add(Kind kind, std::string text, Offer offer) {
  // The same sentence again is shown anew, not twice.
  std::erase_if(messages_, [&](const Message& message) { return message.text == text; });
  messages_.push_back({kind, std::move(text), std::move(offer), Clock::now(), next_id_++});
  if (messages_.size() > kMostShown) messages_.pop_front();
}

void Messages::dismiss(uint64_t id) {
  std::erase_if(messages_, [id](const Message& message) { return message.id == id; });
}

void Messages::expire(Clock::time_point now) {
  std::erase_if(messages_,
                [now](const Message& message) { return now - message.posted > lifetime(message); });
}

}  // namespace guidelight
