#include "app/scene_arguments.h"

#include <charconv>
#include <map>

#include "renderer/scene/camera.h"
#include "renderer/scene/film_size.h"
#include "renderer/session/open_scene.h"

namespace guidelight {

void SceneArguments::add_to(CLI::App& command, bool required) {
  auto* scene = command.add_option("SCENE", path, "Mitsuba XML or glTF 2.0 file");
  if (required) scene->required();
  command.add_option("-D", defines, "Set a variable of an XML scene: name=value")
      ->allow_extra_args(false);
  command.add_option("--size", size, "Picture size, WxH pixels");
}

std::shared_ptr<const SceneDescription> SceneArguments::read() const {
  std::map<std::string, std::string> variables;
  for (const std::string& define : defines) variables.insert(split_assignment("-D", define));
  const auto description = open_scene(path, variables);
  if (!size.empty()) {
    const auto [width, height] = parse_size(size);
    // The camera does not matter: a crop window shows the same part in another size.
    description->film = Camera({}, description->film).with_resolution(width, height).film();
  }
  return description;
}

std::pair<int, int> parse_size(const std::string& text) {
  const std::vector<int> size = split_numbers("--size", text, 'x', 2);
  if (!is_film_size(size[0], size[1])) {
    throw CLI::ValidationError(
        "--size", fmt::format("{}: give 1 to {} pixels a side and at most {} in all", text,
                              kMaxFilmSide, kMaxFilmPixels));
  }
  return {size[0], size[1]};
}

std::pair<std::string, std::string> split_assignment(const std::string& option,
                                                     const std::string& text) {
  const size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw CLI::ValidationError(option, fmt::format("'{}' is not of the form name=value", text));
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

CLI::Validator ends_in(const std::string& ending) {
  return {[ending](const std::string& path) {
            return path.ends_with(ending) ? "" : path + " does not end in " + ending;
          },
          "FILE" + ending};
}

std::vector<int> split_numbers(const std::string& option, const std::string& text, char separator,
                               size_t count) {
  std::vector<int> numbers;
  const char* next = text.data();
  const char* end = next + text.size();
  while (next < end) {
    int number = 0;
    const auto [stopped, status] = std::from_chars(next, end, number);
    if (status != std::errc() || (stopped != end && *stopped != separator)) break;
    numbers.push_back(number);
    next = stopped == end ? end : stopped + 1;
    if (stopped == end) break;
  }
  if (next != end || numbers.size() != count || text.back() == separator) {
    throw CLI::ValidationError(option, fmt::format("'{}' is not {} whole numbers separated by '{}'",
                                                   text, count, separator));
  }
  return numbers;
}

PixelRegion parse_region(const std::string& option, const std::string& text, int width,
                         int height) {
  const std::vector<int> n = split_numbers(option, text, ',', 4);
  const PixelRegion region{n[0], n[1], n[2], n[3]};
  if (!region.is_within(width, height)) {
    throw CLI::ValidationError(
        option, fmt::format("{}: the picture has {}x{} pixels: give x0,y0,x1,y1 inside it", text,
                            width, height));
  }
  return region;
}

PixelRegion parse_pixel(const std::string& option, const std::string& text, int width, int height) {
  const std::vector<int> n = split_numbers(option, text, ',', 2);
  const auto pixel = PixelRegion::pixel({n[0], n[1]});
  if (!pixel.is_within(width, height)) {
    throw CLI::ValidationError(
        option,
        fmt::format("{}: the picture has {}x{} pixels: give x,y inside it", text, width, height));
  }
  return pixel;
}

}  // namespace guidelight
