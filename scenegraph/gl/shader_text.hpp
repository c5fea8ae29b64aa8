#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hw {

/// One shader stage with its includes resolved. The compiler's messages count files as `files` does.
struct ShaderText {
    std::string text;                          ///< Without a version line: the compiler adds the device's.
    std::vector<std::filesystem::path> files;  ///< Source string number -> file. Number 0 stands for the defines.
};

/// Reads a shader and what it includes (#include "name" on a line of its own; each file once), looking in `folders` in
/// order. `defines` is put before the text. Names are plain file names: no folders, no "..". Throws hw::Error with file
/// and line when a file is missing, or includes lie deeper than 16.
ShaderText load_shader(std::string_view name, std::span<const std::filesystem::path> folders, std::string_view defines);

/// The lines that every shader starts with: version and precision.
std::string shader_header(bool is_es);

/// Where a compiler's message points: "file:line: message" for the first error of `log`.
std::string located_message(const std::string& log, const ShaderText& shader);

}  // namespace hw
