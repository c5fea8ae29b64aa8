#include "hatchway/plugin_host/trial/library_verdicts.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <span>
#include <string_view>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/user_folders.hpp"
#include "hatchway/core/hash.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/style/plugin.hpp"

namespace hw {
namespace {

constexpr unsigned kPrivate = 0700;
constexpr std::uint64_t kMaxVerdictBytes = 1 << 16;
constexpr std::string_view kGood = "good";

}  // namespace

std::string verdict_key(const std::filesystem::path& library)
{
    // Not by core/files: what that has read belongs to a level, which is opened anew when it changes.
    std::ifstream file(library, std::ios::binary);
    std::uint64_t hash = hash_bytes({});
    std::array<char, 1 << 16> part;
    while (file.read(part.data(), part.size()) || file.gcount() > 0)
        hash = hash_bytes(std::as_bytes(std::span(part.data(), static_cast<std::size_t>(file.gcount()))), hash);
    if (!file.eof()) return {};
    const std::string_view build = HW_PLUGIN_BUILD;
    return fmt::format("{:016x}-{:016x}", hash, hash_bytes(std::as_bytes(std::span(build))));
}

LibraryVerdicts::LibraryVerdicts()
{
    try {
        folder_ = user_cache_folder().made_folder("plugins", kPrivate);
    } catch (const Error& error) {
        log_info(std::string(error.what()) + ": plugins are tried at every start");
    }
}

std::optional<std::string> LibraryVerdicts::of(const std::string& key) const
{
    if (!folder_ || key.empty()) return std::nullopt;
    try {
        const auto bytes = folder_->read(key, kMaxVerdictBytes);
        if (!bytes) return std::nullopt;
        const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
        if (text == kGood) return "";
        if (text.starts_with(kRefused)) return std::string(text.substr(std::strlen(kRefused)));
    } catch (const Error&) {
        // As if it were not there.
    }
    return std::nullopt;
}

void LibraryVerdicts::keep(const std::string& key, const std::string& why) const
{
    if (!folder_ || key.empty()) return;
    const std::string text = why.empty() ? std::string(kGood) : std::string(kRefused) + why;
    try {
        folder_->write(key, std::as_bytes(std::span(text)));
    } catch (const Error& error) {
        log_info(std::string(error.what()) + ": the plugin will be tried again");
    }
}

}  // namespace hw
