// A pattern is followed from token to token. A state is how many tokens match the text read so far; the states are kept
// as a rising list, which is short: a text that leaves the pattern has none, and a run adds one.
#include "hatchway/core/glob.hpp"

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

}  // namespace

Glob::Glob(std::string_view pattern) : is_all_(pattern == "*")
{
    const std::size_t last_close = pattern.rfind(']');  // past it no class is closed, and none needs to be looked for
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const char c = pattern[i];
        const bool may_close = last_close != std::string_view::npos && i < last_close;
        const std::size_t close = may_close ? end_of_class(pattern, i) : std::string_view::npos;
        if (c == '*') {
            const bool is_deep = i + 1 < pattern.size() && pattern[i + 1] == '*';
            add_run(is_deep);
            i += is_deep ? 1 : 0;
            continue;
        }
        ++least_length_;
        if (c == '?') {
            tokens_.push_back({Token::any});
        } else if (close != std::string_view::npos) {
            tokens_.push_back({Token::one_of, 0, static_cast<std::uint32_t>(sets_.size())});
            sets_.push_back(set_of(pattern.substr(i + 1, close - i - 1)));
            i = close;
        } else {
            tokens_.push_back({Token::literal, static_cast<unsigned char>(c)});
        }
    }
}

/// Runs that follow each other are one.
void Glob::add_run(bool is_deep)
{
    if (tokens_.empty() || !is_run(tokens_.size() - 1)) tokens_.push_back({Token::run});
    if (is_deep) tokens_.back().kind = Token::deep_run;
}

bool Glob::is_run(std::size_t token) const
{
    return token < tokens_.size() && (tokens_[token].kind == Token::run || tokens_[token].kind == Token::deep_run);
}

bool Glob::accepts(const Token& token, unsigned char c) const
{
    switch (token.kind) {
        case Token::literal:
            return token.character == c;
        case Token::any:
        case Token::run:
            return c != '/';
        case Token::one_of:
            return c != '/' && sets_[token.set][c];
        case Token::deep_run:
            return true;
    }
    return false;
}

/// Adds a state, and the one past an empty run.
void Glob::reach(std::vector<std::uint32_t>& states, std::uint32_t state) const
{
    if (states.empty() || states.back() < state) states.push_back(state);
    if (is_run(state) && states.back() < state + 1) states.push_back(state + 1);
}

bool Glob::matches(std::string_view text, std::uint64_t& steps_left) const
{
    if (is_all_) return true;
    if (text.size() < least_length_) return false;
    std::vector<std::uint32_t> states, next;
    reach(states, 0);
    for (const char c : text) {
        if (states.empty()) return false;
        if (steps_left < states.size()) {
            steps_left = 0;
            return false;
        }
        steps_left -= states.size();
        next.clear();
        for (const std::uint32_t state : states) {
            if (state == tokens_.size() || !accepts(tokens_[state], static_cast<unsigned char>(c))) continue;
            reach(next, is_run(state) ? state : state + 1);
        }
        states.swap(next);
    }
    return !states.empty() && states.back() == tokens_.size();
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
    const std::size_t last_close = pattern.rfind(']');
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        if (pattern[i] != '[') continue;
        const bool may_close = last_close != std::string_view::npos && i < last_close;
        const std::size_t close = may_close ? end_of_class(pattern, i) : std::string_view::npos;
        if (close == std::string_view::npos) return "a class [ that is never closed";
        i = close;
    }
    return "";
}

}  // namespace hw
