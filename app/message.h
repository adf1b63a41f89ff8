#pragma once

#include <fmt/core.h>

#include <cstdio>
#include <string>
#include <utility>

namespace guidelight {

/// Writes to standard error. What cannot be written there is lost and ends nothing.
template <typename... Values>
void say(fmt::format_string<Values...> format, Values&&... values) {
  const std::string text = fmt::format(format, std::forward<Values>(values)...);
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace guidelight
