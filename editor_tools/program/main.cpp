#include <CLI/CLI.hpp>
#include <filesystem>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "program/commands.hpp"
#include "program/option_rules.hpp"

namespace {

constexpr int kDone = 0;
constexpr int kOurFault = 1;
constexpr int kBadUsage = 2;

void add_general_options(CLI::App& app)
{
    app.name("hatchway");
    app.set_version_flag("--version", "hatchway " HATCHWAY_VERSION);
    app.require_subcommand(1);
    app.fallthrough();
    app.add_flag_callback(
        "--quiet", [] { hw::set_log_level(hw::LogLevel::error); }, "Log errors only");
    app.add_flag_callback(
        "--verbose", [] { hw::set_log_level(hw::LogLevel::debug); }, "Log details, too");
    app.footer("Exit codes: 0 done, 1 our fault, 2 bad usage or bad input.");
}

void add_commands(CLI::App& app)
{
    hw::add_walk_command(app);
    hw::add_render_command(app);
    hw::add_lines_command(app);
    hw::add_bake_command(app);
    hw::add_check_command(app);
    hw::add_compile_command(app);
    hw::add_info_command(app);
    hw::add_silhouettes_command(app);
    hw::add_export_edges_command(app);
    hw::add_measure_command(app);
    hw::add_report_command(app);
    hw::add_map_command(app);
    hw::add_pvs_command(app);
    hw::add_new_style_command(app);
    hw::add_schema_command(app);
    hw::refuse_empty_values(app);
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app("Walk through levels in which every object has its own style: photoreal, pen and ink, or a mix.");
    add_general_options(app);
    add_commands(app);
    try {
        app.parse(argc, argv);
        return kDone;
    } catch (const CLI::ParseError& error) {
        // Asking for help or the version is told as an error without a code.
        if (error.get_exit_code() == 0) return app.exit(error);
        hw::log_error(hw::usage_error(app, error).what());
        return kBadUsage;
    } catch (const hw::Error& error) {
        hw::log_error(error.what());
        return hw::exit_code(error);
    } catch (const std::filesystem::filesystem_error& error) {
        // A name that a file system refuses, such as one that is too long.
        hw::log_error(hw::Error({.what = error.code().message(), .file = error.path1().string()}).what());
        return kBadUsage;
    } catch (const std::exception& error) {
        hw::log_error(std::string("internal error: ") + error.what());
        return kOurFault;
    }
}
