#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hw {

/// A file to write, and the option that names it. Empty: the option was not given.
struct OutputFile {
    std::string option;
    std::filesystem::path file;
};

/// Throws hw::Error unless a file of that name can be written: its folder is there and lets us, and it is no folder. A
/// link is fine, it will be replaced. Writes nothing. An empty name is fine.
void require_writable(const std::filesystem::path& file, const std::string& option);

/// Throws hw::Error unless files can be written into a folder that is there, and the way to it goes through no link
/// that lies in the working folder or below: such a link may have come with a project. An empty name is the working
/// folder.
void require_folder(const std::filesystem::path& folder, const std::string& option);

/// The same for a folder that may be new: it is there, or its parent is. A link to a folder is refused, since what is
/// written must not end up elsewhere.
void require_writable_folder(const std::filesystem::path& folder, const std::string& option);

/// Throws hw::Error when an output is one of the inputs, symbolic links followed, or two outputs are the same file.
void require_distinct(const std::vector<OutputFile>& outputs, const std::vector<std::filesystem::path>& inputs);

/// Both rules, for all files that a command writes; called before anything is read or written. Links in the folders of
/// inputs, or below, are not gone through either.
void require_outputs(const std::vector<OutputFile>& outputs, const std::vector<std::filesystem::path>& inputs);

/// Throws hw::Error when an output is a file that this process has read: a level, its model, their textures and maps.
/// Called once all is read, before anything is written.
void require_unread(const std::vector<OutputFile>& outputs);

/// Whether `file` lies in `folder` itself. Neither need exist.
bool is_in_folder(const std::filesystem::path& file, const std::filesystem::path& folder);

/// Makes a folder in one that is there, unless it is there already. Throws hw::Error.
void make_folder(const std::filesystem::path& folder);

}  // namespace hw
