#include "hatchway/io/compiled/level.hpp"

#include <fmt/format.h>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files.hpp"
#include "hatchway/core/hash.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/io/compiled/read.hpp"
#include "hatchway/io/compiled/write.hpp"

namespace hw {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = ".hatchway";
constexpr const char* kEnding = ".compiled";

/// Also for a user whom no permission stops: a folder that is marked as not to be written into stays as it is.
void require_unprotected(const fs::path& folder)
{
    constexpr fs::perms kWrite = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    std::error_code failed;
    const fs::file_status status = fs::status(folder, failed);
    if (failed || !fs::is_directory(status)) throw Error({.what = "there is no such folder", .file = folder.string()});
    if ((status.permissions() & kWrite) == fs::perms::none)
        throw Error({.what = "the folder is write-protected", .file = folder.string()});
}

void require_folder_for(const fs::path& file)
{
    const fs::path folder = file.parent_path();
    std::error_code failed;
    if (!fs::exists(folder, failed)) {
        require_unprotected(folder.parent_path());
        fs::create_directory(folder, failed);
        if (failed) throw Error({.what = "the folder cannot be made: " + failed.message(), .file = folder.string()});
    }
    require_unprotected(folder);
}

}  // namespace

fs::path compiled_level_path(const Level& level, const fs::path& cache_folder)
{
    const std::string name = level.file.filename().string();
    const fs::path file = fs::absolute(level.file);
    if (cache_folder.empty())
        return resolve_inside(level.project_root, file.parent_path(), fmt::format("{}/{}{}", kFolder, name, kEnding),
                              level.file.string(), "");
    std::error_code failed;
    const std::string place = fs::weakly_canonical(file, failed).string();
    const std::uint64_t hash = hash_bytes(std::as_bytes(std::span(place)));
    return fs::absolute(cache_folder) / fmt::format("{}-{:016x}{}", name, hash, kEnding);
}

std::optional<CompiledLevel> find_compiled_level(const fs::path& file, std::uint64_t key, PvsEffort effort,
                                                 const Scene& scene, std::span<const MeshChunks> chunks_of_mesh)
{
    std::error_code missing;
    if (!fs::exists(fs::symlink_status(file, missing))) return std::nullopt;
    try {
        const std::vector<std::byte> bytes = read_file(file, limits::kMaxFileBytes);
        CompiledLevel level = compiled_level_from_bytes(bytes, scene, chunks_of_mesh, file.string());
        if (level.key != key || level.effort < effort) return std::nullopt;
        return level;
    } catch (const Error& error) {
        log_info(std::string(error.what()) + "; the level is compiled anew");
        return std::nullopt;
    }
}

void keep_compiled_level(const fs::path& file, const CompiledLevel& level, std::span<const MeshChunks> chunks_of_mesh)
{
    require_folder_for(file);
    write_file_atomically(file, std::span<const std::byte>(compiled_level_bytes(level, chunks_of_mesh)));
}

}  // namespace hw
