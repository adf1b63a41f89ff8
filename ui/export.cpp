#include "ui/export.h"

#include <fmt/format.h>

#include <filesystem>

#include "renderer/io/image_file.h"
#include "ui/session_metadata.h"

namespace guidelight {
namespace {

namespace fs = std::filesystem;

Metadata describe_display(const Picture& picture) {
  return {{"layer", layer_name(picture.layer)},
          {"exposure", fmt::format("{:.3f}", picture.display.exposure)}};
}

}  // namespace

Exporter::Exporter(Document& document, UiQueue& queue, std::string folder)
    : document_(document), queue_(queue), folder_(std::move(folder)) {}

void Exporter::save_png(std::shared_ptr<const Picture> picture) {
  if (!picture || !document_.picture()) {
    document_.messages().warning("There is no picture to save yet.");
    return;
  }
  Metadata metadata = describe_picture(document_.picture_record(), *picture->snapshot);
  metadata.merge(describe_display(*picture));
  write(next_path("", "png"), [picture, metadata](const std::string& path) {
    write_png(path, picture->image, metadata);
  });
}

void Exporter::save_exr(bool half_precision) {
  const auto picture = document_.picture();
  if (!picture) {
    document_.messages().warning("There is no picture to export yet.");
    return;
  }
  Metadata metadata = describe_picture(document_.picture_record(), *picture);
  write(next_path("", "exr"), [picture, metadata, half_precision](const std::string& path) {
    ImageLayers layers;
    layers.metadata = metadata;
    for (const Layer layer : kAllLayers) {
      layers.layers.emplace_back(layer_name(layer), picture->layer(layer));
    }
    write_exr(path, layers, half_precision);
  });
}

void Exporter::save_window(DisplayImage window) {
  Metadata metadata;
  if (document_.picture()) {
    metadata = describe_picture(document_.picture_record(), *document_.picture());
  }
  write(next_path("-window", "png"),
        [window = std::move(window), metadata](const std::string& path) {
          write_png(path, window, metadata);
        });
}

void Exporter::write(const std::string& path, std::function<void(const std::string&)> writer) {
  thread_.run([this, path, writer = std::move(writer)] {
    try {
      writer(path);
      queue_.post([this, path] { document_.messages().note("Wrote " + path); });
    } catch (const std::exception& error) {
      queue_.post([this, text = std::string(error.what())] { document_.messages().error(text); });
    }
  });
}

/// "box.png", "box-2.png" …: the first that is neither on disk nor about to be.
std::string Exporter::next_path(const std::string& kind, const std::string& extension) {
  const std::string stem = (document_.has_scene() ? document_.title() : "guidelight") + kind;
  std::error_code ignored;  // a folder that cannot be read is reported when it is written to
  for (int number = 1;; ++number) {
    const std::string name = number == 1 ? stem : fmt::format("{}-{}", stem, number);
    const std::string path = (fs::path(folder_) / (name + "." + extension)).string();
    if (!fs::exists(path, ignored) && claimed_.insert(path).second) return path;
  }
}

}  // namespace guidelight
