#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
class Validator;
}  // namespace CLI

namespace hw {

class Error;

/// What an option may be. Text that is no number, or NaN, is in no range.
CLI::Validator number_in(double least, double most);
CLI::Validator whole_number_in(std::int64_t least, std::int64_t most);
CLI::Validator one_of(const std::vector<std::string>& words);

/// Gives every option of a program and its subcommands the rule that an empty value is a mistake, not a default.
void refuse_empty_values(CLI::App& app);

/// A command line that could not be read, in one line. A word that nobody knows is named before anything that is
/// missing, with the words that are known there.
Error usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace hw
