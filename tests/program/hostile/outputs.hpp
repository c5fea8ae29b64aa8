#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace hw::test {

/// A file or folder that a command of the program writes, the old one and the new one by another value of an option.
struct CommandOutput {
    std::string name;
    std::vector<std::string> words;  ///< "MODEL" stands for a model.
    std::string option;
    std::string old_value;
    std::string new_value;

    /// What the command is given to write the output into this folder.
    std::vector<std::string> arguments(const std::filesystem::path& model, const std::filesystem::path& folder,
                                       bool is_new) const;
};

/// One of each kind.
inline const CommandOutput kMapFolder{"map", {"map", "hatch"}, "--width", "64", "128"};
inline const CommandOutput kCompiled{"a.compiled", {"compile", "MODEL"}, "--pvs", "fast", "full"};
inline const CommandOutput kBaked{"a.lightmap", {"bake", "MODEL", "--samples", "4"}, "--luxels-per-m", "1", "2"};
inline const CommandOutput kPicture{"a.png", {"render", "MODEL"}, "--size", "32x32", "40x40"};
inline const CommandOutput kSvg{"a.svg", {"lines", "MODEL"}, "--size", "320x240", "400x300"};
inline const CommandOutput kPdf{"a.pdf", {"lines", "MODEL"}, "--size", "320x240", "400x300"};

/// The bytes of a file, or of all files of a folder by name, but for temporary ones.
std::map<std::string, std::string> state_of(const std::filesystem::path& output);

/// Temporary files and folders in a folder and below.
int left_behind_in(const std::filesystem::path& folder);

}  // namespace hw::test
