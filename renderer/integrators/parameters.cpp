#include "renderer/integrators/parameters.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "renderer/error.h"

namespace guidelight {

namespace {

template <typename... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};

/// The whole text as a number within the parameter's limits.
template <typename T>
T parse_number(const Parameter& parameter, const std::string& text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stopped, status] = std::from_chars(text.data(), end, value);
  const auto number = static_cast<double>(value);
  if (status != std::errc() || stopped != end || !std::isfinite(number) ||
      number < parameter.minimum || number > parameter.maximum) {
    throw Error("{}={}: give a{} from {} to {}", parameter.key, text,
                std::is_integral_v<T> ? " whole number" : " number", parameter.minimum,
                parameter.maximum);
  }
  return value;
}

bool parse_bool(const Parameter& parameter, const std::string& text) {
  if (text == "true" || text == "on" || text == "yes" || text == "1") return true;
  if (text == "false" || text == "off" || text == "no" || text == "0") return false;
  throw Error("{}={}: give true or false", parameter.key, text);
}

int parse_choice(const Parameter& parameter, const Parameter::Choice& choice,
                 const std::string& text) {
  const auto found = std::find(choice.names.begin(), choice.names.end(), text);
  if (found == choice.names.end()) {
    throw Error("{}={}: choose one of {}", parameter.key, text, fmt::join(choice.names, ", "));
  }
  return static_cast<int>(found - choice.names.begin());
}

}  // namespace

void set_parameter(IntegratorSettings& settings, const std::string& key, const std::string& text) {
  std::vector<std::string> known;
  for (const Parameter& parameter : settings.parameters()) {
    known.push_back(parameter.key);
    if (parameter.key != key) continue;
    std::visit(Overloaded{[&](bool* value) { *value = parse_bool(parameter, text); },
                          [&](int* value) { *value = parse_number<int>(parameter, text); },
                          [&](float* value) { *value = parse_number<float>(parameter, text); },
                          [&](const Parameter::Choice& choice) {
                            *choice.value = parse_choice(parameter, choice, text);
                          }},
               parameter.value);
    return;
  }
  throw Error("there is no parameter '{}': this integrator has {}", key, fmt::join(known, ", "));
}

std::string parameter_text(const Parameter& parameter) {
  return std::visit(
      Overloaded{[](const bool* value) { return std::string(*value ? "true" : "false"); },
                 [](const int* value) { return fmt::format("{}", *value); },
                 [](const float* value) { return fmt::format("{}", *value); },
                 [](const Parameter::Choice& choice) { return choice.names.at(*choice.value); }},
      parameter.value);
}

}  // namespace guidelight
