#include <CLI/CLI.hpp>
#include <iostream>

#include "hatchway/commands.hpp"
#include "plugin_host/new_style.hpp"

namespace hw {
namespace {

struct NewStyleArguments {
    std::string name;
    std::filesystem::path folder = ".";
};

void write_style(const NewStyleArguments& arguments)
{
    for (const std::filesystem::path& file : write_new_style(arguments.name, arguments.folder))
        std::cout << file.string() << '\n';
}

}  // namespace

void add_new_style_command(CLI::App& app)
{
    auto arguments = std::make_shared<NewStyleArguments>();
    CLI::App* command = app.add_subcommand("new-style", "Writes a complete style that draws, for you to change");
    command->add_option("name", arguments->name, "Its name: a-z, 0-9 and _")->required()->option_text("NAME");
    command->add_option("--in", arguments->folder, "The folder to write its folder into")->option_text("DIR");
    command->callback([arguments] { write_style(*arguments); });
}

}  // namespace hw
