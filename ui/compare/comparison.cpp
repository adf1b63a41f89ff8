#include "ui/compare/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "renderer/io/image_file.h"
#include "ui/format.h"

namespace guidelight {
namespace {

constexpr std::chrono::milliseconds kBetweenMeasurements{250};

std::shared_ptr<const DisplayImage> develop_image(const Image& image,
                                                  const DisplaySettings& display) {
  auto developed = std::make_shared<DisplayImage>();
  display_image(image, display, *developed);
  return developed;
}

std::shared_ptr<const DisplayImage> develop_errors(const Image& image, const Image& other) {
  DisplaySettings display;
  display.curve = ToneCurve::FalseColor;
  display.color_map = Comparison::kErrorColors;
  display.false_color_min = Comparison::kSmallestErrorShown;
  display.false_color_max = Comparison::kLargestErrorShown;
  return develop_image(relative_error_map(image, other), display);
}

bool same_size(const Image& a, const Image& b) {
  return a.width() == b.width() && a.height() == b.height();
}

}  // namespace

void ErrorCurve::add(const Point& point) {
  constexpr size_t kMostPoints = 4000;  // of a line that is drawn at once
  points.push_back(point);
  if (points.size() < kMostPoints) return;
  size_t kept = 0;
  for (size_t i = 0; i < points.size(); i += 2) points[kept++] = points[i];
  points.resize(kept);
}

std::optional<ErrorCurve::Point> ErrorCurve::at(double seconds) const {
  const auto after = std::ranges::lower_bound(points, seconds, {}, &Point::seconds);
  if (after == points.end()) return std::nullopt;
  if (after->seconds == seconds) return *after;
  if (after == points.begin()) return std::nullopt;
  const Point& a = *(after - 1);
  const Point& b = *after;
  const double share = (seconds - a.seconds) / (b.seconds - a.seconds);
  return Point{seconds, std::lerp(a.relative_mse, b.relative_mse, share),
               std::lerp(a.rms, b.rms, share)};
}

void Comparison::load_reference(const std::string& path) {
  worker_.run([this, path] {
    try {
      auto image = std::make_shared<const Image>(read_image(path));
      queue_.post([this, path, image = std::move(image)] {
        reference_ = {std::filesystem::path(path).filename().string(), image};
        against_ = Against::Reference;
        curve_ = {};
        pinned_curve_ = {};
        if (document_.picture() && !same_size(*image, document_.picture()->layer(Layer::Beauty))) {
          document_.messages().warning(fmt::format(
              "{} has {} × {} pixels; it can only be compared with a picture of that size.",
              reference_.name, image->width(), image->height()));
        }
      });
    } catch (const std::exception& error) {
      queue_.post([this, text = sentence_about(error, "Cannot read '" + path + "'")] {
        document_.messages().error(text);
      });
    }
  });
}

void Comparison::pin() {
  const auto& picture = document_.picture();
  if (!picture || picture->coarse) {
    document_.messages().warning("There is no picture of the full size to pin yet.");
    return;
  }
  const std::string name =
      fmt::format("{}, {}", find_integrator(document_.picture_job().integrator).label,
                  format_duration(picture->seconds));
  pinned_ = {name, std::make_shared<const Image>(picture->layer(Layer::Beauty))};
  pinned_curve_ = curve_;
  pinned_curve_.name = name;
  if (!reference_.image) against_ = Against::Pinned;
  document_.messages().note("Pinned " + name);
}

bool Comparison::fits() const {
  const Image* image = other().image.get();
  const RenderSettings& settings = document_.settings();
  return image && image->width() == settings.width && image->height() == settings.height;
}

void Comparison::forget() {
  reference_ = pinned_ = {};
  curve_ = pinned_curve_ = {};
  forget_errors();
  mode = Mode::Off;
}

void Comparison::forget_errors() {
  metrics_.reset();
  error_displayed_.reset();
}

void Comparison::update(Document::Clock::time_point now) {
  develop_other();
  const auto& picture = document_.picture();
  if (!picture || picture->coarse || !other().image) return;
  if (!same_size(picture->layer(Layer::Beauty), *other().image)) {
    forget_errors();
    return;
  }
  if (picture->job != curve_job_ || curve_reference_ != reference_.image) {
    curve_job_ = picture->job;
    curve_reference_ = reference_.image;
    curve_ = {find_integrator(document_.picture_job().integrator).label, {}};
  }
  const bool fresh =
      picture->generation != measured_generation_ || measured_other_ != other().image;
  if (busy_ || !fresh || now - measured_at_ < kBetweenMeasurements) return;
  measured_generation_ = picture->generation;
  measured_other_ = other().image;
  measured_at_ = now;
  measure(picture);
}

void Comparison::measure(std::shared_ptr<const Snapshot> snapshot) {
  busy_ = true;
  const auto measure = [this, snapshot, other = other().image, reference = reference_.image] {
    const Image& image = snapshot->layer(Layer::Beauty);
    const ImageMetrics metrics = compare_images(image, *other);
    const auto errors = develop_errors(image, *other);
    queue_.post([=, this] {
      busy_ = false;
      metrics_ = metrics;
      error_displayed_ = errors;
      if (other != reference || snapshot->job != curve_job_) return;
      curve_.add({snapshot->seconds, metrics.relative_mse.plain, metrics.rms_relative_error.plain});
    });
  };
  worker_.run(measure, [this](const std::string& reason) {
    queue_.post([this, reason] {
      busy_ = false;
      cannot_compare(reason);
    });
  });
}

void Comparison::develop_other() {
  const Developed wanted{other().image, document_.view().current()};
  if (wanted == developed_) return;
  developed_ = wanted;
  if (!wanted.image) {
    other_displayed_ = nullptr;
    return;
  }
  const auto develop = [this, wanted] {
    queue_.post([this, wanted, image = develop_image(*wanted.image, wanted.display)] {
      if (wanted == developed_) other_displayed_ = image;
    });
  };
  worker_.run(develop, [this](const std::string& reason) {
    queue_.post([this, reason] { cannot_compare(reason); });
  });
}

void Comparison::cannot_compare(const std::string& reason) {
  document_.messages().error("The pictures cannot be compared: " + reason);
}

}  // namespace guidelight
