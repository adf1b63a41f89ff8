#pragma once

#include <functional>
#include <string>

#include "ui/background_thread.h"
#include "ui/document.h"
#include "ui/numbered_files.h"
#include "ui/picture_developer.h"
#include "ui/ui_queue.h"

namespace guidelight {

/// Writes pictures in the background. Each says in the document's messages where it wrote, or why
/// it could not. Files are numbered and never overwrite others. The destructor finishes what was
/// begun.
class Exporter {
 public:
  /// Files go to `folder`.
  Exporter(Document& document, UiQueue& queue, std::string folder);

  /// The picture exactly as the view shows it, at its own size.
  void save_png(std::shared_ptr<const Picture> picture);
  /// All layers, linear.
  void save_exr(bool half_precision);
  /// What was drawn, of a picture or of none: `kind` follows the scene in the name of the file,
  /// "-window".
  void save_drawing(DisplayImage drawing, const Picture* picture, const std::string& kind);

 private:
  void write(const std::string& path, std::function<void(const std::string&)> writer);
  std::string next_path(const std::string& kind, const std::string& extension);

  Document& document_;
  UiQueue& queue_;
  NumberedFiles files_;
  BackgroundThread thread_;
};

}  // namespace guidelight
