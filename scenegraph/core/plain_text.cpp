#include "hatchway/core/plain_text.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>

namespace hw {
namespace {

struct Character {
    std::uint32_t code = 0;
    std::size_t bytes = 0;  ///< 0: no UTF-8.
};

Character first_character(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80) return {byte(0), 1};
    const std::size_t bytes = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
    constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
    if (byte(0) < 0xc2 || byte(0) > 0xf4 || bytes > text.size()) return {};
    std::uint32_t code = byte(0) & (0x7fu >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return {};
        code = code << 6 | (byte(i) & 0x3fu);
    }
    const bool is_surrogate = code >= 0xd800 && code <= 0xdfff;
    return code < kLeast[bytes] || code > 0x10ffff || is_surrogate ? Character{} : Character{code, bytes};
}

bool is_control(std::uint32_t code)
{
    return code < 0x20 || (code >= 0x7f && code < 0xa0);
}

/// Marks that change the direction of writing, and line separators.
bool is_layout(std::uint32_t code)
{
    return code == 0x061c || code == 0x200e || code == 0x200f || (code >= 0x2028 && code <= 0x202e) ||
           (code >= 0x2066 && code <= 0x2069);
}

using WriteOut = std::string (*)(std::uint32_t code);

std::string as_json(std::uint32_t code)
{
    return fmt::format("\\u{:04x}", code);
}

std::string written_out(std::uint32_t code)
{
    if (code == '\n') return "\\n";
    if (code == '\t') return "\\t";
    return code < 0x100 ? fmt::format("\\x{:02x}", code) : fmt::format("\\u{:04x}", code);
}

template <typename IsControl>
std::string without_controls(std::string_view text, WriteOut write_out, IsControl is_control)
{
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const Character character = first_character(text);
        const std::size_t bytes = character.bytes > 0 ? character.bytes : 1;
        if (character.bytes == 0)
            result += write_out(static_cast<unsigned char>(text[0]));
        else if (is_control(character.code) || is_layout(character.code))
            result += write_out(character.code);
        else
            result += text.substr(0, bytes);
        text.remove_prefix(bytes);
    }
    return result;
}

}  // namespace

std::string plain_text(std::string_view text)
{
    return without_controls(text, written_out, is_control);
}

std::string plain_json(std::string_view json)
{
    // What is below a space is between values, or was written out already.
    return without_controls(json, as_json, [](std::uint32_t code) { return code >= 0x7f && is_control(code); });
}

void print_line(std::string_view line)
{
    print_lines(plain_text(line) + '\n');
}

void print_lines(std::string_view lines)
{
    std::string text;
    while (!lines.empty()) {
        const std::size_t end = lines.find('\n');
        text += plain_text(lines.substr(0, end)) + '\n';
        lines.remove_prefix(end == std::string_view::npos ? lines.size() : end + 1);
    }
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
}

}  // namespace hw
