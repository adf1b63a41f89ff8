#pragma once

#include <string>
#include <vector>

#include "renderer/transport/guide_path.h"

namespace guidelight {

// Guides are kept as JSON; docs/guides.md describes the format.

/// Where the guides of a scene are looked for: NAME.guides.json beside NAME.xml.
std::string guide_file_beside(const std::string& scene_path);

/// Throws Error naming the file, the guide and vertex, and what is wrong. Says nothing of whether
/// the guides fit a scene.
std::vector<GuidePath> read_guides(const std::string& path);

/// The same from text; `where` stands for the file's name in errors.
std::vector<GuidePath> parse_guides(const std::string& text, const std::string& where);

/// Is read back to the same guides. Throws Error for names that are not UTF-8.
std::string guides_text(const std::vector<GuidePath>& guides);

/// Throws Error.
void write_guides(const std::string& path, const std::vector<GuidePath>& guides);

}  // namespace guidelight
