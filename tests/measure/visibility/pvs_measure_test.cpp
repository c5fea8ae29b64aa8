// The measure of the visibility on input that is broken on purpose, with wrong values that are known.
#include "measure/visibility/pvs_measure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "measure/visibility/slit_scenes.hpp"
#include "tests/world/scene_builder.hpp"

namespace hw {
namespace {

using test::Compiled;
using test::SceneBuilder;

constexpr std::uint64_t kRays = 6400;

/// A closed cube; each of its walls is an object with one chunk. Every ray from inside ends on one wall.
SceneBuilder cube_of_six_walls()
{
    SceneBuilder builder;
    builder.quad({{{0, 0, 0}, {0, 4, 0}, {0, 4, 4}, {0, 0, 4}}});
    builder.quad({{{4, 0, 0}, {4, 0, 4}, {4, 4, 4}, {4, 4, 0}}});
    builder.quad({{{0, 0, 0}, {0, 0, 4}, {4, 0, 4}, {4, 0, 0}}});
    builder.quad({{{0, 4, 0}, {4, 4, 0}, {4, 4, 4}, {0, 4, 4}}});
    builder.quad({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}});
    builder.quad({{{0, 0, 4}, {0, 4, 4}, {4, 4, 4}, {4, 0, 4}}});
    return builder;
}

void lose_slot(Visibility& visibility, std::uint32_t slot)
{
    for (int cluster = 0; cluster < visibility.slot_rows.leaf_count(); ++cluster) {
        visibility.slot_rows.hide(cluster, static_cast<int>(slot));
    }
}

std::uint64_t false_invisibles(const Scene& scene, const Compiled& compiled)
{
    return measure::measure_pvs(scene, compiled.chunks, compiled.visibility, {.rays = kRays}).false_invisibles;
}

TEST(pvs_measure, whole_rows_have_no_false_invisibles)
{
    SceneBuilder builder = cube_of_six_walls();
    EXPECT_EQ(false_invisibles(builder.scene(), test::compile(builder.scene())), 0u);
}

TEST(pvs_measure, rows_that_lost_all_chunks_are_wrong_in_every_ray)
{
    SceneBuilder builder = cube_of_six_walls();
    Compiled compiled = test::compile(builder.scene());
    for (std::uint32_t slot = 0; slot < 6; ++slot) lose_slot(compiled.visibility, slot);
    EXPECT_EQ(false_invisibles(builder.scene(), compiled), kRays);
}

TEST(pvs_measure, rows_that_lost_one_of_six_walls_are_wrong_in_all_rays_aimed_at_it_and_in_a_sixth_of_the_others)
{
    SceneBuilder builder = cube_of_six_walls();
    for (std::uint32_t slot = 0; slot < 6; ++slot) {
        Compiled broken = test::compile(builder.scene());
        lose_slot(broken.visibility, slot);
        const double wrong = static_cast<double>(false_invisibles(builder.scene(), broken));
        EXPECT_NEAR(wrong, kRays / 2.0 + kRays / 12.0, 0.1 * kRays) << "wall " << slot;
    }
}

TEST(pvs_measure, of_a_scene_that_hides_nothing_says_no_share_of_it)
{
    SceneBuilder builder;
    const auto found = measure::measure_pvs(builder.scene(), {}, {}, {.rays = 64});
    EXPECT_EQ(found.hits, 0u);
    EXPECT_TRUE(std::isnan(found.row_share) && std::isnan(found.sampled_share));
}

TEST(slit_scenes, are_seen_and_hidden_as_known_at_every_effort)
{
    for (measure::SlitScene& slit : measure::slit_scenes()) {
        EXPECT_EQ(measure::is_target_met(slit), slit.is_seen) << slit.name;
        for (const PvsEffort effort : {PvsEffort::full, PvsEffort::exact}) {
            const Compiled compiled = test::compile(slit.scene, {.effort = effort});
            EXPECT_EQ(measure::is_target_shown(slit, compiled.visibility), slit.is_seen) << slit.name;
        }
        const Compiled fast = test::compile(slit.scene, {.effort = PvsEffort::fast});
        EXPECT_TRUE(measure::is_target_shown(slit, fast.visibility) || !slit.is_seen) << slit.name;
    }
}

TEST(slit_scenes, a_row_that_lost_the_target_shows_up_in_every_scene_whose_eye_reads_a_row)
{
    int read = 0;
    for (measure::SlitScene& slit : measure::slit_scenes()) {
        Compiled compiled = test::compile(slit.scene);
        for (std::uint32_t slot = compiled.visibility.first_slot_of_object[slit.target];
             slot < compiled.visibility.first_slot_of_object[slit.target + 1]; ++slot)
            lose_slot(compiled.visibility, slot);
        const bool reads = measure::reads_row(slit, compiled.visibility);
        EXPECT_EQ(measure::is_target_shown(slit, compiled.visibility), !reads) << slit.name;
        if (reads) ++read;
    }
    EXPECT_EQ(read, 12) << "of 13: all but the one-sided wall from behind";
}

}  // namespace
}  // namespace hw
