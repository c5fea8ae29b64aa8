#pragma once

#include <string>

namespace hw {

class FolderHandle;

/// What is being written has such a name, and a lock for as long as its process lives.
std::string temporary_name();

/// Takes that lock. False when the file was removed before: it is to be made anew, under another name.
bool lock_temporary(int descriptor);

/// Removes what killed processes of this user left in a folder under such names; looks into a folder once.
void remove_abandoned(const FolderHandle& folder);

/// Removes a folder with the files in it; what holds folders itself is left alone.
void remove_flat_folder(const FolderHandle& parent, const std::string& name);

}  // namespace hw
