// Why a random temporary name: one made of the target's would be longer than a file system allows where the target's is
// nearly so, and a stranger could have put a file there.
#include "hatchway/core/files/folder_handle.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/files/temporary_name.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

constexpr int kOpenFolder = O_RDONLY | O_DIRECTORY | O_CLOEXEC;
constexpr mode_t kFileMode = 0644;
constexpr mode_t kAllModes = S_IRWXU | S_IRWXG | S_IRWXO;
constexpr std::chrono::seconds kLongestWait(10);
constexpr std::chrono::milliseconds kAskAgain(2);

[[noreturn]] void throw_system_error(const fs::path& path, const std::string& doing, int reason)
{
    throw Error({.what = doing + ": " + std::strerror(reason), .file = path.string()});
}

void require_name(const std::string& name, const fs::path& path)
{
    if (!name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos &&
        name.find('\0') == std::string::npos)
        return;
    throw Error({.what = "is no name of a file", .file = path.string()});
}

/// The mode of a file that may be replaced; nothing where there is none, or a link. A rename asks the folder alone, not
/// the file, so the file is asked here.
std::optional<mode_t> mode_of_replaced(int folder, const std::string& name, const fs::path& path)
{
    struct stat status = {};
    if (::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) {
        if (errno != ENOENT) throw_system_error(path, "cannot write", errno);
        return std::nullopt;
    }
    if (S_ISLNK(status.st_mode)) return std::nullopt;
    if (!S_ISREG(status.st_mode)) throw Error({.what = "cannot write: is not a regular file", .file = path.string()});
    const bool is_protected = (status.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0;
    if (is_protected || ::faccessat(folder, name.c_str(), W_OK, AT_EACCESS) != 0)
        throw Error({.what = "cannot write: is write-protected", .file = path.string()});
    return status.st_mode & kAllModes;
}

bool write_all(int descriptor, std::span<const std::byte> bytes)
{
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t count = ::write(descriptor, bytes.data() + done, bytes.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return false;
        done += static_cast<std::size_t>(count);
    }
    return true;
}

/// A new file under a temporary name that nobody else removes; the name, and the file for writing.
std::pair<std::string, Descriptor> made_temporary(const FolderHandle& folder, const fs::path& path)
{
    while (true) {
        std::string name = temporary_name();
        Descriptor file(
            ::openat(folder.descriptor(), name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kFileMode));
        if (!file.is_open()) throw_system_error(path, "cannot write", errno);
        if (lock_temporary(file.value())) return {std::move(name), std::move(file)};
    }
}

}  // namespace

Descriptor::~Descriptor()
{
    if (is_open()) ::close(value_);
}

Descriptor::Descriptor(Descriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept
{
    std::swap(value_, other.value_);
    return *this;
}

FolderHandle::FolderHandle(const fs::path& path)
    : FolderHandle(Descriptor(::open(path.empty() ? "." : path.c_str(), kOpenFolder)), path)
{
}

FolderHandle::FolderHandle(Descriptor descriptor, fs::path path)
    : descriptor_(std::move(descriptor)), path_(std::move(path))
{
    if (!descriptor_.is_open()) throw_system_error(path_.empty() ? "." : path_, "the folder cannot be opened", errno);
}

FolderHandle FolderHandle::folder(const std::string& name) const
{
    require_name(name, path_ / name);
    return {Descriptor(::openat(descriptor(), name.c_str(), kOpenFolder | O_NOFOLLOW)), path_ / name};
}

FolderHandle FolderHandle::made_folder(const std::string& name, unsigned mode) const
{
    require_name(name, path_ / name);
    if (::mkdirat(descriptor(), name.c_str(), mode) != 0 && errno != EEXIST)
        throw_system_error(path_ / name, "the folder cannot be made", errno);
    return folder(name);
}

std::optional<std::vector<std::byte>> FolderHandle::read(const std::string& name, std::uint64_t max_bytes) const
{
    const fs::path path = path_ / name;
    require_name(name, path);
    const Descriptor file(::openat(descriptor(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (!file.is_open() && errno == ENOENT) return std::nullopt;
    if (!file.is_open()) throw_system_error(path, errno == ELOOP ? "is a link" : "cannot open", errno);
    return read_open_file(file, path, max_bytes);
}

void FolderHandle::write(const std::string& name, std::span<const std::byte> bytes) const
{
    const fs::path path = path_ / name;
    require_name(name, path);
    const std::optional<mode_t> mode = mode_of_replaced(descriptor(), name, path);
    remove_abandoned(*this);
    const auto [temporary, file] = made_temporary(*this, path);
    // The bytes are on the disk before the name leads to them, and the name before this returns.
    const bool is_put = (!mode || ::fchmod(file.value(), *mode) == 0) && write_all(file.value(), bytes) &&
                        ::fsync(file.value()) == 0 &&
                        ::renameat(descriptor(), temporary.c_str(), descriptor(), name.c_str()) == 0;
    const int reason = errno;
    if (!is_put) ::unlinkat(descriptor(), temporary.c_str(), 0);
    if (!is_put) throw_system_error(path, "cannot write", reason);
    ::fsync(descriptor());  // not every file system can; the rename is done
}

void FolderHandle::remove(const std::string& name) const
{
    require_name(name, path_ / name);
    if (::unlinkat(descriptor(), name.c_str(), 0) != 0 && errno != ENOENT)
        throw_system_error(path_ / name, "cannot remove", errno);
}

FolderLock::FolderLock(const FolderHandle& folder) : descriptor_(::openat(folder.descriptor(), ".", kOpenFolder))
{
    const auto end = std::chrono::steady_clock::now() + kLongestWait;
    while (::flock(descriptor_.value(), LOCK_EX | LOCK_NB) != 0) {
        if (errno != EWOULDBLOCK && errno != EINTR) return;
        if (std::chrono::steady_clock::now() > end)
            throw Error({.what = "another program is saving into this folder and does not end",
                         .file = folder.path().string()});
        std::this_thread::sleep_for(kAskAgain);
    }
}

}  // namespace hw
