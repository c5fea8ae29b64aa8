#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "hatchway/core/files/files.hpp"

/// A folder for one test, removed at its end.
class TemporaryFolder {
 public:
    TemporaryFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "hatchway_test_XXXXXX").string();
        path_ = ::mkdtemp(name.data());
    }
    ~TemporaryFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    std::filesystem::path write(const std::string& name, std::string_view text) const
    {
        const std::filesystem::path file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        hw::write_file_atomically(file, text);
        return file;
    }

 private:
    std::filesystem::path path_;
};
