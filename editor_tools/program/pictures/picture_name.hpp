#pragma once

#include <filesystem>

namespace hw {

/// The first of hall_001.png, hall_002.png, ... that does not exist in `folder`.
std::filesystem::path free_picture_name(const std::filesystem::path& folder, const std::filesystem::path& level_file);

}  // namespace hw
