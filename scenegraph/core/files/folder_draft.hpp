#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "hatchway/core/files/folder_handle.hpp"

namespace hw {

/// A folder of files that is put in its place whole: at any moment, also after a kill or a power cut, that place holds
/// the old folder or the new one. Made beside the place under a temporary name; gone when it is not put.
class FolderDraft {
 public:
    /// `place` is a path that a user typed. Throws hw::Error when nothing can be written beside it.
    explicit FolderDraft(const std::filesystem::path& place);
    ~FolderDraft();
    FolderDraft(const FolderDraft&) = delete;
    FolderDraft& operator=(const FolderDraft&) = delete;

    /// Calls `write` with the folder to write the files into. It holds no folders. An hw::Error of a file in it names
    /// the file as it would be called at the place.
    void fill(const std::function<void(const std::filesystem::path& folder)>& write) const;

    /// Replaces a folder of files that is at the place, or a link there; makes it new else. Once only.
    void put();
    /// Throws hw::Error when anything is at the place.
    void put_new();

 private:
    void sync() const;

    FolderHandle parent_;
    std::string name_;
    std::string temporary_;
    FolderHandle folder_;
};

}  // namespace hw
