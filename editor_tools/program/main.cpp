#include <filesystem>

#include "hatchway/core/budget.hpp"
#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/gl/context.hpp"
#include "program/commands.hpp"
#include "program/option_rules.hpp"

namespace {

constexpr int kDone = 0;
constexpr int kOurFault = 1;
constexpr int kBadUsage = 2;

void add_general_options(hw::CommandLine app)
{
    app.require_subcommand();
    app.add_flag(
        "--quiet", [] { hw::set_log_level(hw::LogLevel::error); }, "Log errors only");
    app.add_flag(
        "--verbose", [] { hw::set_log_level(hw::LogLevel::debug); }, "Log details, too");
    app.add_option("--budget-factor", hw::Budget::factor(),
                   "Opens levels this many times as large as the limits for strangers' files allow")
        .check(hw::number_in(1.0, 1e6));
    app.add_flag(
        "--as-software", [] { hw::take_devices_for(hw::DeviceKind::software); },
        "Draw as on a software renderer, whatever the device is");
    app.add_flag(
        "--as-hardware", [] { hw::take_devices_for(hw::DeviceKind::hardware); },
        "Draw as on a graphics card, whatever the device is");
    app.footer("Exit codes: 0 done, 1 our fault, 2 bad usage or bad input.");
}

void add_commands(hw::CommandLine app)
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
    hw::add_try_plugin_command(app);
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        hw::CommandLineReader line(
            "hatchway",
            "Walk through levels in which every object has its own style: photoreal, pen and ink, or a mix.");
        line.set_version("hatchway " HATCHWAY_VERSION);
        add_general_options(line.program());
        add_commands(line.program());
        line.run({argv + 1, argv + argc});
        return kDone;
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
