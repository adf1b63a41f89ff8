#include "renderer/io/mitsuba/properties.h"

#include <algorithm>

#include "renderer/io/mitsuba/transform.h"
#include "renderer/io/mitsuba/values.h"

namespace guidelight::mitsuba {
namespace {

std::string name_of(const Node& node) {
  const std::string* name = node.attribute("name");
  return name ? *name : node.tag;
}

[[noreturn]] void fail(const Node& node, const std::string& value, const char* expected) {
  throw Error("{}: '{}' of <{}> '{}' is not {}; correct it.", node.source.to_string(), value,
              node.tag, name_of(node), expected);
}

const std::string& value_of(const Node& node) {
  const std::string* value = node.attribute("value");
  if (!value) {
    throw Error("{}: <{}> '{}' has no value; add one.", node.source.to_string(), node.tag,
                name_of(node));
  }
  return *value;
}

float finite_number(const Node& node, const std::string& text) {
  const std::optional<double> value = parse_number(text);
  if (!value || !std::isfinite(static_cast<float>(*value))) fail(node, text, "a finite number");
  return static_cast<float>(*value);
}

/// "#rrggbb" as 0..1.
std::optional<Color> parse_hex(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  Color color;
  for (int i = 0; i < 3; ++i) {
    int value = 0;
    for (const char c : text.substr(1 + 2 * i, 2)) {
      const size_t digit = std::string_view("0123456789abcdef").find(static_cast<char>(c | 0x20));
      if (digit == std::string_view::npos) return std::nullopt;
      value = value * 16 + static_cast<int>(digit);
    }
    color[i] = static_cast<float>(value) / 255;
  }
  return color;
}

/// "wavelength:value" pairs.
Color parse_pairs(const Node& node, const std::string& text, SpectrumUse use) {
  std::vector<double> wavelengths, values;
  for (const std::string_view pair : split_list(text)) {
    const size_t colon = pair.find(':');
    const auto wavelength = parse_number(pair.substr(0, colon));
    const auto value =
        colon == std::string_view::npos ? std::nullopt : parse_number(pair.substr(colon + 1));
    if (!wavelength || !value) {
      fail(node, std::string(pair), "a pair of a wavelength and a value");
    }
    wavelengths.push_back(*wavelength);
    values.push_back(*value);
  }
  return sampled_color(node, wavelengths, values, use);
}

Color parse_triple(const Node& node, const std::string& text) {
  if (const std::optional<Color> hex = parse_hex(text)) return *hex;
  const std::optional<std::vector<double>> numbers = parse_numbers(text);
  if (!numbers || (numbers->size() != 1 && numbers->size() != 3)) {
    fail(node, text, "a colour (one number, three, or #rrggbb)");
  }
  const std::vector<double>& v = *numbers;
  const Color color = v.size() == 1 ? Color(v[0]) : Color(v[0], v[1], v[2]);
  if (!is_finite(color)) fail(node, text, "finite");
  return color;
}

Color parse_blackbody(const Node& node) {
  const std::string* temperature = node.attribute("temperature");
  std::string text = temperature ? *temperature : value_of(node);
  if (!text.empty() && (text.back() == 'K' || text.back() == 'k')) text.pop_back();
  const float kelvin = finite_number(node, text);
  if (!(kelvin > 0)) fail(node, text, "a temperature above zero kelvin");
  const std::string* scale = node.attribute("scale");
  return blackbody_rgb(kelvin) * (scale ? finite_number(node, *scale) : 1.0f);
}

}  // namespace

std::string plugin_name(const Node& node) {
  return node.type.empty() ? fmt::format("<{}>", node.tag)
                           : fmt::format("{} '{}'", node.tag, node.type);
}

Color sampled_color(const Node& node, std::span<const double> wavelengths,
                    std::span<const double> values, SpectrumUse use) {
  const auto is_finite_value = [](double v) { return std::isfinite(v); };
  if (wavelengths.empty() || wavelengths.size() != values.size() ||
      !std::ranges::all_of(wavelengths, is_finite_value) ||
      !std::ranges::all_of(values, is_finite_value)) {
    throw Error(
        "{}: the spectrum '{}' has {} wavelengths and {} values; give as many of both, all finite.",
        node.source.to_string(), name_of(node), wavelengths.size(), values.size());
  }
  std::vector<SpectralSample> samples;
  for (size_t i = 0; i < values.size(); ++i) samples.push_back({wavelengths[i], values[i]});
  std::ranges::stable_sort(samples, {}, &SpectralSample::wavelength);
  return spectrum_to_rgb(samples, use);
}

Color parse_color(const Node& node, SpectrumUse use) {
  if (node.tag == "blackbody") return parse_blackbody(node);
  const std::string& text = value_of(node);
  if (text.find(':') != std::string::npos) return parse_pairs(node, text, use);
  const Color color = parse_triple(node, text);
  return node.tag == "srgb" ? srgb_to_linear(color) : color;
}

const Node* Properties::find(Names names) {
  const Node* first = nullptr;
  for (const char* name : names) {
    const std::string canonical = canonical_name(name);
    for (const Child& child : node_.children) {
      if (child.name != canonical) continue;
      used_.insert(child.node);
      if (!first) first = child.node;
    }
  }
  return first;
}

std::vector<const Node*> Properties::objects(const char* tag) {
  std::vector<const Node*> found;
  for (const Child& child : node_.children) {
    if (child.node->tag != tag) continue;
    used_.insert(child.node);
    found.push_back(child.node);
  }
  return found;
}

const Node* Properties::object(const char* tag) {
  const std::vector<const Node*> found = objects(tag);
  return found.empty() ? nullptr : found.front();
}

float Properties::number(Names names, float fallback) {
  const Node* property = find(names);
  return property ? finite_number(*property, value_of(*property)) : fallback;
}

int Properties::integer(Names names, int fallback) {
  const Node* property = find(names);
  if (!property) return fallback;
  const std::string& text = value_of(*property);
  const std::optional<double> value = parse_number(text);
  if (!value || *value != std::floor(*value)) fail(*property, text, "an integer");
  return static_cast<int>(std::clamp(*value, -2147483648.0, 2147483647.0));
}

bool Properties::boolean(Names names, bool fallback) {
  const Node* property = find(names);
  if (!property) return fallback;
  const std::string value = canonical_name(value_of(*property));
  if (value == "true" || value == "1") return true;
  if (value == "false" || value == "0") return false;
  fail(*property, value, "'true' or 'false'");
}

std::string Properties::text(Names names, const std::string& fallback) {
  const Node* property = find(names);
  return property ? value_of(*property) : fallback;
}

Vec3 Properties::vector(Names names, Vec3 fallback) {
  const Node* property = find(names);
  return property ? parse_vector(*property, Vec3(0)) : fallback;
}

Mat4 Properties::transform(Names names) {
  const Node* property = find(names);
  if (!property) return Mat4(1);
  if (property->tag == "animation") {
    warnings_.add(property->source, "animation",
                  "animated transforms are not supported; the first key stands in.");
    return property->children.empty() ? Mat4(1) : parse_transform(*property->children[0].node);
  }
  if (property->tag != "transform") fail(*property, property->tag, "a transform");
  return parse_transform(*property);
}

void Properties::ignore(Names names) { find(names); }

void Properties::warn_about_the_rest() {
  for (const Child& child : node_.children) {
    if (used_.contains(child.node)) continue;
    const std::string what = plugin_name(*child.node);
    const std::string* given = child.node->attribute("name");
    const std::string name = given ? fmt::format(" '{}'", *given) : "";
    warnings_.add(child.node->source, plugin_name(node_) + what + name,
                  fmt::format("{}{} inside {} is not supported and is ignored.", what, name,
                              plugin_name(node_)));
  }
}

}  // namespace guidelight::mitsuba
