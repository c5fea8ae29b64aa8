#include "hatchway/io/compiled/lightmap_bytes.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "hatchway/core/error.hpp"
#include "hatchway/world/light/bake.hpp"
#include "hatchway/world/light/random.hpp"
#include "measure/light/light_scenes.hpp"

using namespace hw;

TEST(lightmap_bytes, comes_back_as_it_was)
{
    const LightCase& room = light_case_named("lit room");
    const Lightmap lightmap = bake_lightmap(room.scene, room.sources, {.luxels_per_m = 2.0, .samples = 8});
    EXPECT_EQ(lightmap_from_bytes(lightmap_bytes(lightmap), room.scene, "room.light"), lightmap);
}

TEST(lightmap_bytes, damaged_or_cut_short_is_refused)
{
    const LightCase& sun = light_case_named("sun");
    const std::vector<std::byte> good =
        lightmap_bytes(bake_lightmap(sun.scene, sun.sources, {.luxels_per_m = 1.0, .samples = 8}));
    for (std::uint32_t i = 0; i < 10000; ++i) {
        std::vector<std::byte> bad = good;
        if (i % 4 == 0)
            bad.resize(mixed(i) % bad.size());
        else
            bad[mixed(i) % bad.size()] ^= static_cast<std::byte>(1u << (mixed(i + 77) % 8));
        EXPECT_THROW(lightmap_from_bytes(bad, sun.scene, "sun.light"), Error);
    }
}

TEST(lightmap_bytes, light_that_is_no_amount_is_refused)
{
    const LightCase& sun = light_case_named("sun");
    const Lightmap good = bake_lightmap(sun.scene, sun.sources, {.luxels_per_m = 1.0, .samples = 8});
    for (const std::uint16_t half : {0x7c00, 0x7e00, 0x8000, 0xfc00}) {
        Lightmap bad = good;
        bad.luxels[0][1] = half;
        EXPECT_THROW(lightmap_from_bytes(lightmap_bytes(bad), sun.scene, "sun.light"), Error) << half;
    }
    Lightmap bad = good;
    bad.luxels_per_m = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(lightmap_from_bytes(lightmap_bytes(bad), sun.scene, "sun.light"), Error);
}

TEST(lightmap_bytes, of_another_scene_is_refused)
{
    const LightCase& sun = light_case_named("sun");
    const std::vector<std::byte> bytes =
        lightmap_bytes(bake_lightmap(sun.scene, sun.sources, {.luxels_per_m = 1.0, .samples = 8}));
    EXPECT_THROW(lightmap_from_bytes(bytes, light_case_named("rectangle").scene, "sun.light"), Error);
    Scene other = sun.scene;
    std::swap(other.meshes[0].indices[0], other.meshes[0].indices[1]);
    EXPECT_THROW(lightmap_from_bytes(bytes, other, "sun.light"), Error);
}
