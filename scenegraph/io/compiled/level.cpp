#include "hatchway/io/compiled/level.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/folder_handle.hpp"
#include "hatchway/core/hash.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/io/compiled/read.hpp"

namespace hw {
namespace fs = std::filesystem;

std::string compiled_level_name(const Level& level)
{
    std::error_code failed;
    const std::string place = fs::weakly_canonical(fs::absolute(level.file, failed), failed).string();
    return fmt::format("{:016x}.v{}.compiled", hash_bytes(std::as_bytes(std::span(place))), kCompiledLevelVersion);
}

std::optional<CompiledLevel> find_compiled_level(const FolderHandle& cache, const std::string& name, std::uint64_t key,
                                                 PvsEffort effort, const Scene& scene,
                                                 std::span<const MeshChunks> chunks_of_mesh)
{
    try {
        const auto bytes = cache.read(name, limits::kMaxFileBytes);
        if (!bytes) return std::nullopt;
        CompiledLevel level = compiled_level_from_bytes(*bytes, scene, chunks_of_mesh, (cache.path() / name).string());
        if (level.key != key || level.effort < effort) return std::nullopt;
        return level;
    } catch (const Error& error) {
        log_info(std::string(error.what()) + "; it is left aside");
        return std::nullopt;
    }
}

}  // namespace hw
