#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "ui/document.h"
#include "ui/ui_queue.h"

namespace guidelight {

/// Reads and builds scenes in background threads and hands them to the UI thread. The newest
/// request wins: the results of older ones are dropped.
class SceneLoader {
 public:
  /// `opened` and `failed` (with the reason in a sentence) are called on the UI thread.
  SceneLoader(std::shared_ptr<UiQueue> queue, std::function<void(OpenedScene)> opened,
              std::function<void(std::string)> failed);

  /// `defines` override <default> variables of an XML scene.
  void load(const std::string& path, const std::map<std::string, std::string>& defines = {});
  /// Drops what is being loaded.
  void forget();
  /// The newest scene that is being loaded; empty if there is none.
  const std::string& loading() const { return loading_; }
  /// Whether any thread still works, even for a result that nobody wants any more. Reading a scene
  /// cannot be interrupted, so these threads may outlive the loader.
  bool threads_running() const { return *running_ > 0; }

 private:
  void finish(uint64_t request, const std::function<void()>& deliver);

  std::shared_ptr<UiQueue> queue_;
  std::function<void(OpenedScene)> opened_;
  std::function<void(std::string)> failed_;
  std::shared_ptr<std::atomic<int>> running_ = std::make_shared<std::atomic<int>>(0);
  uint64_t newest_request_ = 0;
  std::string loading_;
};

}  // namespace guidelight
