// Lightmaps, changed and signed anew: the input is patches.
#include "hatchway/core/hash.hpp"
#include "hatchway/io/compiled/lightmap_bytes.hpp"
#include "hatchway/world/light/bake.hpp"
#include "tests/fuzz/target.hpp"
#include "tests/io/compiled/rooms.hpp"

namespace {

std::string unsigned_bytes(const hw::Scene& scene)
{
    const hw::LightSources sources{.sky_luminance = glm::vec3(1000.0f)};
    const auto bytes = hw::lightmap_bytes(hw::bake_lightmap(scene, sources, {.luxels_per_m = 0.5, .samples = 1}));
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size() - sizeof(std::uint64_t)};
}

}  // namespace

void hw::fuzz::try_bytes(std::string_view bytes)
{
    static test::SceneBuilder builder;
    static const Scene& scene = test::rooms(builder);
    static const std::string good = unsigned_bytes(scene);
    std::string file = patched(good, bytes);
    const std::uint64_t hash = hash_bytes(std::as_bytes(std::span(file)));
    file.append(reinterpret_cast<const char*>(&hash), sizeof hash);
    const Lightmap lightmap = lightmap_from_bytes(std::as_bytes(std::span(file)), scene, "rooms.lightmap");
    require(lightmap_from_bytes(lightmap_bytes(lightmap), scene, "again") == lightmap);
}
