#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hatchway/world/level.hpp"

namespace hw {

/// A style given to nodes, or to one material on them, while walking, or whether they are visible, or both.
struct StyleAssignment {
    std::string nodes;                 ///< As AssignRule::nodes: a path glob or "#12".
    std::string style = {};            ///< Empty: as before.
    std::string materials = {};        ///< As AssignRule::materials: a glob; empty: all, and no such key is written.
    std::string over = {};             ///< A second style over the first; empty: none, and no such key is written.
    PresenceField presence = {};       ///< Of `over`; written with it.
    std::optional<bool> visible = {};  ///< Absent: as before.
};

/// The text of a level file with assignments added at the end of "assign", where they win over all others. Comments and
/// layout stay. "assign" is made when it is missing; an entry that an earlier call added for the same nodes
/// and materials is replaced. `file` stands in messages. Throws hw::Error when the text is not a level.
std::string with_assignments(std::string text, std::span<const StyleAssignment> assignments,
                             const std::filesystem::path& file);

/// What to add to a level as its file has it now.
using AssignmentsFor = std::function<std::vector<StyleAssignment>(const Level& level)>;

/// A level file before it was edited and after.
struct LevelTexts {
    std::string before;
    std::string after;
};

/// Edits the level file itself, after proving that the new text reads as the old level plus the assignments. Whoever
/// edits the same file this way meanwhile waits, so that nobody's change is lost; what a text editor wrote meanwhile is
/// taken up. A link is replaced by a file. On an error the file is as it was. A bare model cannot be edited: throws
/// hw::Error.
LevelTexts edit_level_file(const std::filesystem::path& level_file, const AssignmentsFor& assignments_for);

}  // namespace hw
