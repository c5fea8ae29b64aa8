#include "hatchway/core/files/recent_files.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "hatchway/core/files/folder_handle.hpp"

namespace hw {
namespace {

struct FolderFile {
    std::string name;
    std::uint64_t bytes = 0;
    timespec used = {};

    auto age() const { return std::tie(used.tv_sec, used.tv_nsec, name); }
};

std::vector<FolderFile> files_of(const FolderHandle& folder)
{
    std::vector<FolderFile> files;
    const int own = ::openat(folder.descriptor(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR* const listing = own < 0 ? nullptr : ::fdopendir(own);
    if (listing == nullptr && own >= 0) ::close(own);
    if (listing == nullptr) return files;
    while (const dirent* entry = ::readdir(listing)) {
        struct stat status = {};
        if (::fstatat(folder.descriptor(), entry->d_name, &status, AT_SYMLINK_NOFOLLOW) != 0) continue;
        if (!S_ISREG(status.st_mode)) continue;
        files.push_back({entry->d_name, static_cast<std::uint64_t>(status.st_size), status.st_mtim});
    }
    ::closedir(listing);
    return files;
}

}  // namespace

void note_use(const FolderHandle& folder, const std::string& name)
{
    ::utimensat(folder.descriptor(), name.c_str(), nullptr, AT_SYMLINK_NOFOLLOW);
}

void keep_recent(const FolderHandle& folder, std::uint64_t most_bytes)
{
    std::vector<FolderFile> files = files_of(folder);
    std::sort(files.begin(), files.end(), [](const FolderFile& a, const FolderFile& b) { return a.age() > b.age(); });
    std::uint64_t kept = 0;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (i == 0 || kept + files[i].bytes <= most_bytes)
            kept += files[i].bytes;
        else
            ::unlinkat(folder.descriptor(), files[i].name.c_str(), 0);
    }
}

}  // namespace hw
