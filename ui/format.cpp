#include "ui/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace guidelight {
namespace {

/// Three significant digits of a number below 1000.
std::string three_digits(double value) {
  return fmt::format("{:.{}f}", value, value < 9.995 ? 2 : value < 99.95 ? 1 : 0);
}

std::string superscript(int number) {
  static constexpr std::array kDigits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : std::to_string(number)) text += c == '-' ? "⁻" : kDigits[c - '0'];
  return text;
}

}  // namespace

std::string format_count(double count) {
  if (count < 1000) return fmt::format("{:.0f}", count);
  static constexpr std::array kSuffixes = {"k", "M", "G", "T"};
  size_t suffix = 0;
  for (count /= 1000; count >= 999.5 && suffix + 1 < kSuffixes.size(); ++suffix) count /= 1000;
  return three_digits(count) + " " + kSuffixes[suffix];
}

std::string format_value(float value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "∞" : "-∞";
  return fmt::format("{:.4g}", value);
}

std::string format_triple(Vec3 values) {
  if (!is_finite(values)) {
    return fmt::format("{}  {}  {}", format_value(values.x), format_value(values.y),
                       format_value(values.z));
  }
  constexpr int kSmallest = -3;  // powers of ten that are written out
  constexpr int kLargest = 3;
  const float largest = max_component(glm::abs(values));
  const int power = largest > 0 ? static_cast<int>(std::floor(std::log10(largest))) : 0;
  const bool written_out = power >= kSmallest && power <= kLargest;
  if (!written_out) values /= std::pow(10.0f, static_cast<float>(power));
  const int decimals = written_out ? std::clamp(2 - power, 0, 4) : 2;
  const auto number = [&](float value) {
    const bool rounds_to_zero = std::abs(value) < 0.5f * std::pow(10.0f, -decimals);
    return fmt::format("{:.{}f}", rounds_to_zero ? 0 : value, decimals);  // "0.00", not "-0.00"
  };
  const std::string text =
      fmt::format("{}  {}  {}", number(values.x), number(values.y), number(values.z));
  return written_out ? text : text + " ×10" + superscript(power);
}

std::string format_duration(double seconds) {
  if (seconds < 59.95) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<int64_t>(seconds + 0.5);
  const int64_t hours = whole / 3600;
  const int64_t minutes = whole / 60 % 60;
  if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60);
  return fmt::format("{}:{:02}", minutes, whole % 60);
}

std::string format_percent(double share) {
  const double percent = 100 * share;
  if (std::abs(percent) >= 1e5) return fmt::format("{:.2g} %", percent);
  return fmt::format("{:.{}f} %", percent, percent < 1 ? 2 : percent < 10 ? 1 : 0);
}

std::string format_bytes(uint64_t bytes) {
  if (bytes < 1024) return fmt::format("{} bytes", bytes);
  static constexpr std::array kSuffixes = {"KiB", "MiB", "GiB", "TiB"};
  double value = static_cast<double>(bytes) / 1024;
  size_t suffix = 0;
  for (; value >= 999.5 && suffix + 1 < kSuffixes.size(); ++suffix) value /= 1024;
  return fmt::format("{:.1f} {}", value, kSuffixes[suffix]);
}

}  // namespace guidelight
