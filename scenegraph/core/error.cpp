#include "hatchway/core/error.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "hatchway/core/plain_text.hpp"

namespace hw {
namespace {

// Names come from strangers' files: however long, a message stays readable.
constexpr std::size_t kMostOfPath = 400;
constexpr std::size_t kMostOfWord = 160;
constexpr std::size_t kMostOfPart = 1500;

bool is_inside_character(char c)
{
    return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

/// At most about `most` bytes: the middle is left out, between whole UTF-8 characters.
std::string shortened(std::string_view text, std::size_t most)
{
    if (text.size() <= most) return std::string(text);
    std::size_t head = most * 2 / 3;
    std::size_t tail = text.size() - most / 3;
    while (head > 0 && is_inside_character(text[head])) --head;
    while (tail < text.size() && is_inside_character(text[tail])) ++tail;
    return std::string(text.substr(0, head)) + "..." + std::string(text.substr(tail));
}

/// A part in one line, each of its words and itself shortened.
std::string one_line(std::string_view text)
{
    std::string result;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        result += plain_text(shortened(text.substr(begin, end - begin), kMostOfWord));
        if (end < text.size()) result += ' ';
        begin = end + 1;
    }
    return shortened(result, kMostOfPart);
}

std::string message_of(const ErrorParts& parts)
{
    std::string message;
    if (!parts.file.empty()) message += plain_text(shortened(parts.file, kMostOfPath)) + ": ";
    if (!parts.pointer.empty()) message += one_line(parts.pointer) + ": ";
    message += one_line(parts.what);
    if (!parts.expected.empty()) message += "; expected " + one_line(parts.expected);
    return message;
}

}  // namespace

Error::Error(ErrorParts parts) : std::runtime_error(message_of(parts)), parts_(std::move(parts)) {}

int exit_code(const Error& error)
{
    return error.parts().fault == Fault::ours ? 1 : 2;
}

void assertion_failed(const char* condition, const char* file, int line)
{
    std::fprintf(stderr, "hatchway: internal error: %s does not hold (%s:%d)\n", condition, file, line);
    std::abort();
}

}  // namespace hw
