#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "hatchway/world/presence.hpp"

namespace hw {

/// A style given to nodes, or to one material on them, while walking.
struct StyleAssignment {
    std::string nodes;  ///< As AssignRule::nodes: a path glob or "#12".
    std::string style;
    std::string materials = {};   ///< As AssignRule::materials: a glob; empty: all, and no such key is written.
    std::string over = {};        ///< A second style over the first; empty: none, and no such key is written.
    PresenceField presence = {};  ///< Of `over`; written with it.
};

/// The text of a level file with assignments added at the end of "assign", where they win over all others. Comments and
/// layout stay. "assign" is made when it is missing; an entry that an earlier call added for the same nodes
/// and materials is replaced. `file` stands in messages. Throws hw::Error when the text is not a level.
std::string with_assignments(std::string text, std::span<const StyleAssignment> assignments,
                             const std::filesystem::path& file);

/// Edits the level file itself, after proving that the new text reads as the old level plus the assignments. On an
/// error the file is as it was. A bare model cannot be edited: throws hw::Error.
void write_assignments(const std::filesystem::path& level_file, std::span<const StyleAssignment> assignments);

}  // namespace hw
