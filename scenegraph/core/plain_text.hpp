#pragma once

#include <string>
#include <string_view>

namespace hw {

/// The text in one line that no terminal obeys: control characters (C0, DEL, C1), what turns the direction of writing,
/// and bytes that are no UTF-8 are written out: "\\n", "\\x1b", "\\u202e". All else stays as it is.
std::string plain_text(std::string_view text);

/// A JSON text without such characters, too: they are written "\u007f", as JSON has it. Its strings are UTF-8 already.
std::string plain_json(std::string_view json);

/// Writes a result to stdout, one line, as plain_text(). The only way there for text with names of files in it.
void print_line(std::string_view line);

/// The same for several lines: what stands between line breaks. For text whose names are plain_text() already.
void print_lines(std::string_view lines);

}  // namespace hw
