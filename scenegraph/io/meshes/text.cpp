#include "hatchway/io/meshes/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

}  // namespace

bool TextLines::next(std::string_view& line)
{
    if (rest_.empty()) return false;
    std::size_t end = 0;
    while (end < rest_.size() && rest_[end] != '\n' && rest_[end] != '\r') ++end;
    line = rest_.substr(0, end);
    if (end + 1 < rest_.size() && rest_[end] == '\r' && rest_[end + 1] == '\n') ++end;
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    return true;
}

std::string_view next_word(std::string_view& line)
{
    std::size_t begin = 0;
    while (begin < line.size() && is_blank(line[begin])) ++begin;
    std::size_t end = begin;
    while (end < line.size() && !is_blank(line[end])) ++end;
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
}

std::size_t count_words(std::string_view line)
{
    std::size_t count = 0;
    while (!next_word(line).empty()) ++count;
    return count;
}

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

std::string_view without_comment(std::string_view line)
{
    return line.substr(0, line.find('#'));
}

std::optional<double> parse_number(std::string_view word)
{
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || end != word.data() + word.size() || error == std::errc::invalid_argument) return {};
    const bool is_float = error == std::errc() && std::abs(value) <= std::numeric_limits<float>::max();
    return is_float ? value : std::numeric_limits<double>::quiet_NaN();
}

std::optional<std::int64_t> parse_whole(std::string_view word)
{
    if (word.starts_with('+')) word.remove_prefix(1);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || end != word.data() + word.size() || error != std::errc()) return {};
    return value;
}

void FilePlace::refuse(std::string what, std::string expected) const
{
    throw Error({.what = std::move(what),
                 .file = file,
                 .pointer = unit + (' ' + std::to_string(number)),
                 .expected = std::move(expected)});
}

}  // namespace hw
