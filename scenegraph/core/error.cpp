#include "core/error.hpp"

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace hw {
namespace {

std::string message_of(const ErrorParts& parts)
{
    std::string message;
    if (!parts.file.empty()) message += parts.file + ": ";
    if (!parts.pointer.empty()) message += parts.pointer + ": ";
    message += parts.what;
    if (!parts.expected.empty()) message += "; expected " + parts.expected;
    return message;
}

}  // namespace

Error::Error(ErrorParts parts) : std::runtime_error(message_of(parts)), parts_(std::move(parts)) {}

int exit_code(const Error& error) { return error.parts().fault == Fault::ours ? 1 : 2; }

void assertion_failed(const char* condition, const char* file, int line)
{
    std::fprintf(stderr, "hatchway: internal error: %s does not hold (%s:%d)\n", condition, file, line);
    std::abort();
}

}  // namespace hw
