#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hw {

class Descriptor;

/// Reads a whole regular file. Throws hw::Error when it is missing, not a regular file (folder, FIFO, device), or
/// larger than `max_bytes`.
std::vector<std::byte> read_file(const std::filesystem::path& path, std::uint64_t max_bytes);
std::string read_text_file(const std::filesystem::path& path, std::uint64_t max_bytes);

/// The same of a file that is open; `path` stands in messages.
std::vector<std::byte> read_open_file(const Descriptor& file, const std::filesystem::path& path,
                                      std::uint64_t max_bytes);

/// Every file that the two have read in this process, each once: what no output of it may replace.
std::vector<std::filesystem::path> files_read();

/// FolderHandle::write() into the folder that the path names, links in it followed: a user typed them. A link in the
/// last component is replaced. On an error the target is as it was.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_file_atomically(const std::filesystem::path& path, std::string_view text);

/// Resolves a path that a file names, relative to the folder `base`, and proves that it stays inside the folder `root`
/// and goes through no link below it, wherever that leads: links come with a stranger's archive. Throws hw::Error for
/// an absolute path, one that leaves `root`, one with a link, or one with a NUL byte. `base` itself may be reached by
/// links. `named_in` and `pointer` tell the message where the path stands.
std::filesystem::path resolve_inside(const std::filesystem::path& root, const std::filesystem::path& base,
                                     std::string_view relative, const std::string& named_in,
                                     const std::string& pointer);

/// The installation prefix (or build folder) of the running program or library: holds bin/, lib/ and share/hatchway/.
std::filesystem::path installation_prefix();

}  // namespace hw
