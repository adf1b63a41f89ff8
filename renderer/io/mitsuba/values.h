#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The lexical side of Mitsuba's attribute values. Locale independent.
namespace guidelight::mitsuba {

/// Lower case without underscores, so that "intIOR", "int_ior" and "intIor" are the same name.
std::string canonical_name(std::string_view name);

/// A whole string as a number, spaces around it allowed; empty if it is not one. May be infinite or
/// NaN.
std::optional<double> parse_number(std::string_view text);

/// Splits at commas and white space.
std::vector<std::string_view> split_list(std::string_view text);

/// Numbers separated by commas or white space; empty if one of them is not a number.
std::optional<std::vector<double>> parse_numbers(std::string_view text);

}  // namespace guidelight::mitsuba
