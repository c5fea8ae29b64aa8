#pragma once

#include <stdexcept>
#include <string>

namespace hw {

/// Whose fault an error is; it decides the program's exit code.
enum class Fault : unsigned char {
    input,   ///< A file, level, plugin or command line that we were given: exit code 2.
    device,  ///< No display, no GPU, a driver that lacks something: exit code 2.
    ours,    ///< Everything else: exit code 1.
};

/// The parts of an error message. Empty parts are left out.
struct ErrorParts {
    std::string what;      ///< What was found, in one sentence without a full stop.
    std::string file;      ///< The file it was found in.
    std::string pointer;   ///< Where in the file: a JSON pointer ("/styles/assumed/plugin"), "byte 12", "line 3".
    std::string expected;  ///< What is allowed there.
    Fault fault = Fault::input;
};

/// The one exception of the engine: bad input, a shader that does not compile, a missing device.
/// what() reads "file: /pointer: what was found; expected what is allowed", in one line: control characters are written
/// out and long names shortened. parts() has them as they were given.
class Error : public std::runtime_error {
 public:
    explicit Error(ErrorParts parts);
    const ErrorParts& parts() const { return parts_; }

 private:
    ErrorParts parts_;
};

/// The process exit code of an error: 2 for Fault::input and Fault::device, 1 for Fault::ours.
int exit_code(const Error& error);

/// Ends the program after a message: a broken promise of our own code, never of the input's.
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);

}  // namespace hw

/// Checks what only our own mistake can break. Stays on in release builds: it stands outside of inner loops.
#define HW_ASSERT(condition) ((condition) ? void(0) : ::hw::assertion_failed(#condition, __FILE__, __LINE__))
