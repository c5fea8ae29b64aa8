#include "program/option_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace hw {
namespace {

template <typename Number>
OptionRule range_rule(Number least, Number most)
{
    return {fmt::format("{} to {}", least, most), [least, most](const std::string& text) {
                Number number{};
                const char* end = text.data() + text.size();
                const auto [stop, status] = std::from_chars(text.data(), end, number);
                return status == std::errc() && stop == end && number >= least && number <= most;
            }};
}

}  // namespace

OptionRule number_in(double least, double most)
{
    return range_rule(least, most);
}

OptionRule whole_number_in(std::int64_t least, std::int64_t most)
{
    return range_rule(least, most);
}

OptionRule one_of(const std::vector<std::string>& words)
{
    const auto last = words.end() - 1;
    const std::string allowed =
        words.size() > 1 ? fmt::format("{} or {}", fmt::join(words.begin(), last, ", "), *last) : words.front();
    return {allowed,
            [words](const std::string& text) { return std::find(words.begin(), words.end(), text) != words.end(); }};
}

}  // namespace hw
