#pragma once

#include <string>
#include <utility>
#include <vector>

namespace guidelight {

/// States that can be gone back to, each with the name of the step that led to it.
template <class State>
class UndoStack {
 public:
  explicit UndoStack(State first) : states_{{std::move(first), "", ""}} {}

  const State& state() const { return states_[current_].state; }
  /// Forgets all history.
  void reset(State first) {
    states_ = {{std::move(first), "", ""}};
    current_ = 0;
    sealed_ = true;
  }
  /// Steps of the same nonempty `kind` merge into one until seal(), a drag for instance.
  void commit(State next, std::string label, std::string kind = "") {
    states_.resize(current_ + 1);
    const bool merges = !sealed_ && !kind.empty() && kind == states_.back().kind;
    if (merges) {
      states_.back().state = std::move(next);
    } else {
      states_.push_back({std::move(next), std::move(label), std::move(kind)});
      if (states_.size() > kMostStates) states_.erase(states_.begin());
      current_ = states_.size() - 1;
    }
    sealed_ = false;
  }
  void seal() { sealed_ = true; }

  /// Name of the step that would be undone or redone; empty if there is none.
  std::string undo_label() const { return current_ > 0 ? states_[current_].label : ""; }
  std::string redo_label() const {
    return current_ + 1 < states_.size() ? states_[current_ + 1].label : "";
  }
  /// False if there is nothing to undo or redo.
  bool undo() {
    if (current_ == 0) return false;
    --current_;
    seal();
    return true;
  }
  bool redo() {
    if (current_ + 1 == states_.size()) return false;
    ++current_;
    seal();
    return true;
  }

 private:
  static constexpr size_t kMostStates = 500;
  struct Step {
    State state;
    std::string label;
    std::string kind;
  };
  std::vector<Step> states_;
  size_t current_ = 0;
  bool sealed_ = true;
};

}  // namespace guidelight
