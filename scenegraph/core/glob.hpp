#pragma once

#include <bitset>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hw {

/// A shell pattern, read once: `*` any run of characters without '/', `**` any run with it, `?` one character, `[a-c]`
/// and `[!a-c]` a class; neither is '/'. The pattern "*" alone matches everything, so that "*" means all objects.
class Glob {
 public:
    explicit Glob(std::string_view pattern);

    /// Linear memory, no recursion; at worst |pattern| x |text| steps, and seldom more than |text|.
    bool matches(std::string_view text) const;
    /// The same within a budget, from which its steps are taken. False, and 0 left, where it runs out.
    bool matches(std::string_view text, std::uint64_t& steps_left) const;

 private:
    /// One step of a pattern: a set of characters, or a run of them.
    struct Token {
        enum Kind { literal, any, one_of, run, deep_run } kind;
        unsigned char character = 0;
        std::uint32_t set = 0;  ///< Index into sets_.
    };
    bool is_run(std::size_t token) const;
    bool accepts(const Token& token, unsigned char c) const;
    void add_run(bool is_deep);
    void reach(std::vector<std::uint32_t>& states, std::uint32_t state) const;

    std::vector<Token> tokens_;
    std::vector<std::bitset<256>> sets_;
    std::size_t least_length_ = 0;  ///< Of a text that matches.
    bool is_all_ = false;
};

/// Whether `text` matches a pattern that is used once.
bool glob_matches(std::string_view pattern, std::string_view text);

/// What is wrong with a pattern that a person wrote: a class that is never closed. Empty when nothing is.
std::string glob_fault(std::string_view pattern);

}  // namespace hw
