#include "program/option_rules.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

/// A test on text, described by what it allows.
template <typename Test>
CLI::Validator rule(const std::string& allowed, Test is_good)
{
    return CLI::Validator(
        [allowed, is_good](std::string& text) {
            return is_good(text) ? std::string() : text + "; expected " + allowed;
        },
        allowed);
}

template <typename Number>
CLI::Validator range_rule(Number least, Number most)
{
    return rule(fmt::format("{} to {}", least, most), [least, most](const std::string& text) {
        Number number{};
        const char* end = text.data() + text.size();
        const auto [stop, status] = std::from_chars(text.data(), end, number);
        return status == std::errc() && stop == end && number >= least && number <= most;
    });
}

/// The subcommand that the words on the command line led to.
const CLI::App& reached_command(const CLI::App& app)
{
    const std::vector<CLI::App*> parsed = app.get_subcommands();
    return parsed.empty() ? app : reached_command(*parsed.back());
}

/// "hatchway map hatch".
std::string full_name(const CLI::App& command)
{
    const CLI::App* parent = command.get_parent();
    return parent ? full_name(*parent) + " " + command.get_name() : command.get_name();
}

std::string known_commands(const CLI::App& command)
{
    std::vector<std::string> names;
    for (const CLI::App* each : command.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(each->get_name());
    return fmt::format("one of: {}", fmt::join(names, ", "));
}

std::string known_options(const CLI::App& command)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        if (option->nonpositional()) names.push_back(option->get_name());
    return fmt::format("one of: {}", fmt::join(names, ", "));
}

Error unknown_word(const CLI::App& command, const std::string& word, bool wants_command)
{
    const std::string name = full_name(command);
    if (word.size() > 1 && word[0] == '-')
        return Error({.what = name + ": unknown option " + word, .expected = known_options(command)});
    if (wants_command) return Error({.what = name + ": unknown command " + word, .expected = known_commands(command)});
    return Error({.what = name + ": one word too many: " + word, .expected = "what " + name + " --help shows"});
}

}  // namespace

CLI::Validator number_in(double least, double most)
{
    return range_rule(least, most);
}

CLI::Validator whole_number_in(std::int64_t least, std::int64_t most)
{
    return range_rule(least, most);
}

CLI::Validator one_of(const std::vector<std::string>& words)
{
    const auto last = words.end() - 1;
    const std::string allowed =
        words.size() > 1 ? fmt::format("{} or {}", fmt::join(words.begin(), last, ", "), *last) : words.front();
    return rule(allowed, [words](const std::string& text) {
        return std::find(words.begin(), words.end(), text) != words.end();
    });
}

void refuse_empty_values(CLI::App& app)
{
    for (CLI::Option* option : app.get_options())
        if (option->get_type_size_max() > 0)
            option->check([](const std::string& text) { return text.empty() ? "is empty; expected a value" : ""; });
    for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) refuse_empty_values(*command);
}

Error usage_error(const CLI::App& app, const CLI::ParseError& error)
{
    const CLI::App& command = reached_command(app);
    const bool wants_command = !command.get_subcommands([](const CLI::App*) { return true; }).empty();
    const bool is_about_words =
        dynamic_cast<const CLI::RequiredError*>(&error) || dynamic_cast<const CLI::ExtrasError*>(&error);
    const std::vector<std::string> unknown = app.remaining(true);
    if (is_about_words && !unknown.empty()) return unknown_word(command, unknown.front(), wants_command);
    if (is_about_words && wants_command)
        return Error({.what = full_name(command) + ": no command", .expected = known_commands(command)});
    if (dynamic_cast<const CLI::ValidationError*>(&error)) return Error({.what = error.what()});
    const std::string name = full_name(command);
    return Error({.what = name + ": " + error.what(), .expected = "what " + name + " --help shows"});
}

}  // namespace hw
