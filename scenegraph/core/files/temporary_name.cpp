#include "hatchway/core/files/temporary_name.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <memory>
#include <mutex>
#include <random>
#include <set>
#include <string_view>
#include <tuple>
#include <vector>

#include "hatchway/core/files/folder_handle.hpp"

namespace hw {
namespace {

constexpr std::string_view kStart = ".hatchway-";
constexpr std::string_view kEnd = ".tmp";
constexpr std::size_t kDigits = 16;

/// Only what temporary_name() makes: a user's own notes may begin and end like that.
bool is_temporary_name(std::string_view name)
{
    if (name.size() != kStart.size() + kDigits + kEnd.size()) return false;
    return name.starts_with(kStart) && name.ends_with(kEnd) &&
           name.substr(kStart.size(), kDigits).find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

struct CloseFolder {
    void operator()(DIR* folder) const { ::closedir(folder); }
};

/// The names in a folder. The descriptor's own place in the folder stays where it is.
std::vector<std::string> names_in(int folder)
{
    std::vector<std::string> names;
    const std::unique_ptr<DIR, CloseFolder> open(
        ::fdopendir(::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC)));
    if (!open) return names;
    while (const dirent* entry = ::readdir(open.get()))
        if (const std::string_view name = entry->d_name; name != "." && name != "..") names.emplace_back(name);
    return names;
}

/// Whether this process looks into the folder for the first time.
bool is_new_to_us(const FolderHandle& folder)
{
    static std::mutex mutex;
    static std::set<std::tuple<std::string, dev_t, ino_t>> seen;
    struct stat status = {};
    if (::fstat(folder.descriptor(), &status) != 0) return false;
    const std::lock_guard lock(mutex);
    return seen.emplace(folder.path().string(), status.st_dev, status.st_ino).second;
}

void remove_if_abandoned(const FolderHandle& folder, const std::string& name)
{
    const Descriptor file(::openat(folder.descriptor(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat status = {};
    if (!file.is_open() || ::fstat(file.value(), &status) != 0 || status.st_uid != ::geteuid()) return;
    if (::flock(file.value(), LOCK_EX | LOCK_NB) != 0) return;
    if (S_ISDIR(status.st_mode))
        remove_flat_folder(folder, name);
    else
        ::unlinkat(folder.descriptor(), name.c_str(), 0);
}

}  // namespace

std::string temporary_name()
{
    static std::mutex mutex;
    static std::random_device random;
    const std::lock_guard lock(mutex);
    return fmt::format("{}{:08x}{:08x}{}", kStart, random(), random(), kEnd);
}

bool lock_temporary(int descriptor)
{
    // Whoever removes what is abandoned may have had the lock first.
    ::flock(descriptor, LOCK_EX);
    struct stat status = {};
    return ::fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

void remove_abandoned(const FolderHandle& folder)
{
    if (!is_new_to_us(folder)) return;
    for (const std::string& name : names_in(folder.descriptor()))
        if (is_temporary_name(name)) remove_if_abandoned(folder, name);
}

void remove_flat_folder(const FolderHandle& parent, const std::string& name)
{
    const Descriptor folder(
        ::openat(parent.descriptor(), name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (!folder.is_open()) return;
    for (const std::string& inside : names_in(folder.value())) ::unlinkat(folder.value(), inside.c_str(), 0);
    ::unlinkat(parent.descriptor(), name.c_str(), AT_REMOVEDIR);
}

}  // namespace hw
