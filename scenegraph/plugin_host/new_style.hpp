#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hw {

/// Writes a complete style that draws: the folder `parent`/`name` with name.cpp, name.frag, CMakeLists.txt and
/// README.md. Returns the files. Throws hw::Error, and writes nothing, when the name is not [a-z0-9_]+, starts with a
/// digit, or the folder exists.
std::vector<std::filesystem::path> write_new_style(const std::string& name, const std::filesystem::path& parent);

}  // namespace hw
