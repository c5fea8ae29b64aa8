#include "hatchway/core/files/files.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <mutex>
#include <set>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/folder_handle.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

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
Bytes read_opened(const Descriptor& file, const fs::path& path, std::uint64_t max_bytes)
{
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

template <typename Bytes>
Bytes read_into(const fs::path& path, std::uint64_t max_bytes)
{
    // O_NONBLOCK: opening a FIFO must not wait for its writer.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (!file.is_open() && (errno == ENOENT || errno == ENOTDIR))
        throw Error({.what = "there is no such file", .file = path.string()});
    if (!file.is_open()) throw_system_error(path, "cannot open");
    return read_opened<Bytes>(file, path, max_bytes);
}

bool is_inside(const fs::path& root, const fs::path& path)
{
    const auto [root_end, ignored] = std::mismatch(root.begin(), root.end(), path.begin(), path.end());
    return root_end == root.end() || (root_end->empty() && std::next(root_end) == root.end());
}

/// The first part of `path` below `root` that is a link; empty when there is none.
fs::path link_below(const fs::path& root, const fs::path& path)
{
    fs::path part = root;
    std::error_code missing;
    for (const fs::path& name : path.lexically_relative(root)) {
        part /= name;
        if (fs::is_symlink(fs::symlink_status(part, missing))) return part;
    }
    return {};
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

std::vector<std::byte> read_open_file(const Descriptor& file, const fs::path& path, std::uint64_t max_bytes)
{
    return read_opened<std::vector<std::byte>>(file, path, max_bytes);
}

void write_file_atomically(const fs::path& path, std::span<const std::byte> bytes)
{
    FolderHandle(path.parent_path()).write(path.filename().string(), bytes);
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
    fs::path resolved = (fs::weakly_canonical(base.empty() ? "." : base, failed) / wanted).lexically_normal();
    if (failed) throw refuse("cannot be resolved");
    if (!resolved.has_filename()) resolved = resolved.parent_path();
    if (!is_inside(real_root, resolved)) throw refuse("leaves the project");
    if (const fs::path link = link_below(real_root, resolved); !link.empty())
        throw refuse("goes through the link " + link.string());
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
