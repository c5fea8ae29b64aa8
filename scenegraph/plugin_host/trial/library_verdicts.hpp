#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "hatchway/core/files/folder_handle.hpp"

namespace hw {

/// A library by its content, and this host by the build string of its interface: when either changes, nothing is known.
/// Empty when the file cannot be read.
std::string verdict_key(const std::filesystem::path& library);

/// What is known of libraries that were loaded before: a file for each key in the user's cache folder. Where there is
/// no such folder nothing is remembered.
class LibraryVerdicts {
 public:
    LibraryVerdicts();

    /// Why the library must not be loaded, in one sentence; empty when it may; nothing when it was not tried yet.
    std::optional<std::string> of(const std::string& key) const;
    /// Never throws: what cannot be kept is tried again at the next start.
    void keep(const std::string& key, const std::string& why) const;

    /// Where a verdict stands under its key as a name; -1 when there is no such place.
    int folder() const { return folder_ ? folder_->descriptor() : -1; }

    /// What the file of a refused library begins with; the reason follows.
    static constexpr const char* kRefused = "refused: ";

 private:
    std::optional<FolderHandle> folder_;
};

}  // namespace hw
