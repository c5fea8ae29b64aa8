#pragma once

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

    /// At worst |pattern| / 64 x |text| steps, and seldom more than |text|.
    bool matches(std::string_view text) const;
    /// The same within a budget, from which its steps are taken. False, and 0 left, where it runs out.
    bool matches(std::string_view text, std::uint64_t& steps_left) const;

 private:
    void add_character(std::string_view token);
    std::uint64_t* row_of(unsigned char c) { return rows_.data() + words_ * c; }

    // A state is how many characters of the pattern match the text read so far; a set of states is a row of bits.
    std::size_t words_ = 0;                 ///< Of a set of states.
    std::vector<std::uint64_t> rows_;       ///< For each byte, the states that it leads out of, to the next.
    std::vector<std::uint64_t> runs_;       ///< The states that any character but '/' leaves as they are,
    std::vector<std::uint64_t> deep_runs_;  ///< and those that '/' does.
    std::size_t length_ = 0;                ///< Characters of the pattern: the last state.
    bool is_all_ = false;
};

/// Whether `text` matches a pattern that is used once.
bool glob_matches(std::string_view pattern, std::string_view text);

/// What is wrong with a pattern that a person wrote: a class that is never closed. Empty when nothing is.
std::string glob_fault(std::string_view pattern);

}  // namespace hw
