#include "program/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

std::vector<const CLI::App*> subcommands(const CLI::App& command)
{
    return command.get_subcommands([](const CLI::App*) { return true; });
}

/// Gives every option of a command and its subcommands the rule that an empty value is a mistake.
void refuse_empty_values(CLI::App& app)
{
    for (CLI::Option* option : app.get_options())
        if (option->get_type_size_max() > 0)
            option->check([](const std::string& text) { return text.empty() ? "is empty; expected a value" : ""; });
    for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) refuse_empty_values(*command);
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
    for (const CLI::App* each : subcommands(command))
        if (!each->get_group().empty()) names.push_back(each->get_name());
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

/// A command line that could not be read.
Error usage_error(const CLI::App& app, const CLI::ParseError& error)
{
    const CLI::App& command = reached_command(app);
    const bool wants_command = !subcommands(command).empty();
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

}  // namespace

CommandOption CommandOption::required()
{
    option_->required();
    return *this;
}

CommandOption CommandOption::option_text(const std::string& text)
{
    option_->option_text(text);
    return *this;
}

CommandOption CommandOption::check(const OptionRule& rule)
{
    const auto objection = [rule](const std::string& text) {
        return rule.holds(text) ? std::string() : text + "; expected " + rule.allowed;
    };
    option_->check(objection, rule.allowed);
    return *this;
}

CommandOption CommandOption::delimiter(char separator)
{
    option_->delimiter(separator);
    return *this;
}

CommandOption CommandOption::one_value_each()
{
    option_->allow_extra_args(false);
    return *this;
}

CommandLine CommandLine::add_subcommand(const std::string& name, const std::string& help)
{
    return CommandLine(app_->add_subcommand(name, help));
}

void CommandLine::hide()
{
    app_->group("");
}

void CommandLine::require_subcommand()
{
    app_->require_subcommand(1);
}

template <typename Value>
CommandOption CommandLine::add_option(const std::string& names, Value& value, const std::string& help)
{
    return CommandOption(app_->add_option(names, value, help));
}

template CommandOption CommandLine::add_option(const std::string&, std::string&, const std::string&);
template CommandOption CommandLine::add_option(const std::string&, std::filesystem::path&, const std::string&);
template CommandOption CommandLine::add_option(const std::string&, int&, const std::string&);
template CommandOption CommandLine::add_option(const std::string&, double&, const std::string&);
template CommandOption CommandLine::add_option(const std::string&, std::uint32_t&, const std::string&);
template CommandOption CommandLine::add_option(const std::string&, std::uint64_t&, const std::string&);
template CommandOption CommandLine::add_option(const std::string&, std::optional<int>&, const std::string&);
template CommandOption CommandLine::add_option(const std::string&, std::optional<double>&, const std::string&);
template CommandOption CommandLine::add_option(const std::string&, std::optional<std::uint32_t>&, const std::string&);
template CommandOption CommandLine::add_option(const std::string&, std::vector<std::string>&, const std::string&);
template CommandOption CommandLine::add_option(const std::string&, std::vector<std::filesystem::path>&,
                                               const std::string&);
template CommandOption CommandLine::add_option(const std::string&, std::vector<int>&, const std::string&);
template CommandOption CommandLine::add_option(const std::string&, std::vector<double>&, const std::string&);

void CommandLine::add_flag(const std::string& names, bool& is_given, const std::string& help)
{
    app_->add_flag(names, is_given, help);
}

void CommandLine::add_flag(const std::string& names, const std::function<void()>& when_given, const std::string& help)
{
    app_->add_flag_callback(names, when_given, help);
}

void CommandLine::footer(const std::string& text)
{
    app_->footer(text);
}

void CommandLine::callback(const std::function<void()>& run)
{
    app_->callback(run);
}

std::vector<std::string> CommandLine::given(const std::vector<std::string>& but) const
{
    std::vector<std::string> words{full_name(*app_)};
    std::vector<std::string> options;
    for (const CLI::Option* option : app_->get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 || std::find(but.begin(), but.end(), name) != but.end()) continue;
        const bool is_option = option->nonpositional();
        std::vector<std::string>& list = is_option ? options : words;
        const bool is_flag = option->get_expected_max() == 0;
        const bool is_denied = is_flag && option->results().back() != "true";  // --sweep=false
        if (is_option) list.push_back(is_denied ? name + "=" + option->results().back() : name);
        if (is_flag) continue;
        const char separator = option->get_delimiter();
        if (separator == '\0')
            list.insert(list.end(), option->results().begin(), option->results().end());
        else
            list.push_back(fmt::format("{}", fmt::join(option->results(), std::string(1, separator))));
    }
    words.insert(words.end(), options.begin(), options.end());
    return words;
}

CommandLineReader::CommandLineReader(const std::string& program, const std::string& help)
    : app_(std::make_unique<CLI::App>(help, program))
{
    app_->fallthrough();
}

CommandLineReader::~CommandLineReader() = default;

CommandLine CommandLineReader::program()
{
    return CommandLine(app_.get());
}

void CommandLineReader::set_version(const std::string& text)
{
    app_->set_version_flag("--version", text);
}

void CommandLineReader::run(const std::vector<std::string>& words)
{
    refuse_empty_values(*app_);
    try {
        app_->parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 takes the last first
    } catch (const CLI::ParseError& error) {
        // Asking for help or the version is told as an error without a code.
        if (error.get_exit_code() != 0) throw usage_error(*app_, error);
        app_->exit(error);
    }
}

}  // namespace hw
