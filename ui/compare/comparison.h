#pragma once

#include <memory>
#include <string>
#include <vector>

#include "renderer/image/metrics.h"
#include "ui/background_thread.h"
#include "ui/document.h"
#include "ui/ui_queue.h"

namespace guidelight {

/// A picture to compare with.
struct ComparedImage {
  std::string name;
  std::shared_ptr<const Image> image;  // linear
};

/// The error of a render over its time.
struct ErrorCurve {
  struct Point {
    double seconds;
    double relative_mse;
    double rms;  // of the relative error
  };
  std::string name;
  std::vector<Point> points;

  /// Adds a point; of too many, every other one is dropped.
  void add(const Point& point);
  /// At a time, between the points around it; empty outside of them.
  std::optional<Point> at(double seconds) const;
};

/// Compares the render with another picture: a reference from a file, or one that was pinned.
/// What takes time is done in the background; to be used on the UI thread.
class Comparison {
 public:
  enum class Against { Reference, Pinned };
  enum class Mode { Off, Wipe, ErrorMap };

  // Ends of the logarithmic scale of the map of errors, which are squared and relative.
  static constexpr float kSmallestErrorShown = 1e-4f;
  static constexpr float kLargestErrorShown = 10;
  static constexpr ColorMap kErrorColors = ColorMap::Magma;

  Comparison(Document& document, UiQueue& queue) : document_(document), queue_(queue) {}

  /// Reads a reference in the background; says in the messages if it cannot be read.
  void load_reference(const std::string& path);
  /// Keeps the render as it is now to compare others with it.
  void pin();
  void forget();

  const ComparedImage& reference() const { return reference_; }
  const ComparedImage& pinned() const { return pinned_; }
  Against against() const { return against_; }
  void compare_against(Against against) { against_ = against; }
  /// What is compared against; without image if there is none.
  const ComparedImage& other() const {
    return against_ == Against::Reference ? reference_ : pinned_;
  }
  /// Whether the render has the size of what is compared against.
  bool fits() const;
  Mode mode = Mode::Off;
  float wipe = 0.5f;  // share of the picture's width that shows the other

  /// To be called once per frame: measures new pictures and develops the other.
  void update(Document::Clock::time_point now);

  /// The other picture, or the map of errors, as displayed; null before it is ready.
  std::shared_ptr<const DisplayImage> other_displayed() const { return other_displayed_; }
  std::shared_ptr<const DisplayImage> error_displayed() const { return error_displayed_; }

  /// Of the latest picture that was measured; empty before.
  const std::optional<ImageMetrics>& metrics() const { return metrics_; }
  /// Against the reference: of the present render, and of the one that was pinned.
  const ErrorCurve& curve() const { return curve_; }
  const ErrorCurve& pinned_curve() const { return pinned_curve_; }

 private:
  struct Developed {
    std::shared_ptr<const Image> image;
    DisplaySettings display;
    bool operator==(const Developed&) const = default;
  };

  void forget_errors();
  void develop_other();
  void measure(std::shared_ptr<const Snapshot> snapshot);
  void cannot_compare(const std::string& reason);

  Document& document_;
  UiQueue& queue_;
  ComparedImage reference_;
  ComparedImage pinned_;
  Against against_ = Against::Reference;

  Developed developed_;  // what other_displayed_ is of, or will be
  std::shared_ptr<const DisplayImage> other_displayed_;
  std::shared_ptr<const DisplayImage> error_displayed_;
  std::optional<ImageMetrics> metrics_;
  ErrorCurve curve_;
  ErrorCurve pinned_curve_;
  uint64_t curve_job_ = 0;
  std::shared_ptr<const Image> curve_reference_;
  uint64_t measured_generation_ = 0;
  std::shared_ptr<const Image> measured_other_;
  Document::Clock::time_point measured_at_;
  bool busy_ = false;
  BackgroundThread worker_;  // last: it finishes before the rest goes
};

}  // namespace guidelight
