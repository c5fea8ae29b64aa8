#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hw {

/// What the system calls an open file or folder; closed at the end.
class Descriptor {
 public:
    explicit Descriptor(int value) : value_(value) {}
    ~Descriptor();
    Descriptor(Descriptor&& other) noexcept;
    Descriptor& operator=(Descriptor&& other) noexcept;
    int value() const { return value_; }
    bool is_open() const { return value_ >= 0; }

 private:
    int value_;
};

/// An open folder. A name in it is one component and is never followed if it is a link: whatever an archive brought
/// under that name, nothing outside of the folder is read or written. All throw hw::Error that names the file.
class FolderHandle {
 public:
    /// The folder at `path`, links in the path followed: of a path that a user typed. Empty: the working folder.
    explicit FolderHandle(const std::filesystem::path& path);

    const std::filesystem::path& path() const { return path_; }
    int descriptor() const { return descriptor_.value(); }

    /// A folder in this one; made with `mode` (and the process's mask) when nothing has that name.
    FolderHandle folder(const std::string& name) const;
    FolderHandle made_folder(const std::string& name, unsigned mode) const;

    /// A whole regular file; nothing when there is none of that name.
    std::optional<std::vector<std::byte>> read(const std::string& name, std::uint64_t max_bytes) const;

    /// Writes beside under a temporary name, then renames: whoever reads, also after a kill or a power cut, has the old
    /// bytes or the new, never a part. A link is replaced, what it leads to stays as it is. A file that is replaced
    /// keeps its mode; one that is write-protected, a folder, pipe or device is refused.
    void write(const std::string& name, std::span<const std::byte> bytes) const;

    /// Removes a file or link, if there is one.
    void remove(const std::string& name) const;

 private:
    FolderHandle(Descriptor descriptor, std::filesystem::path path);

    Descriptor descriptor_;
    std::filesystem::path path_;
};

/// Holds back whoever else wants to change the same folder's files by a FolderLock, in this process or another. Waits
/// at most ten seconds for it, then throws hw::Error. Where a file system has no locks, it holds back nobody.
class FolderLock {
 public:
    explicit FolderLock(const FolderHandle& folder);

 private:
    Descriptor descriptor_;
};

}  // namespace hw
