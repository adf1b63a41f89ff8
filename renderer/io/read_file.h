#pragma once

#include <string>

namespace guidelight {

/// The bytes of a file. Throws Error naming `path` if it is missing, a folder, unreadable, or
/// larger than `max_bytes`.
std::string read_file_bytes(const std::string& path, size_t max_bytes = size_t{1} << 30);

}  // namespace guidelight
