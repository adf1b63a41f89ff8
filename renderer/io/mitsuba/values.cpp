#include "renderer/io/mitsuba/values.h"

#include <charconv>
#include <cstdlib>
#include <string>

namespace guidelight::mitsuba {
namespace {

constexpr std::string_view kSpaces = " \t\r\n";
constexpr std::string_view kSeparators = ", \t\r\n";

}  // namespace

std::string canonical_name(std::string_view name) {
  std::string result;
  for (const char c : name) {
    if (c == '_') continue;
    result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return result;
}

std::optional<double> parse_number(std::string_view text) {
  const size_t begin = text.find_first_not_of(kSpaces);
  if (begin == std::string_view::npos) return std::nullopt;
  text = text.substr(begin, text.find_last_not_of(kSpaces) - begin + 1);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  // A number too small or too large for a double is still a number: zero or infinite.
  const bool out_of_range = error == std::errc::result_out_of_range;
  if ((error != std::errc() && !out_of_range) || end != text.data() + text.size()) {
    return std::nullopt;
  }
  if (out_of_range) value = std::strtod(std::string(text).c_str(), nullptr);
  return value;
}

std::vector<std::string_view> split_list(std::string_view text) {
  std::vector<std::string_view> parts;
  for (size_t begin = text.find_first_not_of(kSeparators); begin != std::string_view::npos;) {
    const size_t end = std::min(text.find_first_of(kSeparators, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(kSeparators, end);
  }
  return parts;
}

std::optional<std::vector<double>> parse_numbers(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string_view part : split_list(text)) {
    const std::optional<double> number = parse_number(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace guidelight::mitsuba
