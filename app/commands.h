#pragma once

#include <CLI/CLI.hpp>

namespace guidelight {

/// Each adds one sub-command to the command line; it runs when the line has been parsed. Failures
/// leave as exceptions, and main() turns them into one line and exit status 1.
void add_view_command(CLI::App& app);
void add_render_command(CLI::App& app);
void add_compare_command(CLI::App& app);
void add_merge_command(CLI::App& app);
void add_info_command(CLI::App& app);
void add_guides_command(CLI::App& app);

}  // namespace guidelight
