#include <sstream>

#include "renderer/io/image_file.h"
#include "renderer/io/mitsuba/importer.h"
#include "renderer/io/mitsuba/transform.h"
#include "renderer/io/mitsuba/values.h"
#include "renderer/io/read_file.h"

namespace guidelight::mitsuba {
namespace {

constexpr size_t kMaxSpectrum = size_t{1} << 24;  // bytes of a file

/// Mitsuba's images have v = 0 at their top row, BitmapTexture at the bottom one.
const Mat3 kFlipV(Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 1, 1));

Image extract_channel(const Image& source, int channel) {
  Image result(source.width(), source.height(), 1);
  for (size_t i = 0; i < source.pixel_count(); ++i) {
    result.data()[i] = source.data()[i * source.channels() + channel];
  }
  return result;
}

int channel_index(const std::string& name) {
  const size_t index = std::string("rgba").find(name);
  return name.size() == 1 && index != std::string::npos ? static_cast<int>(index) : kNone;
}

bool is_property(const Node& node) { return node.type.empty(); }

}  // namespace

ColorInput Importer::color_input(const Node& node, SpectrumUse use) {
  const std::string* file = node.tag == "spectrum" ? node.attribute("filename") : nullptr;
  if (file) return {spectrum_file(node, *file, use), kNone};
  if (is_property(node)) return {parse_color(node, use), kNone};
  if (node.tag == "spectrum") return {spectrum_plugin(node, use), kNone};
  if (const auto known = textures_.find(&node); known != textures_.end()) return known->second;

  Properties properties(node, warnings_);
  ColorInput result;
  const auto add = [&](auto model) {
    scene_.textures.push_back({node.id, node.source.line, std::move(model)});
    result.texture = static_cast<int>(scene_.textures.size()) - 1;
  };
  if (node.type == "bitmap") {
    add(bitmap(properties));
  } else if (node.type == "checkerboard") {
    add(checkerboard(properties));
  } else if (node.type == "vertexcolors" || node.type == "vertexcolor" ||
             node.type == "mesh_attribute") {
    properties.ignore({"name"});
    add(VertexColorTexture{});
  } else if (node.type == "scale") {
    const Node* nested = properties.object("texture");
    if (nested) result = color_input(*nested, use);
    result.value *= constant_color(properties, {"scale", "value"}, Color(1), use);
  } else {
    warnings_.add(
        node.source, plugin_name(node),
        fmt::format("{} is not supported; a constant grey of 0.5 stands in.", plugin_name(node)));
    result.value = Color(0.5f);
    textures_[&node] = result;
    return result;
  }
  properties.warn_about_the_rest();
  textures_[&node] = result;
  return result;
}

ColorInput Importer::color(Properties& properties, Properties::Names names, Color fallback,
                           SpectrumUse use) {
  const Node* node = properties.find(names);
  return node ? color_input(*node, use) : ColorInput{fallback, kNone};
}

Color Importer::constant_color(Properties& properties, Properties::Names names, Color fallback,
                               SpectrumUse use) {
  const ColorInput input = color(properties, names, fallback, use);
  if (input.texture != kNone) {
    warnings_.add(properties.node().source, plugin_name(properties.node()) + " constant",
                  fmt::format("{} cannot be textured here; the texture is ignored.",
                              plugin_name(properties.node())));
  }
  return input.value;
}

FloatInput Importer::number(Properties& properties, Properties::Names names, float fallback) {
  const Node* node = properties.find(names);
  if (!node) return {fallback};
  const ColorInput input = color_input(*node, SpectrumUse::Coefficient);
  return {luminance(input.value), input.texture, kNone};
}

int Importer::texture(const Node& node) {
  return color_input(node, SpectrumUse::Reflectance).texture;
}

/// <spectrum type="…">, Mitsuba 2 and 3.
Color Importer::spectrum_plugin(const Node& node, SpectrumUse use) {
  Properties properties(node, warnings_);
  Color result(1.0f);
  if (node.type == "uniform" || node.type == "d65") {
    result = Color(properties.number({"value"}, 1) * properties.number({"scale"}, 1));
    properties.ignore({"lambda_min", "lambda_max", "wavelength_min", "wavelength_max"});
  } else if (node.type == "srgb" || node.type == "rgb") {
    result = constant_color(properties, {"color", "value"}, Color(1), use);
  } else if (node.type == "blackbody") {
    result = blackbody_rgb(std::max(properties.number({"temperature"}, 5000), 1.0f)) *
             properties.number({"scale"}, 1);
  } else if (node.type == "irregular") {
    const auto wavelengths = parse_numbers(properties.text({"wavelengths"}, ""));
    const auto values = parse_numbers(properties.text({"values"}, ""));
    const std::vector<double> none;
    result = sampled_color(node, wavelengths.value_or(none), values.value_or(none), use);
  } else {
    warnings_.add(node.source, plugin_name(node),
                  fmt::format("{} is not supported; 1 stands in.", plugin_name(node)));
    return result;
  }
  properties.warn_about_the_rest();
  return result;
}

/// A text file with a wavelength [nm] and a value in each line and comments after #.
Color Importer::spectrum_file(const Node& node, const std::string& name, SpectrumUse use) {
  std::istringstream lines(read_file_bytes(document_.find_file(name, node.source), kMaxSpectrum));
  std::vector<double> wavelengths, values;
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    line.resize(std::min(line.find('#'), line.size()));
    const std::vector<double> pair = parse_numbers(line).value_or(std::vector{0.0});
    if (pair.empty()) continue;
    if (pair.size() != 2) {
      throw Error("{}: line {} of '{}' is not a wavelength and a value; correct it.",
                  node.source.to_string(), number, name);
    }
    wavelengths.push_back(pair[0]);
    values.push_back(pair[1]);
  }
  return sampled_color(node, wavelengths, values, use);
}

std::shared_ptr<const Image> Importer::image(Properties& properties, bool raw) {
  const Node& node = properties.node();
  const std::string name = properties.text({"filename"}, "");
  if (name.empty()) {
    throw Error("{}: {} names no file; add a 'filename'.", node.source.to_string(),
                plugin_name(node));
  }
  const std::string path = document_.find_file(name, node.source);
  std::shared_ptr<const Image>& image = images_[{path, raw}];
  if (image) return image;
  try {
    image =
        std::make_shared<Image>(read_image(path, raw ? ColorSpace::Linear : ColorSpace::Automatic));
  } catch (const Error& error) {
    throw Error("{}: {}", node.source.to_string(), error.what());
  }
  return image;
}

BitmapTexture Importer::bitmap(Properties& properties) {
  BitmapTexture bitmap;
  // Mitsuba 0.x says "linear" by a gamma of one.
  const bool raw = properties.boolean({"raw"}, properties.number({"gamma"}, -1) == 1);
  bitmap.image = image(properties, raw);
  const int channel = channel_index(properties.text({"channel"}, ""));
  if (channel != kNone && channel < bitmap.image->channels()) {
    bitmap.image = std::make_shared<Image>(extract_channel(*bitmap.image, channel));
  }

  const auto wrap = [](const std::string& name, WrapMode fallback) {
    if (name == "repeat") return WrapMode::Repeat;
    if (name == "mirror") return WrapMode::Mirror;
    if (name == "clamp") return WrapMode::Clamp;
    if (name == "zero" || name == "black") return WrapMode::Zero;
    if (name == "one" || name == "white") return WrapMode::One;
    return fallback;
  };
  const WrapMode both = wrap(properties.text({"wrap_mode"}, ""), WrapMode::Repeat);
  bitmap.wrap_u = wrap(properties.text({"wrap_mode_u"}, ""), both);
  bitmap.wrap_v = wrap(properties.text({"wrap_mode_v"}, ""), both);
  const bool nearest = properties.text({"filter_type"}, "bilinear") == "nearest";
  bitmap.filter = nearest ? TextureFilter::Nearest : TextureFilter::Bilinear;
  bitmap.uv_transform = kFlipV * uv_transform(properties);
  properties.ignore({"format", "accel", "cache", "max_anisotropy"});
  return bitmap;
}

CheckerboardTexture Importer::checkerboard(Properties& properties) {
  CheckerboardTexture checkerboard;
  checkerboard.color0 = color(properties, {"color0"}, Color(0.4f));
  checkerboard.color1 = color(properties, {"color1"}, Color(0.2f));
  checkerboard.uv_transform = uv_transform(properties);
  return checkerboard;
}

/// Mitsuba 0.x scales and shifts, 2 and 3 have a transform.
Mat3 Importer::uv_transform(Properties& properties) {
  const float scale = properties.number({"uvscale"}, 1);
  const Vec2 scales(properties.number({"uscale"}, scale), properties.number({"vscale"}, scale));
  const Vec2 offset(properties.number({"uoffset"}, 0), properties.number({"voffset"}, 0));
  const Mat3 shifted(Vec3(scales.x, 0, 0), Vec3(0, scales.y, 0), Vec3(offset, 1));
  const Node* transform = properties.find({"to_uv"});
  return transform ? parse_uv_transform(*transform) * shifted : shifted;
}

}  // namespace guidelight::mitsuba
