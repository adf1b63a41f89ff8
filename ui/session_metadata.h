#pragma once

#include <map>
#include <optional>
#include <string>

#include "renderer/io/image_file.h"
#include "ui/document.h"

namespace guidelight {

/// What the metadata of a picture or checkpoint (describe_render) say about the session it is from.
struct RememberedSession {
  std::string scene_path;
  std::string scene_hash;
  std::map<std::string, std::string> defines;  // variables the scene was read with
  std::string integrator;
  std::map<std::string, std::string> parameters;
  int width = 0;
  int height = 0;
  uint64_t seed = 0;
  std::optional<PixelRegion> region;
  Mat4 camera_to_world{1.0f};
  /// As guides_text() wrote them, "" if there were none; empty if nobody knows.
  std::optional<std::string> guides;
};

/// Empty if the metadata are not those of a picture or checkpoint of ours.
std::optional<RememberedSession> session_of(const Metadata& metadata);

/// The render of a session, with the guides it had if that is known. Throws Error for a camera,
/// integrator, parameters or guides that do not exist.
RenderJob job_of(const RememberedSession& session, const Scene& scene);

/// Gives a document whose scene is open the settings and the camera of a session. Throws what
/// job_of() throws, before anything is changed.
void restore_session(const RememberedSession& session, Document& document);

}  // namespace guidelight
