#pragma once

#include <filesystem>
#include <string>

#include "hatchway/world/level.hpp"

namespace hw {

/// Reads a level file (.json, comments allowed), or a bare model (kModelFormats), which gives a level with defaults.
/// The model itself is not opened. Throws hw::Error with file, JSON pointer, what was found and what is allowed for
/// text that is no JSON, an unknown, repeated or missing key, a wrong type, a value out of range, a path that leaves
/// the project. Styles and their parameters belong to plugins, maps to files: who loads those checks them.
Level read_level(const std::filesystem::path& file);

/// The same from text, as if it stood in `file`.
Level parse_level(const std::string& text, const std::filesystem::path& file);

/// The nearest folder above `file` that holds a `hatchway.project` file or a `.git`; empty where there is none.
std::filesystem::path marked_project(const std::filesystem::path& file);

/// The folder that no path of a level or model leaves: marked_project(); else, when the file lies in a folder named
/// `levels`, that folder's parent; else the file's own folder.
std::filesystem::path find_project_root(const std::filesystem::path& file);

}  // namespace hw
