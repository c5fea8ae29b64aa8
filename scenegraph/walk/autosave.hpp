#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hatchway/core/files/folder_handle.hpp"

namespace hw {

/// What a walk has not saved, beside the file or, where nothing can be written, in the user's state folder: the next
/// walk through the same file finds it there, also after a kill. Walks through one file at the same time keep theirs
/// apart.
class Autosave {
 public:
    /// Of a level file or a bare model. Where there is neither folder nothing is kept; a message says so.
    explicit Autosave(const std::filesystem::path& file);
    ~Autosave();
    Autosave(const Autosave&) = delete;
    Autosave& operator=(const Autosave&) = delete;

    /// What an earlier walk left; empty when it left nothing.
    std::string left() const;

    /// Replaces what is kept; empty: keeps nothing. Costs nothing while the text is the same. Throws hw::Error when no
    /// place takes it.
    void keep(const std::string& text);

 private:
    /// A name in a folder that no other walk has, for as long as the lock is held.
    struct Place {
        FolderHandle folder;
        std::string name;
        Descriptor lock;
    };

    void add_place(FolderHandle folder, const std::string& stem);

    std::vector<Place> places_;  ///< The better first.
    std::string kept_;
};

}  // namespace hw
