#include "hatchway/walk/autosave.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <span>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/user_folders.hpp"
#include "hatchway/core/hash.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/core/log.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

constexpr int kMostWalks = 16;  // through one level at once

}  // namespace

Autosave::Autosave(const fs::path& file)
{
    std::error_code failed;
    const std::string place = fs::weakly_canonical(fs::absolute(file, failed), failed).string();
    try {
        folder_ = user_state_folder();
        take_number(fmt::format("{:016x}", hash_bytes(std::as_bytes(std::span(place)))));
        kept_ = left();
    } catch (const Error& error) {
        folder_.reset();
        log_info(std::string(error.what()) + ": changes of this walk are kept only when they are saved");
    }
}

void Autosave::take_number(const std::string& stem)
{
    for (int number = 1; number <= kMostWalks; ++number) {
        const std::string name = fmt::format("{}-{}", stem, number);
        Descriptor lock(
            ::openat(folder_->descriptor(), (name + ".lock").c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600));
        if (!lock.is_open() || ::flock(lock.value(), LOCK_EX | LOCK_NB) != 0) continue;
        lock_ = std::move(lock);
        name_ = name + ".unsaved.json";
        return;
    }
    throw Error({.what = "too many walks go through one level", .file = folder_->path().string()});
}

std::string Autosave::left() const
{
    if (!folder_) return {};
    const auto bytes = folder_->read(name_, limits::kMaxLevelFileBytes);
    return bytes ? std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()) : std::string();
}

void Autosave::keep(const std::string& text)
{
    if (!folder_ || text == kept_) return;
    if (text.empty())
        folder_->remove(name_);
    else
        folder_->write(name_, std::as_bytes(std::span(text)));
    kept_ = text;
}

}  // namespace hw
