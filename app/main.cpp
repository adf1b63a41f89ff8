#include <fcntl.h>

#include <algorithm>
#include <array>
#include <exception>
#include <string_view>

#include "app/commands.h"
#include "app/message.h"

namespace {

constexpr int kFailed = 1;
constexpr int kBadArguments = 2;

/// `guidelight SCENE` means `guidelight view SCENE`.
bool names_a_command(const CLI::App& app, std::string_view word) {
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  return std::any_of(commands.begin(), commands.end(),
                     [&](const CLI::App* command) { return command->get_name() == word; });
}

/// Where standard output or error is closed, the next file that is opened would take its place, and
/// messages end up in a picture. These places are taken so that nothing can be written there.
void take_standard_files() {
  for (int file = 0; file <= 2; ++file) {
    if (::fcntl(file, F_GETFD) == -1) ::open("/dev/null", O_RDONLY);
  }
}

int run(std::vector<std::string> arguments) {
  CLI::App app{"Guidelight: a viewer and path editor for hard light transport", "guidelight"};
  app.set_version_flag("--version", GUIDELIGHT_VERSION);
  app.require_subcommand(1);
  guidelight::add_view_command(app);
  guidelight::add_render_command(app);
  guidelight::add_compare_command(app);
  guidelight::add_merge_command(app);
  guidelight::add_info_command(app);
  guidelight::add_guides_command(app);

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
    guidelight::say("guidelight: {}\n", error.what());
    return kFailed;
  }
}

}  // namespace

int main(int argc, char** argv) {
  take_standard_files();
  const int status = run({argv + 1, argv + argc});
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  guidelight::say("guidelight: the output could not be written: direct it elsewhere\n");
  return kFailed;
}
