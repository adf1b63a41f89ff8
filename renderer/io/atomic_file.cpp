#include "renderer/io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <random>

#include "renderer/error.h"

namespace guidelight {
namespace {

namespace fs = std::filesystem;

std::string reason_of_errno() { return std::strerror(errno); }

/// Creates an empty file with a fresh name beside `target`, so that the rename stays in one file
/// system.
std::string create_temporary(const fs::path& target) {
  std::random_device random;
  for (int attempt = 0; attempt < 16; ++attempt) {
    const fs::path path =
        target.parent_path() / fmt::format(".{}.{:08x}.tmp", target.filename().string(), random());
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0) {
      ::close(file);
      return path.string();
    }
    if (errno != EEXIST) break;
  }
  throw Error("{}", reason_of_errno());
}

/// Data reaches the disk before the name does: a crash leaves the old file or the new one.
void flush_to_disk(const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) throw Error("{}", reason_of_errno());
  const bool failed = ::fsync(file) != 0;
  const std::string reason = failed ? reason_of_errno() : "";
  ::close(file);
  if (failed) throw Error("{}", reason);
}

void replace_file(const fs::path& target, const std::function<void(const std::string&)>& write) {
  const std::string temporary = create_temporary(target);
  try {
    struct stat old_file;
    if (::stat(target.c_str(), &old_file) == 0)
      ::chmod(temporary.c_str(), old_file.st_mode & 07777);
    write(temporary);
    flush_to_disk(temporary);
    if (::rename(temporary.c_str(), target.c_str()) != 0) throw Error("{}", reason_of_errno());
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
}

/// Calls `act` with the file that is to be replaced, or a device or pipe that is to be written to.
template <typename Act>
void with_target(const std::string& path, const Act& act) {
  try {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (fs::is_directory(status)) throw Error("it is a folder");
    // A symbolic link stays one: the file it points to is replaced.
    const fs::path real = fs::exists(status) ? fs::canonical(path) : fs::path(path);
    act(real, fs::exists(status) && !fs::is_regular_file(status));
  } catch (const std::exception& error) {
    throw Error("Cannot write '{}': {}; choose a folder that can be written and has space.", path,
                error.what());
  }
}

}  // namespace

void write_atomically(const std::string& path,
                      const std::function<void(const std::string&)>& write) {
  with_target(path, [&](const fs::path& target, bool is_device) {
    if (is_device) {
      write(path);  // it must not be replaced by a file
    } else {
      replace_file(target, write);
    }
  });
}

void check_writable(const std::string& path) {
  with_target(path, [](const fs::path& target, bool is_device) {
    if (!is_device) fs::remove(create_temporary(target));
  });
}

void write_file_atomically(const std::string& path, const std::string& bytes) {
  write_atomically(path, [&](const std::string& temporary) {
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) throw Error("{}", errno ? reason_of_errno() : "the bytes could not be written");
  });
}

}  // namespace guidelight
