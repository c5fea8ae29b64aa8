#include "io/lightmap_file.hpp"

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/limits.hpp"
#include "core/log.hpp"

namespace hw {

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
    return lightmap_from_bytes(read_file(file, limits::kMaxFileBytes), scene, file.string());
}

std::optional<Lightmap> find_lightmap(const std::filesystem::path& level_file, const Scene& scene)
{
    const std::filesystem::path file = lightmap_path(level_file);
    std::error_code missing;
    if (!std::filesystem::is_regular_file(file, missing)) return std::nullopt;
    try {
        return read_lightmap(file, scene);
    } catch (const Error& error) {
        log_warning(std::string(error.what()) + "; shown without baked light, `hatchway bake` makes it anew");
        return std::nullopt;
    }
}

}  // namespace hw
