
#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/io/level/schema.hpp"
#include "hatchway/plugin_host/make_style.hpp"
#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

struct SchemaArguments {
    PluginArguments plugins;
    std::filesystem::path out;
};

std::vector<StyleSchema> style_schemas(const PluginRegistry& registry)
{
    std::vector<StyleSchema> schemas;
    for (const Plugin& plugin : registry.plugins()) {
        if (plugin.kind != PluginKind::style) continue;
        try {
            SchemaCollector collector;
            visit_defaults(plugin, collector);
            schemas.push_back({plugin.name, plugin.summary, collector.params()});
        } catch (const Error& error) {
            log_warning(std::string(error.what()) + ": the schema is written without it");
        }
    }
    return schemas;
}

void write_schema(const SchemaArguments& arguments)
{
    require_writable(arguments.out, "--out");
    const PluginRegistry registry({.folders = arguments.plugins.folders, .trial = arguments.plugins.trial()});
    const std::string schema = level_schema(style_schemas(registry));
    if (arguments.out.empty())
        print_lines(schema);
    else
        write_file_atomically(arguments.out, schema);
}

}  // namespace

void add_schema_command(CommandLine app)
{
    auto arguments = std::make_shared<SchemaArguments>();
    CommandLine command =
        app.add_subcommand("schema", "Writes the JSON schema of level files, with all styles' parameters");
    add_plugin_arguments(command, arguments->plugins);
    command.add_option("--out", arguments->out, "The file to write; else it goes to the standard output")
        .option_text("FILE");
    command.callback([arguments] { write_schema(*arguments); });
}

}  // namespace hw
