// Level files: any text must be read or refused by hw::Error, and what is read can be edited.

#include <cstdint>
#include <cstdlib>
#include <string>

#include "hatchway/core/error.hpp"
#include "hatchway/io/level/edit.hpp"
#include "hatchway/io/level/file.hpp"

namespace {

/// A level that can be read must also survive an edit, and then say what the edit says.
void edit(const std::string& text)
{
    const hw::StyleAssignment assignment{.nodes = "Hall/Column", .style = "ink"};
    const std::string edited = hw::with_assignments(text, std::span(&assignment, 1), "level.json");
    const hw::Level level = hw::parse_level(edited, "level.json");
    if (level.assign.empty() || level.assign.back().nodes != assignment.nodes) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text(reinterpret_cast<const char*>(data), size);
    try {
        hw::parse_level(text, "level.json");
    } catch (const hw::Error&) {
        return 0;
    }
    edit(text);
    return 0;
}
