#include "hatchway/core/files/user_folders.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

#include "hatchway/core/error.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

constexpr unsigned kPrivate = 0700;
constexpr const char* kName = "hatchway";

/// An environment variable that holds an absolute path; else empty.
fs::path absolute_path_in(const char* variable)
{
    const char* value = std::getenv(variable);
    const fs::path path = value ? value : "";
    return path.is_absolute() ? path : fs::path();
}

fs::path base_folder(const char* variable, const char* below_home)
{
    if (fs::path base = absolute_path_in(variable); !base.empty()) return base;
    const fs::path home = absolute_path_in("HOME");
    if (home.empty())
        throw Error({.what = "there is no folder of the user's own",
                     .expected = std::string("an absolute path in HOME or ") + variable});
    return home / below_home;
}

/// Makes what is missing of a path that the user's environment names.
void make_folders(const fs::path& path)
{
    fs::path part;
    for (const fs::path& name : path) {
        part /= name;
        if (::mkdir(part.c_str(), kPrivate) == 0) continue;
        std::error_code failed;
        if (!fs::is_directory(part, failed)) throw Error({.what = "the folder cannot be made", .file = part.string()});
    }
}

/// The folder of the program's own name, made when it is missing. A link of that name is followed where this user made
/// it: many keep caches on another disk.
FolderHandle own_folder(const FolderHandle& base)
{
    struct stat status = {};
    const bool is_there = ::fstatat(base.descriptor(), kName, &status, AT_SYMLINK_NOFOLLOW) == 0;
    if (is_there && S_ISLNK(status.st_mode) && status.st_uid == ::geteuid()) return FolderHandle(base.path() / kName);
    return base.made_folder(kName, kPrivate);
}

FolderHandle private_folder(const fs::path& base)
{
    make_folders(base);
    FolderHandle folder = own_folder(FolderHandle(base));
    struct stat status = {};
    if (::fstat(folder.descriptor(), &status) != 0 || status.st_uid != ::geteuid())
        throw Error({.what = "the folder belongs to somebody else", .file = folder.path().string()});
    if ((status.st_mode & (S_IWGRP | S_IWOTH)) != 0)
        throw Error(
            {.what = "others may write into the folder", .file = folder.path().string(), .expected = "mode 0700"});
    if ((status.st_mode & S_IWUSR) == 0)
        throw Error({.what = "the folder is write-protected", .file = folder.path().string()});
    return folder;
}

}  // namespace

FolderHandle user_cache_folder()
{
    return private_folder(base_folder("XDG_CACHE_HOME", ".cache"));
}

FolderHandle user_state_folder()
{
    return private_folder(base_folder("XDG_STATE_HOME", ".local/state"));
}

}  // namespace hw
