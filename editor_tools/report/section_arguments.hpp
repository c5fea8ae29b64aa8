#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace hw {

// What the sections of the report give to `hatchway measure`.

/// The binary glTF files of a folder in order; none where there is no such folder.
inline std::vector<std::string> models_in(const std::filesystem::path& folder)
{
    std::vector<std::string> files;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(folder, missing))
        if (entry.path().extension() == ".glb") files.push_back(entry.path().string());
    std::sort(files.begin(), files.end());
    return files;
}

inline std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& second,
                                       const std::vector<std::string>& third = {})
{
    first.insert(first.end(), second.begin(), second.end());
    first.insert(first.end(), third.begin(), third.end());
    return first;
}

}  // namespace hw
