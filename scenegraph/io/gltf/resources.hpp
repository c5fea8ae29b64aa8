#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace hw {

/// Reads what a glTF document names by URI: data URIs, and files that stay inside of the project. Keeps the byte budget
/// of one import. Private to io.
class GltfResources {
 public:
    GltfResources(std::filesystem::path file, std::filesystem::path project_root)
        : file_(std::move(file)), project_root_(std::move(project_root))
    {
    }

    /// Throws hw::Error for another scheme, a path outside of the project, what is no regular file, bad base64, or when
    /// the budget is spent. `pointer` says where the URI stands.
    std::vector<std::byte> read(const std::string& uri, const std::string& pointer);

 private:
    std::vector<std::byte> decode_data_uri(const std::string& uri, const std::string& pointer) const;
    std::filesystem::path resolve(const std::string& uri, const std::string& pointer) const;

    std::filesystem::path file_;
    std::filesystem::path project_root_;
    std::uint64_t spent_ = 0;
};

}  // namespace hw
