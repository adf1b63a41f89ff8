#include "renderer/io/read_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "renderer/error.h"

namespace guidelight {

std::string read_file_bytes(const std::string& path, size_t max_bytes) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    throw Error("Cannot read '{}': there is no such file; check the name and the folder.", path);
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw Error("Cannot read '{}': it is not a regular file; give the name of a file.", path);
  }
  const uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && size > max_bytes) {
    throw Error("Cannot read '{}': it has {} bytes and the limit is {}; use a smaller file.", path,
                size, max_bytes);
  }
  std::ifstream file(path, std::ios::binary);
  std::string bytes(error ? 0 : size, '\0');
  if (file) file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file || error) {
    throw Error("Cannot read '{}': {}; check its permissions.", path, std::strerror(errno));
  }
  return bytes;
}

}  // namespace guidelight
