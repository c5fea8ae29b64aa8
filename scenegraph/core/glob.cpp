// A pattern is followed by the set of its states, 64 a word: a character moves each state that accepts it to the next
// and leaves those at a run where they are. Only the words between the lowest and the highest state are looked at.
#include "hatchway/core/glob.hpp"

#include <algorithm>
#include <bitset>
#include <limits>

namespace hw {
namespace {

/// Where the class ends that begins at `open`; npos where it never does.
std::size_t end_of_class(std::string_view pattern, std::size_t open)
{
    return pattern[open] == '[' ? pattern.find(']', open + 2) : std::string_view::npos;
}

/// The characters of a class, without its brackets.
std::bitset<256> set_of(std::string_view stated)
{
    const bool is_negated = stated.starts_with('!');
    if (is_negated) stated.remove_prefix(1);
    std::bitset<256> set;
    for (std::size_t i = 0; i < stated.size(); ++i) {
        const bool is_range = i + 2 < stated.size() && stated[i + 1] == '-';
        const char last = is_range ? stated[i + 2] : stated[i];
        for (int c = stated[i]; c <= last; ++c) set.set(static_cast<unsigned char>(c));
        i += is_range ? 2 : 0;
    }
    return is_negated ? ~set : set;
}

/// The tokens of a pattern: "**", "[...]" or one character.
std::vector<std::string_view> tokens_of(std::string_view pattern)
{
    std::vector<std::string_view> tokens;
    const std::size_t last_close = pattern.rfind(']');  // past it no class is closed, and none needs to be looked for
    for (std::size_t i = 0; i < pattern.size(); i += tokens.back().size()) {
        const bool may_close = last_close != std::string_view::npos && i < last_close;
        const std::size_t close = may_close ? end_of_class(pattern, i) : std::string_view::npos;
        const std::size_t size = close != std::string_view::npos ? close + 1 - i : pattern.substr(i, 2) == "**" ? 2 : 1;
        tokens.push_back(pattern.substr(i, size));
    }
    return tokens;
}

bool is_run(std::string_view token)
{
    return token == "*" || token == "**";
}

void add(std::uint64_t* states, std::size_t state)
{
    states[state / 64] |= std::uint64_t{1} << (state % 64);
}

/// The states after a character, where `lowest` and `highest` are the words that hold any. Downwards, for a state moves
/// up.
void step(std::uint64_t* states, std::size_t lowest, std::size_t highest, const std::uint64_t* row,
          const std::uint64_t* stays)
{
    for (std::size_t word = highest; word > lowest; --word)
        states[word] =
            (states[word] & row[word]) << 1 | (states[word - 1] & row[word - 1]) >> 63 | (states[word] & stays[word]);
    states[lowest] = (states[lowest] & row[lowest]) << 1 | (states[lowest] & stays[lowest]);
}

}  // namespace

Glob::Glob(std::string_view pattern) : is_all_(pattern == "*")
{
    const std::vector<std::string_view> tokens = tokens_of(pattern);
    const std::size_t runs = static_cast<std::size_t>(std::count_if(tokens.begin(), tokens.end(), is_run));
    words_ = (tokens.size() - runs) / 64 + 1;
    std::vector<std::uint64_t> any(words_);
    std::size_t state = 0;
    for (const std::string_view token : tokens) {
        if (token == "?") add(any.data(), state);
        state += is_run(token) ? 0 : 1;
    }
    runs_.resize(words_);
    deep_runs_.resize(words_);
    rows_.resize(256 * words_);
    for (std::size_t c = 0; c < 256; ++c)
        if (c != '/') std::copy(any.begin(), any.end(), row_of(static_cast<unsigned char>(c)));
    for (const std::string_view token : tokens) {
        if (is_run(token)) add(runs_.data(), length_);
        if (token == "**") add(deep_runs_.data(), length_);
        if (!is_run(token)) add_character(token);
    }
}

void Glob::add_character(std::string_view token)
{
    if (token.size() > 1) {
        const std::bitset<256> set = set_of(token.substr(1, token.size() - 2));
        for (std::size_t c = 0; c < 256; ++c)
            if (c != '/' && set[c]) add(row_of(static_cast<unsigned char>(c)), length_);
    } else if (token != "?") {
        add(row_of(static_cast<unsigned char>(token[0])), length_);
    }
    ++length_;
}

bool Glob::matches(std::string_view text, std::uint64_t& steps_left) const
{
    if (is_all_) return true;
    if (text.size() < length_) return false;
    std::vector<std::uint64_t> states(words_);
    states[0] = 1;
    std::size_t lowest = 0, highest = 0;
    for (const char c : text) {
        highest = std::min(highest + 1, words_ - 1);
        const std::size_t steps = highest - lowest + 1;
        if (steps_left < steps) {
            steps_left = 0;
            return false;
        }
        steps_left -= steps;
        step(states.data(), lowest, highest, rows_.data() + words_ * static_cast<unsigned char>(c),
             c == '/' ? deep_runs_.data() : runs_.data());
        while (highest > lowest && states[highest] == 0) --highest;
        while (lowest < highest && states[lowest] == 0) ++lowest;
        if (states[lowest] == 0) return false;
    }
    return (states[length_ / 64] >> (length_ % 64) & 1) != 0;
}

bool Glob::matches(std::string_view text) const
{
    std::uint64_t steps = std::numeric_limits<std::uint64_t>::max();
    return matches(text, steps);
}

bool glob_matches(std::string_view pattern, std::string_view text)
{
    return Glob(pattern).matches(text);
}

std::string glob_fault(std::string_view pattern)
{
    for (const std::string_view token : tokens_of(pattern))
        if (token == "[") return "a class [ that is never closed";
    return "";
}

}  // namespace hw
