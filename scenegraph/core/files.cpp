#include "hatchway/core/files.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <set>

#include "hatchway/core/error.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

class FileDescriptor {
 public:
    explicit FileDescriptor(int value) : value_(value) {}
    ~FileDescriptor()
    {
        if (value_ >= 0) ::close(value_);
    }
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;
    int value() const { return value_; }

 private:
    int value_;
};

[[noreturn]] void throw_system_error(const fs::path& path, const std::string& doing)
{
    throw Error({.what = doing + ": " + std::strerror(errno), .file = path.string()});
}

std::uint64_t size_of_regular_file(int descriptor, const fs::path& path, std::uint64_t max_bytes)
{
    struct stat status = {};
    if (::fstat(descriptor, &status) != 0) throw_system_error(path, "cannot read");
    if (!S_ISREG(status.st_mode)) throw Error({.what = "is not a regular file", .file = path.string()});
    const auto size = static_cast<std::uint64_t>(status.st_size);
    if (size > max_bytes)
        throw Error({.what = "has " + std::to_string(size) + " bytes",
                     .file = path.string(),
                     .expected = "at most " + std::to_string(max_bytes)});
    return size;
}

struct ReadFiles {
    std::mutex mutex;
    std::set<fs::path> paths;
};

ReadFiles& read_files()
{
    static ReadFiles files;
    return files;
}

void note_as_read(const fs::path& path)
{
    ReadFiles& files = read_files();
    const std::lock_guard lock(files.mutex);
    files.paths.insert(path);
}

template <typename Bytes>
Bytes read_into(const fs::path& path, std::uint64_t max_bytes)
{
    // O_NONBLOCK: opening a FIFO must not wait for its writer.
    const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.value() < 0) throw_system_error(path, "cannot open");
    note_as_read(path);
    Bytes bytes;
    bytes.resize(size_of_regular_file(file.value(), path, max_bytes));
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t count = ::read(file.value(), bytes.data() + done, bytes.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw_system_error(path, "cannot read");
        if (count == 0) break;
        done += static_cast<std::size_t>(count);
    }
    bytes.resize(done);
    return bytes;
}

fs::path temporary_name_beside(const fs::path& path)
{
    static std::atomic<unsigned> counter{0};
    fs::path name = path;
    name += ".tmp" + std::to_string(::getpid()) + "_" + std::to_string(counter++);
    return name;
}

/// Where the bytes of a link belong: at its end, which need not exist yet.
fs::path behind_links(fs::path path)
{
    constexpr int kMostLinks = 40;
    std::error_code failed;
    for (int i = 0; i < kMostLinks && fs::is_symlink(path, failed); ++i)
        path = path.parent_path() / fs::read_symlink(path, failed);
    return path;
}

/// The mode that a file gets which replaces `target`. Throws when that must not be replaced: a rename asks the folder
/// alone, not the file.
mode_t mode_for(const fs::path& target, const fs::path& named)
{
    struct stat status = {};
    if (::stat(target.c_str(), &status) != 0) {
        if (errno != ENOENT) throw_system_error(named, "cannot write");
        return 0;
    }
    if (!S_ISREG(status.st_mode)) throw Error({.what = "cannot write: is not a regular file", .file = named.string()});
    const bool is_protected = (status.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0;
    if (is_protected || ::access(target.c_str(), W_OK) != 0)
        throw Error({.what = "cannot write: is write-protected", .file = named.string()});
    return status.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO);
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

bool is_inside(const fs::path& root, const fs::path& path)
{
    const auto [root_end, ignored] = std::mismatch(root.begin(), root.end(), path.begin(), path.end());
    return root_end == root.end() || (root_end->empty() && std::next(root_end) == root.end());
}

/// Whether a part of the path is a link: in a weakly canonical one, a link that leads nowhere yet.
bool has_link(const fs::path& path)
{
    fs::path part;
    std::error_code missing;
    for (const fs::path& name : path) {
        part /= name;
        if (fs::is_symlink(fs::symlink_status(part, missing))) return true;
    }
    return false;
}

}  // namespace

std::vector<std::byte> read_file(const fs::path& path, std::uint64_t max_bytes)
{
    return read_into<std::vector<std::byte>>(path, max_bytes);
}

std::string read_text_file(const fs::path& path, std::uint64_t max_bytes)
{
    return read_into<std::string>(path, max_bytes);
}

std::vector<fs::path> files_read()
{
    ReadFiles& files = read_files();
    const std::lock_guard lock(files.mutex);
    return {files.paths.begin(), files.paths.end()};
}

void write_file_atomically(const fs::path& path, std::span<const std::byte> bytes)
{
    const fs::path target = behind_links(path);
    const mode_t mode = mode_for(target, path);
    const fs::path temporary = temporary_name_beside(target);
    bool is_written = false;
    {
        const FileDescriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
        if (file.value() < 0) throw_system_error(path, "cannot write");
        is_written = (mode == 0 || ::fchmod(file.value(), mode) == 0) && write_all(file.value(), bytes);
    }
    if (is_written && ::rename(temporary.c_str(), target.c_str()) == 0) return;
    const int reason = errno;
    ::unlink(temporary.c_str());
    errno = reason;
    throw_system_error(path, "cannot write");
}

void write_file_atomically(const fs::path& path, std::string_view text)
{
    write_file_atomically(path, std::as_bytes(std::span(text.data(), text.size())));
}

fs::path resolve_inside(const fs::path& root, const fs::path& base, std::string_view relative,
                        const std::string& named_in, const std::string& pointer)
{
    const fs::path wanted{std::string(relative)};
    const auto refuse = [&](const std::string& why) {
        return Error({.what = "the path \"" + std::string(relative) + "\" " + why,
                      .file = named_in,
                      .pointer = pointer,
                      .expected = "a relative path that stays inside the project folder " + root.string()});
    };
    if (relative.empty() || relative.find('\0') != std::string_view::npos) throw refuse("is no file name");
    if (wanted.is_absolute()) throw refuse("is absolute");
    std::error_code failed;
    const fs::path real_root = fs::weakly_canonical(root, failed);
    const fs::path resolved = fs::weakly_canonical(base / wanted, failed);
    if (failed) throw refuse("cannot be resolved");
    if (!is_inside(real_root, resolved)) throw refuse("leaves the project");
    if (has_link(resolved)) throw refuse("is a link that leads nowhere");
    return resolved;
}

fs::path installation_prefix()
{
    Dl_info library = {};
    std::error_code failed;
    if (::dladdr(reinterpret_cast<const void*>(&installation_prefix), &library) != 0) {
        // The library lies in PREFIX/lib or PREFIX/lib/<architecture>.
        fs::path folder = fs::canonical(library.dli_fname, failed).parent_path();
        for (; !failed && folder.has_relative_path(); folder = folder.parent_path())
            if (fs::exists(folder / "share" / "hatchway")) return folder;
    }
    return fs::canonical("/proc/self/exe", failed).parent_path().parent_path();
}

}  // namespace hw
