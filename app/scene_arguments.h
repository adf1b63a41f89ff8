#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "renderer/error.h"
#include "renderer/image/pixel_region.h"
#include "renderer/scene/description.h"

namespace guidelight {

/// The arguments that name a scene, alike in every command: SCENE, -D name=value, --size WxH.
struct SceneArguments {
  std::string path;
  std::vector<std::string> defines;
  std::string size;

  /// `required`: whether SCENE must be given.
  void add_to(CLI::App& command, bool required = true);
  /// Reads the scene and applies --size. Throws Error.
  std::shared_ptr<const SceneDescription> read() const;
};

/// Width and height of --size WxH. Throws CLI::ValidationError for a film that cannot be rendered.
std::pair<int, int> parse_size(const std::string& text);

/// Splits "name=value". Throws CLI::ValidationError (exit status 2) naming the option.
std::pair<std::string, std::string> split_assignment(const std::string& option,
                                                     const std::string& text);

/// What `look` returns; its Errors become CLI::ValidationError (exit status 2) naming the option.
template <typename Look>
auto check_argument(const std::string& option, const Look& look) {
  try {
    return look();
  } catch (const Error& error) {
    throw CLI::ValidationError(option, error.what());
  }
}

/// Checks the ending of a file's name.
CLI::Validator ends_in(const std::string& ending);

/// Numbers of a list such as 640x480 or 0,0,64,64. Throws CLI::ValidationError unless there are
/// `count` whole numbers.
std::vector<int> split_numbers(const std::string& option, const std::string& text, char separator,
                               size_t count);

/// Pixels of a picture, "x0,y0,x1,y1" (without x1 and y1) or one, "x,y". Throw
/// CLI::ValidationError unless they are inside it.
PixelRegion parse_region(const std::string& option, const std::string& text, int width, int height);
PixelRegion parse_pixel(const std::string& option, const std::string& text, int width, int height);

}  // namespace guidelight
