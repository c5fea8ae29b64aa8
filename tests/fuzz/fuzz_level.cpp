// Level files, in a project that has the scenes of their corpus. One that is read must also survive an edit, and then
// say what the edit says.
#include "hatchway/io/level/edit.hpp"
#include "hatchway/io/level/file.hpp"
#include "tests/fuzz/target.hpp"
#include "tests/temporary_folder.hpp"

namespace {

struct Project {
    TemporaryFolder folder;
    Project()
    {
        for (const char* name : {"hatchway.project", "levels/a.glb", "models/hall.glb", "models/prism.glb"})
            folder.write(name, "");
    }
};

}  // namespace

void hw::fuzz::try_bytes(std::string_view bytes)
{
    static const Project project;
    const std::filesystem::path file = project.folder.path() / "levels" / "a.level.json";
    const std::string text(bytes);
    parse_level(text, file);
    const StyleAssignment assignment{.nodes = "Hall/Column", .style = "ink"};
    const Level level = parse_level(with_assignments(text, std::span(&assignment, 1), file), file);
    require(!level.assign.empty() && level.assign.back().nodes == assignment.nodes);
}
