#pragma once

#include "hatchway/core/files/folder_handle.hpp"

namespace hw {

/// What this user's program made for itself and believes later: XDG_CACHE_HOME/hatchway or ~/.cache/hatchway. Made,
/// with mode 0700, when it is missing. Links in the path that the environment names are followed, and `hatchway` itself
/// may be one that this user made. Throws hw::Error when it cannot be made, is somebody else's link, belongs to
/// somebody else or lets others write.
FolderHandle user_cache_folder();

/// The same for what must outlive a clean-up: XDG_STATE_HOME/hatchway or ~/.local/state/hatchway.
FolderHandle user_state_folder();

}  // namespace hw
