#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "hatchway/core/files/folder_handle.hpp"

namespace hw {

/// What a walk has not saved, in the user's state folder: the next walk through the same file finds it there, also
/// after a kill. Walks through one file at the same time keep theirs apart.
class Autosave {
 public:
    /// Of a level file or a bare model. Where there is no state folder nothing is kept; a message says so.
    explicit Autosave(const std::filesystem::path& file);

    /// What an earlier walk left; empty when it left nothing.
    std::string left() const;

    /// Replaces what is kept; empty: keeps nothing. Costs nothing while the text is the same. Throws hw::Error.
    void keep(const std::string& text);

 private:
    /// Takes a number that no other walk has, for as long as this lives.
    void take_number(const std::string& stem);

    std::optional<FolderHandle> folder_;
    std::optional<Descriptor> lock_;
    std::string name_;
    std::string kept_;
};

}  // namespace hw
