#include "hatchway/io/compiled/lightmap_file.hpp"

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/io/compiled/lightmap_bytes.hpp"
#include "hatchway/io/level/file.hpp"

namespace hw {
namespace {

namespace fs = std::filesystem;

/// The lightmap, which must be no link: a level's reader did not ask for a file elsewhere.
fs::path inside_project(const fs::path& file)
{
    return resolve_inside(find_project_root(file), fs::absolute(file).parent_path(), file.filename().string(),
                          file.string(), "");
}

}  // namespace

std::filesystem::path lightmap_path(const std::filesystem::path& level_file)
{
    std::filesystem::path path = level_file;
    return path += ".lightmap";
}

void write_lightmap(const std::filesystem::path& file, const Lightmap& lightmap)
{
    write_file_atomically(file, std::span<const std::byte>(lightmap_bytes(lightmap)));
}

Lightmap read_lightmap(const std::filesystem::path& file, const Scene& scene)
{
    return lightmap_from_bytes(read_file(inside_project(file), limits::kMaxFileBytes), scene, file.string());
}

std::optional<Lightmap> find_lightmap(const std::filesystem::path& level_file, const Scene& scene)
{
    const std::filesystem::path file = lightmap_path(level_file);
    std::error_code missing;
    if (!fs::exists(fs::symlink_status(file, missing))) return std::nullopt;
    try {
        return read_lightmap(file, scene);
    } catch (const Error& error) {
        log_warning(std::string(error.what()) + "; shown without baked light, `hatchway bake` makes it anew");
        return std::nullopt;
    }
}

}  // namespace hw
