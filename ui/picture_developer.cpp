#include "ui/picture_developer.h"

#include <exception>
#include <new>

namespace guidelight {
namespace {

Image encode_normals(const Image& normals) {
  Image encoded = normals;
  for (float& value : encoded.data()) value = 0.5f + 0.5f * value;
  return encoded;
}

}  // namespace

void develop_picture(const Snapshot& snapshot, Layer layer, const DisplaySettings& display,
                     DisplayImage& out) {
  const Image& image = snapshot.layer(layer);
  display_image(layer == Layer::Normal ? encode_normals(image) : image, display, out);
}

PictureDeveloper::PictureDeveloper(UiQueue& queue,
                                   std::function<void(std::shared_ptr<const Picture>)> developed,
                                   std::function<void(const std::string&)> failed)
    : queue_(queue),
      developed_(std::move(developed)),
      failed_(std::move(failed)),
      thread_([this] { work(); }) {}

PictureDeveloper::~PictureDeveloper() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

bool PictureDeveloper::Request::operator==(const Request& other) const {
  return snapshot->layers == other.snapshot->layers && layer == other.layer &&
         display == other.display;
}

void PictureDeveloper::request(std::shared_ptr<const Snapshot> snapshot,
                               std::shared_ptr<const RenderJob> job, Layer layer,
                               const DisplaySettings& display) {
  Request wanted{std::move(snapshot), std::move(job), layer, display};
  if (last_ && *last_ == wanted) return;
  last_ = wanted;
  {
    const std::lock_guard lock(mutex_);
    next_ = std::move(wanted);
  }
  changed_.notify_one();
}

void PictureDeveloper::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return ending_ || next_; });
    if (ending_) return;
    const Request request = std::move(*next_);
    next_.reset();
    lock.unlock();

    try {
      develop(request);
    } catch (const std::bad_alloc&) {
      queue_.post([this] { failed_("there is not enough memory"); });
    } catch (const std::exception& error) {
      queue_.post([this, reason = std::string(error.what())] { failed_(reason); });
    }

    lock.lock();
  }
}

void PictureDeveloper::develop(const Request& request) {
  auto picture = std::make_shared<Picture>();
  picture->snapshot = request.snapshot;
  picture->job = request.job;
  picture->layer = request.layer;
  picture->display = request.display;
  develop_picture(*request.snapshot, request.layer, request.display, picture->image);
  picture->histogram = make_histogram(request.snapshot->layer(request.layer));
  queue_.post([this, picture = std::move(picture)] { developed_(picture); });
}

}  // namespace guidelight
