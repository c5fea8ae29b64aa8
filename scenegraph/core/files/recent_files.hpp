#pragma once

#include <cstdint>
#include <string>

namespace hw {

class FolderHandle;

/// Notes that a file is used now: sets its time. Nothing happens where that cannot be.
void note_use(const FolderHandle& folder, const std::string& name);

/// Removes the regular files of a folder that were used or written longest ago, until the others take at most
/// `most_bytes`. The newest always stays, and so does what cannot be removed.
void keep_recent(const FolderHandle& folder, std::uint64_t most_bytes);

}  // namespace hw
