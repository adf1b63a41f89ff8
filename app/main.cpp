#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <exception>
#include <string_view>

#include "app/commands.h"

namespace {

constexpr int kFailed = 1;
constexpr int kBadArguments = 2;

/// `guidelight SCENE` means `guidelight view SCENE`.
bool names_a_command(const CLI::App& app, std::string_view word) {
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  return std::any_of(commands.begin(), commands.end(),
                     [&](const CLI::App* command) { return command->get_name() == word; });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Guidelight: a viewer and path editor for hard light transport", "guidelight"};
  app.set_version_flag("--version", GUIDELIGHT_VERSION);
  app.require_subcommand(1);
  guidelight::add_view_command(app);
  guidelight::add_render_command(app);
  guidelight::add_compare_command(app);
  guidelight::add_merge_command(app);
  guidelight::add_info_command(app);
  guidelight::add_guides_command(app);

  std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool asks_for_help =
      !arguments.empty() &&
      (arguments[0] == "-h" || arguments[0] == "--help" || arguments[0] == "--version");
  if (!asks_for_help && (arguments.empty() || !names_a_command(app, arguments[0]))) {
    arguments.insert(arguments.begin(), "view");
  }
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
  try {
    app.parse(std::move(arguments));
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kBadArguments;
  } catch (const std::exception& error) {
    fmt::print(stderr, "guidelight: {}\n", error.what());
    return kFailed;
  }
}
