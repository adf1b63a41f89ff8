#pragma once

#include <functional>
#include <string>

namespace guidelight {

/// The one way to write a file: `write` receives a temporary path in the same folder and fills it;
/// then the file is flushed to disk and renamed to `path`. If anything throws, the temporary file
/// is removed and `path` is as it was. Throws Error naming `path`, the reason and what to do.
void write_atomically(const std::string& path,
                      const std::function<void(const std::string&)>& write);

/// Throws the same Error now if no file could be made there, before work is done for it.
void check_writable(const std::string& path);

/// The same for a ready string of bytes.
void write_file_atomically(const std::string& path, const std::string& bytes);

}  // namespace guidelight
