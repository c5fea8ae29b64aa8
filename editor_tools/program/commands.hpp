#pragma once

namespace CLI {
class App;
}

namespace hw {

// The subcommands. Each stands in its own file and runs when the command line has been read. It throws hw::Error for
// bad input and then has written nothing.

void add_walk_command(CLI::App& app);
void add_render_command(CLI::App& app);
void add_lines_command(CLI::App& app);
void add_bake_command(CLI::App& app);
void add_check_command(CLI::App& app);
void add_compile_command(CLI::App& app);
void add_info_command(CLI::App& app);
void add_silhouettes_command(CLI::App& app);
void add_export_edges_command(CLI::App& app);
void add_measure_command(CLI::App& app);
void add_report_command(CLI::App& app);
void add_map_command(CLI::App& app);
void add_pvs_command(CLI::App& app);
void add_new_style_command(CLI::App& app);
void add_schema_command(CLI::App& app);

}  // namespace hw
