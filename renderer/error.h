#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace guidelight {

/// Every failure the library reports: one sentence that names what failed (file and line where
/// there is one), the reason, and what to do about it. The library never prints and never exits.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;

  template <typename... Args>
  explicit Error(fmt::format_string<Args...> format, Args&&... args) requires(sizeof...(Args) > 0)
      : std::runtime_error(fmt::format(format, std::forward<Args>(args)...)) {}
};

}  // namespace guidelight
