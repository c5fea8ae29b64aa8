#include "tests/fuzz/target.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/geometry/surface/surface.hpp"
#include "hatchway/io/gltf/import.hpp"
#include "hatchway/io/model/settle_meshes.hpp"

namespace hw::fuzz {

void use_model(Scene scene)
{
    settle_meshes(scene);
    for (const Object& object : scene.objects)
        require(static_cast<std::size_t>(object.mesh) < scene.meshes.size() &&
                static_cast<std::size_t>(object.material) < scene.materials.size());
    for (const MeshData& mesh : scene.meshes) {
        for (const auto& indices : {mesh.indices, mesh.artist_edges})
            for (const std::uint32_t index : indices) require(index < mesh.positions.size());
        build_surface(mesh);
    }
}

void use_gltf(std::string_view bytes)
{
    static const int file = ::memfd_create("model", 0);
    require(::ftruncate(file, 0) == 0);
    require(::pwrite(file, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()));
    use_model(import_gltf("/proc/self/fd/" + std::to_string(file), "/proc/self/fd"));
}

std::string patched(std::string good, std::string_view patches)
{
    enum What : unsigned char { replace, insert, erase, cut };
    constexpr std::size_t kHead = 4;
    const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(patches[i])); };
    while (patches.size() >= kHead) {
        const std::size_t what = byte(0) % 4, count = byte(3);
        const std::size_t at = (byte(1) | byte(2) << 8) % (good.size() + 1);
        const std::string_view text = patches.substr(kHead, what == replace || what == insert ? count : 0);
        patches.remove_prefix(kHead + text.size());
        if (what == cut) good.resize(at);
        if (what == insert) good.insert(at, text);
        if (what == erase) good.erase(at, count);
        if (what == replace) good.replace(at, text.size(), text);
    }
    return good;
}

}  // namespace hw::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    hw::set_log_level(hw::LogLevel::off);
    try {
        hw::fuzz::try_bytes({reinterpret_cast<const char*>(data), size});
        ++hw::fuzz::taken;
    } catch (const hw::Error& error) {
        hw::fuzz::refusal = error.what();
        hw::fuzz::require(hw::exit_code(error) == 2);
    }
    return 0;
}
