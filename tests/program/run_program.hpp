#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace hw::test {

/// What a run of the program ended with.
struct ProgramResult {
    int exit_code = -1;  ///< 128 + the signal's number for a crash, 124 when it ran out of time.
    std::string out;
    std::string err;
    double seconds = 0.0;
};

/// What a run may take; 0: as much as it likes.
struct ProgramLimits {
    unsigned cpu_s = 0;                ///< Of all its threads together.
    std::uint64_t memory_bytes = 0;    ///< Private, writable.
    bool is_root_like_others = false;  ///< What the modes of files forbid is forbidden to root, too.
};

/// Runs the built program with these arguments, its cache and state in a folder that goes away. `environment` are
/// NAME=VALUE settings; "NAME" alone unsets.
ProgramResult run_program(const std::vector<std::string>& arguments, double limit_s = 60.0,
                          const std::vector<std::string>& environment = {}, const ProgramLimits& limits = {});

/// The same in place of this process, with nothing on its standard streams: for a child that something else watches.
[[noreturn]] void become_program(const std::vector<std::string>& arguments,
                                 const std::vector<std::string>& environment = {});

/// A folder of its own for one test, removed at its end.
class TemporaryFolder {
 public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    /// Writes a text file and returns its name.
    std::string write(const std::string& name, const std::string& text) const;
    /// The names of what is in it, sorted.
    std::vector<std::string> names() const;

 private:
    std::filesystem::path path_;
};

std::string bytes_of(const std::filesystem::path& file);

inline const std::filesystem::path kContent = std::filesystem::path(HATCHWAY_SOURCE_DIR) / "content";

}  // namespace hw::test
