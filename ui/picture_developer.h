#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "renderer/image/tonemap.h"
#include "renderer/session/render_session.h"
#include "ui/histogram.h"
#include "ui/ui_queue.h"

namespace guidelight {

/// A picture ready for the screen, and what it was made of.
struct Picture {
  std::shared_ptr<const Snapshot> snapshot;
  std::shared_ptr<const RenderJob> job;  // that the snapshot is of
  Layer layer = Layer::Beauty;
  DisplaySettings display;
  DisplayImage image;
  Histogram histogram;  // of the layer's linear values
};

/// The layer as displayed: normals are shown as ½ + ½n, everything else as it is.
void develop_picture(const Snapshot& snapshot, Layer layer, const DisplaySettings& display,
                     DisplayImage& out);

/// Makes pictures in a thread of its own, so that tone mapping never holds up the window.
class PictureDeveloper {
 public:
  /// `developed`, and `failed` with the reason, are called on the UI thread.
  PictureDeveloper(UiQueue& queue, std::function<void(std::shared_ptr<const Picture>)> developed,
                   std::function<void(const std::string&)> failed);
  ~PictureDeveloper();
  PictureDeveloper(const PictureDeveloper&) = delete;
  PictureDeveloper& operator=(const PictureDeveloper&) = delete;

  /// Asks for a picture unless the last one asked for is the same. A newer request replaces an
  /// older one that has not been begun.
  void request(std::shared_ptr<const Snapshot> snapshot, std::shared_ptr<const RenderJob> job,
               Layer layer, const DisplaySettings& display);

 private:
  struct Request {
    std::shared_ptr<const Snapshot> snapshot;
    std::shared_ptr<const RenderJob> job;
    Layer layer;
    DisplaySettings display;
    bool operator==(const Request& other) const;
  };
  void work();
  void develop(const Request& request);

  UiQueue& queue_;
  std::function<void(std::shared_ptr<const Picture>)> developed_;
  std::function<void(const std::string&)> failed_;
  std::optional<Request> last_;  // UI thread only
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Request> next_;
  bool ending_ = false;
  std::thread thread_;  // last: it uses all the others
};

}  // namespace guidelight
