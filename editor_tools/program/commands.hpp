#pragma once

#include "program/command_line.hpp"

namespace hw {

// The subcommands. Each stands in its own file and runs when the command line has been read. It throws hw::Error for
// bad input and then has written nothing.

void add_walk_command(CommandLine app);
void add_render_command(CommandLine app);
void add_lines_command(CommandLine app);
void add_bake_command(CommandLine app);
void add_check_command(CommandLine app);
void add_compile_command(CommandLine app);
void add_info_command(CommandLine app);
void add_silhouettes_command(CommandLine app);
void add_export_edges_command(CommandLine app);
void add_measure_command(CommandLine app);
void add_report_command(CommandLine app);
void add_map_command(CommandLine app);
void add_pvs_command(CommandLine app);
void add_new_style_command(CommandLine app);
void add_schema_command(CommandLine app);
void add_try_plugin_command(CommandLine app);

}  // namespace hw
