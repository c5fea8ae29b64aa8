#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// The command line, for commands: this and the source beside it stand between them and CLI11, which is all header and
// costs whoever includes it seconds of compile time. Functions are named as in CLI11.

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace hw {

/// What the text of an option may be.
struct OptionRule {
    std::string allowed;                            ///< Said to the user: "1 to 170".
    std::function<bool(const std::string&)> holds;  ///< Of the text as it was typed.
};

/// One option of a command. A handle: copies mean the same option.
class CommandOption {
 public:
    explicit CommandOption(CLI::Option* option) : option_(option) {}

    CommandOption required();
    CommandOption option_text(const std::string& text);  ///< What --help shows in place of the type: "FILE.png".
    CommandOption check(const OptionRule& rule);         ///< Of each value.
    CommandOption delimiter(char separator);             ///< One word holds many values.
    CommandOption one_value_each();                      ///< A list takes the next value only after its name again.

 private:
    CLI::Option* option_;
};

/// A command, or the program itself. A handle, too.
class CommandLine {
 public:
    explicit CommandLine(CLI::App* app) : app_(app) {}

    CommandLine add_subcommand(const std::string& name, const std::string& help);
    void require_subcommand();
    void hide();  ///< From --help and from lists of what is known.

    /// "--name" or "-n,--name", or "name" for a word by its place. The value stays as it is unless the option is given;
    /// it must outlive the reading. For std::string, path, int, double, uint32 and uint64, std::optional of a number
    /// and std::vector of strings, paths, ints and doubles.
    template <typename Value>
    CommandOption add_option(const std::string& names, Value& value, const std::string& help);
    void add_flag(const std::string& names, bool& is_given, const std::string& help);
    void add_flag(const std::string& names, const std::function<void()>& when_given, const std::string& help);

    void footer(const std::string& text);
    void callback(const std::function<void()>& run);  ///< Called when the whole command line has been read.

    /// The words that led here and what was given to this command, in that order: "hatchway", "measure", "pvs",
    /// "hall.glb", "--rays", "1000", "--sweep". Words by their place come before options; `but` are left out with their
    /// values.
    std::vector<std::string> given(const std::vector<std::string>& but) const;

 private:
    CLI::App* app_;
};

class CommandLineReader {
 public:
    CommandLineReader(const std::string& program, const std::string& help);
    ~CommandLineReader();

    CommandLine program();
    void set_version(const std::string& text);  ///< What --version prints.

    /// Runs the command that the words name, or prints the help or the version that they ask for. An empty value is a
    /// mistake, not a default. Throws hw::Error, of one line, for words that cannot be read: a word that nobody knows
    /// is named before anything that is missing, with the words that are known there. Passes on what the command
    /// throws.
    void run(const std::vector<std::string>& words);

 private:
    std::unique_ptr<CLI::App> app_;
};

}  // namespace hw
