#include "program/pictures/picture_name.hpp"

#include <fmt/format.h>

namespace hw {
namespace fs = std::filesystem;

fs::path free_picture_name(const fs::path& folder, const fs::path& level_file)
{
    const std::string name = level_file.filename().string();
    const std::string stem = name.substr(0, name.find('.'));
    for (int number = 1;; ++number) {
        const fs::path file = folder / fmt::format("{}_{:03}.png", stem, number);
        std::error_code failed;
        if (!fs::exists(fs::symlink_status(file, failed))) return file;
    }
}

}  // namespace hw
