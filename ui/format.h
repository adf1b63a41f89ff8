#pragma once

#include <cstdint>
#include <string>

#include "renderer/math/vector.h"

namespace guidelight {

/// 950 → "950", 12345 → "12.3 k", 3456789 → "3.46 M".
std::string format_count(double count);
/// Four significant digits, in scientific notation where that is shorter: "0.1234", "12.34",
/// "1.234e-05".
std::string format_value(float value);
/// 4.25 → "4.2 s", 83 → "1:23", 3723 → "1:02:03".
std::string format_duration(double seconds);
/// Three values with as many decimals as give the largest three digits: "0.094  0.126  1.12", with
/// a common power of ten where they are very small or large: "1.23  0.04  5.60 ×10⁻⁵".
std::string format_triple(Vec3 values);
/// 0.0234 → "2.3 %"; 82000 → "8.2e+06 %".
std::string format_percent(double share);
/// 1536 → "1.5 KiB".
std::string format_bytes(uint64_t bytes);

}  // namespace guidelight
