#include "ui/session_metadata.h"

#include <fmt/format.h>

#include <charconv>
#include <sstream>

namespace guidelight {
namespace {

constexpr const char* kParameterPrefix = "parameter.";
constexpr const char* kDefinePrefix = "define.";

std::string matrix_text(const Mat4& matrix) {
  std::string text;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      text += fmt::format("{}{:.9g}", text.empty() ? "" : " ", matrix[column][row]);
    }
  }
  return text;
}

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

Metadata describe_picture(const JobRecord& record, const Snapshot& picture) {
  const RenderSettings& settings = record.settings;
  Metadata metadata = {
      {"software", "Guidelight"},
      {"scene", record.opened.path},
      {"scene_hash", record.opened.file_hash},
      {"integrator", settings.integrator},
      {"seed", std::to_string(settings.seed)},
      {"width", std::to_string(settings.width)},
      {"height", std::to_string(settings.height)},
      {"passes", std::to_string(picture.passes)},
      {"samples", std::to_string(picture.samples)},
      {"seconds", fmt::format("{:.3f}", picture.seconds)},
      {"relative_error", fmt::format("{:.6g}", picture.relative_error)},
      {"camera_to_world", matrix_text(record.to_world)},
  };
  if (settings.region) {
    const PixelRegion& region = *settings.region;
    metadata["region"] = fmt::format("{},{},{},{}", region.x0, region.y0, region.x1, region.y1);
  }
  for (const auto& [name, value] : record.opened.defines) metadata[kDefinePrefix + name] = value;
  if (settings.parameters) {
    const auto parameters = settings.parameters->clone();
    for (const Parameter& parameter : parameters->parameters()) {
      metadata[kParameterPrefix + parameter.key] = parameter_text(parameter);
    }
  }
  return metadata;
}

std::optional<RememberedSession> session_of(const Metadata& metadata) {
  RememberedSession session;
  session.scene_path = lookup(metadata, "scene");
  session.integrator = lookup(metadata, "integrator");
  const auto camera = matrix_from(lookup(metadata, "camera_to_world"));
  const auto width = number_from<int>(lookup(metadata, "width"));
  const auto height = number_from<int>(lookup(metadata, "height"));
  const auto seed = number_from<uint64_t>(lookup(metadata, "seed"));
  if (session.scene_path.empty() || session.integrator.empty() || !camera || !width || !height ||
      !seed) {
    return std::nullopt;
  }
  session.scene_hash = lookup(metadata, "scene_hash");
  session.defines = with_prefix(metadata, kDefinePrefix);
  session.parameters = with_prefix(metadata, kParameterPrefix);
  session.camera_to_world = *camera;
  session.width = *width;
  session.height = *height;
  session.seed = *seed;
  return session;
}

void restore_session(const RememberedSession& session, Document& document) {
  if (session.scene_hash != document.opened().file_hash) {
    document.messages().warning(session.scene_path +
                                " has changed since the picture was saved; it may look different.");
  }
  RenderSettings settings = document.settings();
  settings.integrator = session.integrator;
  std::shared_ptr<IntegratorSettings> parameters =
      find_integrator(session.integrator).make_settings(document.scene().description().hints);
  for (const auto& [key, text] : session.parameters) set_parameter(*parameters, key, text);
  settings.parameters = std::move(parameters);
  settings.width = session.width;
  settings.height = session.height;
  settings.seed = session.seed;
  document.set_settings(settings);
  document.move_camera(
      [&](CameraController& camera) { camera.set_to_world(session.camera_to_world); });
  document.find_pivot();
}

}  // namespace guidelight
