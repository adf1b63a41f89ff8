#include "ui/scene_loader.h"

#include <fmt/format.h>

#include <filesystem>
#include <thread>

#include "renderer/error.h"
#include "renderer/io/guide_file.h"
#include "renderer/session/open_scene.h"

namespace guidelight {
namespace {

OpenedScene read_and_build(const std::string& path,
                           const std::map<std::string, std::string>& defines) {
  const std::string absolute = std::filesystem::absolute(path).lexically_normal().string();
  OpenedScene opened{absolute, defines, Scene::build(open_scene(absolute, defines)), {}, {}};
  const std::string guide_file = guide_file_beside(absolute);
  if (!std::filesystem::exists(guide_file)) return opened;
  try {
    opened.guides = std::make_shared<const std::vector<GuidePath>>(read_guides(guide_file));
  } catch (const std::exception& error) {
    opened.guide_problem = error.what();
  }
  return opened;
}

}  // namespace

SceneLoader::SceneLoader(std::shared_ptr<UiQueue> queue, std::function<void(OpenedScene)> opened,
                         std::function<void(std::string)> failed)
    : queue_(std::move(queue)), opened_(std::move(opened)), failed_(std::move(failed)) {}

void SceneLoader::load(const std::string& path, const std::map<std::string, std::string>& defines) {
  loading_ = path;
  const uint64_t request = ++newest_request_;
  ++*running_;
  std::thread([this, path, defines, request, queue = queue_, running = running_] {
    // `this` is only used on the UI thread, which drops what is posted once the loader is gone.
    const auto fail = [&](const std::string& reason) {
      queue->post([this, request, reason] { finish(request, [&] { failed_(reason); }); });
    };
    try {
      queue->post([this, request, scene = read_and_build(path, defines)] {
        finish(request, [&] { opened_(scene); });
      });
    } catch (const std::bad_alloc&) {
      fail(fmt::format("{} needs more memory than there is: close other programs or simplify it",
                       path));
    } catch (const std::exception& error) {
      fail(error.what());
    }
    --*running;
  }).detach();
}

void SceneLoader::forget() {
  ++newest_request_;
  loading_.clear();
}

void SceneLoader::finish(uint64_t request, const std::function<void()>& deliver) {
  if (request != newest_request_) return;
  loading_.clear();
  deliver();
}

}  // namespace guidelight
