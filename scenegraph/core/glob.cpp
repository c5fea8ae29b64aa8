#include "hatchway/core/glob.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace hw {
namespace {

/// One step of a pattern: a set of characters, or a run of them.
struct Token {
    enum Kind { literal, any, one_of, run, deep_run } kind;
    char character = 0;
    std::string_view set = {};
    bool is_negated = false;
};

std::vector<Token> tokens_of(std::string_view pattern)
{
    std::vector<Token> tokens;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const char c = pattern[i];
        const std::size_t close = c == '[' ? pattern.find(']', i + 2) : std::string_view::npos;
        if (c == '*') {
            const bool is_deep = i + 1 < pattern.size() && pattern[i + 1] == '*';
            tokens.push_back({is_deep ? Token::deep_run : Token::run});
            i += is_deep ? 1 : 0;
        } else if (c == '?') {
            tokens.push_back({Token::any});
        } else if (close != std::string_view::npos) {
            const bool is_negated = pattern[i + 1] == '!';
            tokens.push_back(
                {Token::one_of, 0, pattern.substr(i + 1 + is_negated, close - i - 1 - is_negated), is_negated});
            i = close;
        } else {
            tokens.push_back({Token::literal, c});
        }
    }
    return tokens;
}

bool is_in_set(std::string_view set, char c)
{
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (i + 2 < set.size() && set[i + 1] == '-') {
            if (set[i] <= c && c <= set[i + 2]) return true;
            i += 2;
        } else if (set[i] == c) {
            return true;
        }
    }
    return false;
}

bool accepts(const Token& token, char c)
{
    switch (token.kind) {
        case Token::literal:
            return token.character == c;
        case Token::any:
            return c != '/';
        case Token::one_of:
            return c != '/' && is_in_set(token.set, c) != token.is_negated;
        case Token::run:
            return c != '/';
        case Token::deep_run:
            return true;
    }
    return false;
}

bool is_run(const Token& token)
{
    return token.kind == Token::run || token.kind == Token::deep_run;
}

}  // namespace

bool glob_matches(std::string_view pattern, std::string_view text)
{
    if (pattern == "*") return true;
    const std::vector<Token> tokens = tokens_of(pattern);
    // reached[i]: the first i tokens match the text read so far.
    std::vector<char> reached(tokens.size() + 1, 0);
    reached[0] = 1;
    for (std::size_t i = 0; i < tokens.size() && is_run(tokens[i]); ++i) reached[i + 1] = 1;
    for (const char c : text) {
        std::vector<char> next(tokens.size() + 1, 0);
        for (std::size_t i = 0; i < tokens.size(); ++i) {
            if (!accepts(tokens[i], c)) continue;
            if (is_run(tokens[i]) && (reached[i] || reached[i + 1])) next[i + 1] = 1;
            if (!is_run(tokens[i]) && reached[i]) next[i + 1] = 1;
        }
        for (std::size_t i = 0; i < tokens.size(); ++i)
            if (next[i] && is_run(tokens[i])) next[i + 1] = 1;
        reached.swap(next);
    }
    return reached[tokens.size()] != 0;
}

std::string glob_fault(std::string_view pattern)
{
    const std::vector<Token> tokens = tokens_of(pattern);
    const bool is_open = std::ranges::any_of(tokens, [](const Token& token) { return token.character == '['; });
    return is_open ? "a class [ that is never closed" : "";
}

}  // namespace hw
