#include "hatchway/walk/autosave.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/user_folders.hpp"
#include "hatchway/core/hash.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/core/log.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

constexpr int kMostWalks = 16;  // through one level at once
constexpr const char* kLock = ".lock";
constexpr const char* kUnsaved = ".unsaved.json";

/// A hash in place of the file's name: a name may be as long as a file system allows.
std::string stem_of(const std::string& text)
{
    return fmt::format("{:016x}", hash_bytes(std::as_bytes(std::span(text))));
}

/// The lock of this name, unless another walk has it or nothing can be written here.
std::optional<Descriptor> taken_lock(const FolderHandle& folder, const std::string& name)
{
    Descriptor lock(::openat(folder.descriptor(), name.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600));
    if (!lock.is_open() || ::flock(lock.value(), LOCK_EX | LOCK_NB) != 0) return std::nullopt;
    // Whoever had it may have removed it since it was opened.
    struct stat status = {};
    if (::fstat(lock.value(), &status) != 0 || status.st_nlink == 0) return std::nullopt;
    return lock;
}

/// Removes a file where that can be done; one that stays does no harm.
void forget(const FolderHandle& folder, const std::string& name)
{
    try {
        folder.remove(name);
    } catch (const Error& error) {
        log_debug(error.what());
    }
}

}  // namespace

Autosave::Autosave(const fs::path& file)
{
    std::error_code failed;
    const fs::path place = fs::weakly_canonical(fs::absolute(file, failed), failed);
    std::string why = "the folder of the level";
    const auto attempt = [&](auto&& add) {
        try {
            add();
        } catch (const Error& error) {
            why = error.what();
        }
    };
    attempt([&] { add_place(FolderHandle(file.parent_path()), ".hatchway-" + stem_of(file.filename().string())); });
    attempt([&] { add_place(user_state_folder(), stem_of(place.string())); });
    if (places_.empty()) log_info(why + ": changes of this walk are kept only when they are saved");
    kept_ = left();
}

Autosave::~Autosave()
{
    for (const Place& place : places_) {
        const std::string stem = place.name.substr(0, place.name.size() - std::string_view(kUnsaved).size());
        forget(place.folder, stem + kLock);
    }
}

void Autosave::add_place(FolderHandle folder, const std::string& stem)
{
    std::vector<std::string> names;
    for (int number = 1; number <= kMostWalks; ++number) names.push_back(fmt::format("{}-{}", stem, number));
    const auto is_left = [&](const std::string& name) {
        return ::faccessat(folder.descriptor(), (name + kUnsaved).c_str(), F_OK, AT_SYMLINK_NOFOLLOW) == 0;
    };
    std::stable_partition(names.begin(), names.end(), is_left);  // what is left there is offered first
    for (const std::string& name : names) {
        std::optional<Descriptor> lock = taken_lock(folder, name + kLock);
        if (!lock) continue;
        places_.push_back({std::move(folder), name + kUnsaved, *std::move(lock)});
        return;
    }
    throw Error(
        {.what = "nothing can be kept, or too many walks go through one level", .file = folder.path().string()});
}

std::string Autosave::left() const
{
    std::string newest;
    fs::file_time_type newest_time = fs::file_time_type::min();
    for (const Place& place : places_) {
        try {
            const auto bytes = place.folder.read(place.name, limits::kMaxLevelFileBytes);
            std::error_code failed;
            const fs::file_time_type time = fs::last_write_time(place.folder.path() / place.name, failed);
            if (!bytes || failed || time < newest_time) continue;
            newest.assign(reinterpret_cast<const char*>(bytes->data()), bytes->size());
            newest_time = time;
        } catch (const Error& error) {
            log_warning(error.what());
        }
    }
    return newest;
}

void Autosave::keep(const std::string& text)
{
    if (text == kept_) return;
    const Place* taker = nullptr;
    std::optional<Error> failure;
    for (const Place& place : places_) {
        if (text.empty() || taker != nullptr) break;
        try {
            place.folder.write(place.name, std::as_bytes(std::span(text)));
            taker = &place;
        } catch (const Error& error) {
            failure = error;
        }
    }
    if (failure && taker == nullptr) throw *failure;
    for (const Place& place : places_)
        if (&place != taker) forget(place.folder, place.name);  // an older text
    kept_ = text;
}

}  // namespace hw
