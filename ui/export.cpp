#include "ui/export.h"

#include <fmt/format.h>

#include "renderer/session/picture_export.h"

namespace guidelight {
Exporter::Exporter(Document& document, UiQueue& queue, std::string folder)
    : document_(document), queue_(queue), files_(std::move(folder)) {}

void Exporter::save_png(std::shared_ptr<const Picture> picture) {
  if (!picture) {
    document_.messages().warning("There is no picture to save yet.");
    return;
  }
  Metadata metadata = describe_render(*picture->job, *picture->snapshot);
  metadata["layer"] = layer_name(picture->layer);
  metadata["exposure"] = fmt::format("{}", picture->display.exposure);
  write(next_path("", "png"), [picture, metadata](const std::string& path) {
    write_png(path, picture->image, metadata);
  });
}

void Exporter::save_exr(bool half_precision) {
  const auto picture = document_.picture();
  if (!picture || picture->coarse) {
    document_.messages().warning("There is no picture of the full size to export yet.");
    return;
  }
  write(next_path("", "exr"),
        [picture, job = document_.picture_job(), half_precision](const std::string& path) {
          export_exr(path, job, *picture, half_precision);
        });
}

void Exporter::save_drawing(DisplayImage drawing, const Picture* picture, const std::string& kind) {
  Metadata metadata;
  if (picture) metadata = describe_render(*picture->job, *picture->snapshot);
  write(next_path(kind, "png"), [drawing = std::move(drawing), metadata](const std::string& path) {
    write_png(path, drawing, metadata);
  });
}

void Exporter::write(const std::string& path, std::function<void(const std::string&)> writer) {
  thread_.run([this, path, writer = std::move(writer)] {
    try {
      writer(path);
      queue_.post([this, path] { document_.messages().note("Wrote " + path); });
    } catch (const std::exception& error) {
      queue_.post([this, text = sentence_about(error, "Cannot write '" + path + "'")] {
        document_.messages().error(text);
      });
    }
  });
}

std::string Exporter::next_path(const std::string& kind, const std::string& extension) {
  return files_.next((document_.has_scene() ? document_.title() : "guidelight") + kind, extension);
}

}  // namespace guidelight
