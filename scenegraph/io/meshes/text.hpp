#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hw {

/// The lines of a text, ended by \n, \r\n or \r. Private to io, as all of this room but import.hpp.
class TextLines {
 public:
    explicit TextLines(std::string_view text) : rest_(text) {}

    /// The next line without its end; false behind the last.
    bool next(std::string_view& line);
    std::uint64_t number() const { return number_; }  ///< Of the line given last, from 1.
    std::string_view rest() const { return rest_; }   ///< What follows it.

 private:
    std::string_view rest_;
    std::uint64_t number_ = 0;
};

/// The next word of a line, cut from its front; empty when there is none. Words stand between blanks.
std::string_view next_word(std::string_view& line);

/// The words that a line still has.
std::size_t count_words(std::string_view line);

/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);

/// The line up to the sign '#'.
std::string_view without_comment(std::string_view line);

/// A whole word as a number, whatever the locale: NaN for one that is not finite or too large for float, nothing for
/// what is no number.
std::optional<double> parse_number(std::string_view word);
std::optional<std::int64_t> parse_whole(std::string_view word);

/// Where in a file something stands: "line 3", "byte 12", "face 7".
struct FilePlace {
    const std::string& file;
    const char* unit;
    std::uint64_t number;

    /// Throws hw::Error.
    [[noreturn]] void refuse(std::string what, std::string expected = {}) const;
};

}  // namespace hw
