#include "ui/session_metadata.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "renderer/io/guide_file.h"
#include "renderer/scene/film_size.h"
#include "renderer/session/picture_export.h"

namespace guidelight {
namespace {

constexpr const char* kParameterPrefix = "set.";
constexpr const char* kDefinePrefix = "define.";

std::optional<Mat4> matrix_from(const std::string& text) {
  std::istringstream stream(text);
  Mat4 matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      if (!(stream >> matrix[column][row])) return std::nullopt;
    }
  }
  return matrix;
}

template <typename Number>
std::optional<Number> number_from(const std::string& text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::optional<PixelRegion> region_from(const std::string& text) {
  std::istringstream stream(text);
  PixelRegion region;
  char comma = 0;
  stream >> region.x0 >> comma >> region.y0 >> comma >> region.x1 >> comma >> region.y1;
  return stream ? std::optional(region) : std::nullopt;
}

std::string lookup(const Metadata& metadata, const std::string& key) {
  const auto found = metadata.find(key);
  return found == metadata.end() ? "" : found->second;
}

/// The entries whose keys begin with the prefix, without it.
std::map<std::string, std::string> with_prefix(const Metadata& metadata,
                                               const std::string& prefix) {
  std::map<std::string, std::string> found;
  for (const auto& [key, value] : metadata) {
    if (key.starts_with(prefix)) found[key.substr(prefix.size())] = value;
  }
  return found;
}

}  // namespace

std::optional<RememberedSession> session_of(const Metadata& metadata) {
  RememberedSession session;
  session.scene_path = lookup(metadata, "scene");
  session.integrator = lookup(metadata, "integrator");
  const auto camera = matrix_from(lookup(metadata, "camera_to_world"));
  const std::string size = lookup(metadata, "size");
  const size_t times = std::min(size.find('x'), size.size());
  const auto width = number_from<int>(size.substr(0, times));
  const auto height = number_from<int>(size.substr(std::min(times + 1, size.size())));
  const auto seed = number_from<uint64_t>(lookup(metadata, "seed"));
  const bool has_pixels = width && height && is_film_size(*width, *height);
  if (session.scene_path.empty() || session.integrator.empty() || !camera || !has_pixels || !seed) {
    return std::nullopt;
  }
  session.scene_hash = lookup(metadata, "scene_hash");
  session.parameters = with_prefix(metadata, kParameterPrefix);
  session.defines = with_prefix(metadata, kDefinePrefix);
  session.region = region_from(lookup(metadata, "region"));
  if (session.region && !session.region->is_within(*width, *height)) session.region.reset();
  session.camera_to_world = *camera;
  session.guides = lookup(metadata, "guides");
  session.width = *width;
  session.height = *height;
  session.seed = *seed;
  return session;
}

RenderJob job_of(const RememberedSession& session, const Scene& scene) {
  const Camera camera = scene.camera()
                            .with_resolution(session.width, session.height)
                            .with_transform(session.camera_to_world);
  RenderJob job;
  job.scene = scene.with_camera(camera);
  job.integrator = session.integrator;
  std::shared_ptr<IntegratorSettings> parameters =
      find_integrator(session.integrator).make_settings(scene.description().hints);
  for (const auto& [key, text] : session.parameters) set_parameter(*parameters, key, text);
  job.settings = std::move(parameters);
  job.seed = session.seed;
  job.region = session.region;
  if (session.guides) {
    std::vector<GuidePath> guides;
    if (!session.guides->empty()) guides = parse_guides(*session.guides, "the picture's guides");
    job.guides = std::make_shared<const std::vector<GuidePath>>(std::move(guides));
  }
  return job;
}

void restore_session(const RememberedSession& session, Document& document) {
  const RenderJob job = job_of(session, document.scene());
  if (session.scene_hash != document.scene().description().file_hash) {
    document.messages().warning(session.scene_path +
                                " has changed since this was saved; it may look different.");
  }
  RenderSettings settings = document.settings();
  settings.integrator = job.integrator;
  settings.parameters = job.settings;
  settings.width = session.width;
  settings.height = session.height;
  settings.seed = job.seed;
  settings.region = job.region;
  document.set_settings(settings);
  document.move_camera(
      [&](CameraController& camera) { camera.set_to_world(session.camera_to_world); });
  document.find_pivot();
  if (job.guides && guides_text(*job.guides) != guides_text(*document.guides())) {
    document.edit_guides(*job.guides, "guides of the session");
  }
}

}  // namespace guidelight
