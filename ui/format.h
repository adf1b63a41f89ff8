#pragma once

#include <cstdint>
#include <string>

namespace guidelight {

/// 950 → "950", 12345 → "12.3 k", 3456789 → "3.46 M".
std::string format_count(double count);
/// Four significant digits, in scientific notation where that is shorter: "0.1234", "12.34",
/// "1.234e-05".
std::string format_value(float value);
/// 4.25 → "4.2 s", 83 → "1:23", 3723 → "1:02:03".
std::string format_duration(double seconds);
/// 0.0234 → "2.3 %".
std::string format_percent(double share);
/// 1536 → "1.5 KiB".
std::string format_bytes(uint64_t bytes);

}  // namespace guidelight
