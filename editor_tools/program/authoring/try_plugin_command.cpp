#include "hatchway/io/images/images.hpp"
#include "hatchway/plugin_host/try_library.hpp"
#include "program/commands.hpp"

namespace hw {

void add_try_plugin_command(CommandLine app)
{
    auto library = std::make_shared<std::filesystem::path>();
    CommandLine command = app.add_subcommand("try-plugin", "What the program starts to try a plugin");
    command.add_option("library", *library, "The library").required();
    command.hide();
    command.callback([library] { try_library(*library, read_image); });
}

}  // namespace hw
