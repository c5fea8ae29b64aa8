#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace hw {

/// How a trial ended.
struct TrialResult {
    std::string why;         ///< Why the library must not be loaded, in one sentence; empty: it may.
    bool is_drawn = true;    ///< False: it was prepared alone, since there is no device to draw with.
    bool is_started = true;  ///< False: it could not be tried at all.
};

/// Loads the library in a process of its own, a group of its own, and draws a small frame with it (try_library.hpp):
/// `hatchway try-plugin LIBRARY` of this installation. What has not ended after ten seconds is killed, with all that it
/// started. Blocks until then.
TrialResult try_in_process(const std::filesystem::path& library);

/// The child's side: takes the limits (one gigabyte of memory, no core dump), goes when its parent goes, and tells it
/// how far it came. What the library prints goes nowhere.
class TrialReport {
 public:
    TrialReport();

    /// What is about to be done, as a message would say it: "being loaded".
    void step(std::string_view doing) const { tell(doing); }
    /// The trial is over; what still comes is the library's own way out.
    void end(bool is_drawn) const;
    /// Ends the process.
    [[noreturn]] void fail_for_memory() const;

 private:
    void tell(std::string_view line) const;

    int pipe_;
};

}  // namespace hw
