#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "hatchway/core/error.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/plugin_host/new_style.hpp"
#include "hatchway/plugin_host/plugin_registry.hpp"
#include "program/commands.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

struct NewStyleArguments {
    std::string name;
    std::filesystem::path folder = ".";
};

constexpr std::size_t kLongestName = 64;

/// The words of C++20 that a style's name could be: they make no names in its source.
constexpr std::string_view kKeywords[] = {
    "alignas",     "alignof",  "and",        "and_eq",    "asm",       "auto",         "bitand",
    "bitor",       "bool",     "break",      "case",      "catch",     "char",         "char16_t",
    "char32_t",    "char8_t",  "class",      "co_await",  "co_return", "co_yield",     "compl",
    "concept",     "const",    "const_cast", "consteval", "constexpr", "constinit",    "continue",
    "decltype",    "default",  "delete",     "do",        "double",    "dynamic_cast", "else",
    "enum",        "explicit", "export",     "extern",    "false",     "float",        "for",
    "friend",      "goto",     "if",         "inline",    "int",       "long",         "mutable",
    "namespace",   "new",      "noexcept",   "not",       "not_eq",    "nullptr",      "operator",
    "or",          "or_eq",    "private",    "protected", "public",    "register",     "reinterpret_cast",
    "requires",    "return",   "short",      "signed",    "sizeof",    "static",       "static_assert",
    "static_cast", "struct",   "switch",     "template",  "this",      "thread_local", "throw",
    "true",        "try",      "typedef",    "typeid",    "typename",  "union",        "unsigned",
    "using",       "virtual",  "void",       "volatile",  "wchar_t",   "while",        "xor",
    "xor_eq"};

/// What the writer of the files does not know: names that work as files and fail later.
void refuse_taken_name(const std::string& name)
{
    const auto refuse = [&](const std::string& why, const std::string& expected) {
        return Error({.what = fmt::format("the style's name \"{}\" {}", name, why), .expected = expected});
    };
    if (name.size() > kLongestName) throw refuse("is too long", fmt::format("at most {} characters", kLongestName));
    if (std::find(std::begin(kKeywords), std::end(kKeywords), name) != std::end(kKeywords))
        throw refuse("is a word of C++", "another name");
    const PluginRegistry installed;
    for (const Plugin& plugin : installed.plugins())
        if (plugin.name == name) throw refuse("is taken: it comes with the program", "another name");
}

void write_style(const NewStyleArguments& arguments)
{
    refuse_taken_name(arguments.name);
    require_folder(arguments.folder, "--in");
    for (const std::filesystem::path& file : write_new_style(arguments.name, arguments.folder))
        print_line(file.string());
}

}  // namespace

void add_new_style_command(CommandLine app)
{
    auto arguments = std::make_shared<NewStyleArguments>();
    CommandLine command = app.add_subcommand("new-style", "Writes a complete style that draws, for you to change");
    command.add_option("name", arguments->name, "Its name: a-z, 0-9 and _").required().option_text("NAME");
    command.add_option("--in", arguments->folder, "The folder to write its folder into").option_text("DIR");
    command.callback([arguments] { write_style(*arguments); });
}

}  // namespace hw
