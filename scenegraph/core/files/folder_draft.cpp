#include "hatchway/core/files/folder_draft.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/temporary_name.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

constexpr unsigned kFolderMode = 0777;  // less what the process's mask takes

fs::path without_last_slash(const fs::path& path)
{
    return path.has_filename() ? path : path.parent_path();
}

/// The error of something below `from`, told of what will stand below `to`.
[[noreturn]] void throw_of_place(const Error& error, const fs::path& from, const fs::path& to)
{
    ErrorParts parts = error.parts();
    const fs::path inside = fs::path(parts.file).lexically_relative(from);
    if (!inside.empty() && *inside.begin() != "..") parts.file = (inside == "." ? to : to / inside).string();
    throw Error(std::move(parts));
}

FolderHandle made_beside(const FolderHandle& parent, const std::string& place, std::string& name)
{
    remove_abandoned(parent);
    while (true) {
        name = temporary_name();
        try {
            FolderHandle folder = parent.made_folder(name, kFolderMode);
            if (lock_temporary(folder.descriptor())) return folder;
        } catch (const Error& error) {
            throw_of_place(error, parent.path() / name, parent.path() / place);
        }
    }
}

[[noreturn]] void throw_not_put(const fs::path& place)
{
    const bool cannot_exchange = errno == EINVAL || errno == ENOSYS;
    throw Error({.what = std::string("the folder cannot be put there: ") + std::strerror(errno),
                 .file = place.string(),
                 .expected = cannot_exchange ? "a new name, since this file system cannot exchange folders" : ""});
}

}  // namespace

FolderDraft::FolderDraft(const fs::path& place)
    : parent_(without_last_slash(place).parent_path()),
      name_(without_last_slash(place).filename().string()),
      folder_(made_beside(parent_, name_, temporary_))
{
}

FolderDraft::~FolderDraft()
{
    if (!temporary_.empty()) remove_flat_folder(parent_, temporary_);
}

void FolderDraft::fill(const std::function<void(const fs::path&)>& write) const
{
    const fs::path folder = parent_.path() / temporary_;
    try {
        write(folder);
    } catch (const Error& error) {
        throw_of_place(error, folder, parent_.path() / name_);
    }
}

void FolderDraft::sync() const
{
    ::fsync(folder_.descriptor());
}

void FolderDraft::put()
{
    sync();
    const int parent = parent_.descriptor();
    struct stat status = {};
    const bool is_there = ::fstatat(parent, name_.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0;
    // Both names change at once; what was there is then removed under the temporary one.
    const unsigned how = is_there ? RENAME_EXCHANGE : RENAME_NOREPLACE;
    if (::renameat2(parent, temporary_.c_str(), parent, name_.c_str(), how) != 0) throw_not_put(parent_.path() / name_);
    ::fsync(parent);
    if (is_there && !S_ISDIR(status.st_mode)) ::unlinkat(parent, temporary_.c_str(), 0);
    if (is_there && S_ISDIR(status.st_mode)) remove_flat_folder(parent_, temporary_);
    temporary_.clear();
}

void FolderDraft::put_new()
{
    sync();
    const int parent = parent_.descriptor();
    if (::renameat2(parent, temporary_.c_str(), parent, name_.c_str(), RENAME_NOREPLACE) != 0)
        throw_not_put(parent_.path() / name_);
    ::fsync(parent);
    temporary_.clear();
}

}  // namespace hw
