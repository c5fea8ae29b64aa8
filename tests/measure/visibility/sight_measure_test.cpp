// What is counted as seen, drawn and lost, and where walkers get, on scenes whose answer is known.
#include "measure/visibility/sight_measure.hpp"

#include <gtest/gtest.h>

#include <set>

#include "hatchway/render/view/camera_view.hpp"
#include "measure/walk/walk_places.hpp"
#include "tests/world/scene_builder.hpp"

namespace hw {
namespace {

using measure::SightCounts;
using test::Compiled;
using test::SceneBuilder;

constexpr glm::ivec2 kSize{64, 64};

/// Two rooms with a wall between them and a box in each. Looks from the first at the wall.
struct TwoRooms {
    SceneBuilder builder;
    ObjectId near_box, far_box;
    Scene& scene;
    Compiled compiled;
    View view;

    TwoRooms() : near_box(add_rooms()), far_box(builder.box({6, -1, -1}, {7, 0, 1}, false)), scene(builder.scene())
    {
        compiled = test::compile(scene);
        view = camera_view({{-8, 0, 0}, {0, 0, 0}, 60.0}, kSize, scene.bounds_world);
    }
    ObjectId add_rooms()
    {
        builder.box({-10, -3, -5}, {10, 3, 5}, true);
        builder.box({-0.2, -3, -5}, {0.2, 3, 5}, false);
        return builder.box({-4, -1, -1}, {-3, 0, 1}, false);
    }
    SightCounts counts() const
    {
        return measure::SightJudge(scene, compiled.chunks, compiled.visibility).judge(view, kSize);
    }
};

TEST(sight_measure, counts_what_is_in_view_what_is_drawn_and_what_rays_meet)
{
    const SightCounts counts = TwoRooms().counts();
    EXPECT_EQ(counts.in_view, 48u) << "the shell and three boxes, 12 triangles each";
    EXPECT_EQ(counts.drawn, 36u) << "all but the box behind the wall";
    EXPECT_EQ(counts.needed, 36u) << "each object is a piece";
    // Floor, ceiling, the wall and the box's front; its top is seen edge-on, and the sides lie beside the picture.
    EXPECT_EQ(counts.met, 8u);
    EXPECT_EQ(counts.rays, 64u * 64u);
    EXPECT_EQ(counts.lost, 0u);
}

TEST(sight_measure, a_chunk_that_is_seen_and_hidden_is_lost)
{
    TwoRooms rooms;
    LeafRows& rows = rooms.compiled.visibility.slot_rows;
    for (int cluster = 0; cluster < rows.leaf_count(); ++cluster) rows.hide(cluster, static_cast<int>(rooms.far_box));
    EXPECT_EQ(rooms.counts().lost, 0u) << "nobody sees it";
    for (int cluster = 0; cluster < rows.leaf_count(); ++cluster) rows.hide(cluster, static_cast<int>(rooms.near_box));
    EXPECT_EQ(rooms.counts().lost, 1u);
    EXPECT_EQ(rooms.counts().drawn, 24u);
}

TEST(walk_places, are_all_that_a_walker_reaches_and_nothing_behind_a_wall)
{
    SceneBuilder builder;
    builder.box({-4, 0, -3}, {4, 3, 3}, true);
    builder.box({-0.2, 0, -3}, {0.2, 3, 3}, false);
    const CollisionWorld world = build_collision_world(builder.scene(), {});
    const PlayerBody body;
    const measure::Walker walker = [&](const PlayerState& state, const PlayerInput& input, double seconds) {
        return step(state, input, body, world, seconds);
    };
    const PlayerState start = placed_at({.eye_world = {-2, 1.7, 0}, .target_world = {-1, 1.7, 0}}, body, world);
    ASSERT_TRUE(start.is_carried);
    const auto places = measure::places_on_foot(walker, {&start, 1}, 0.5, 1000);
    std::set<std::pair<int, int>> cells;
    for (const PlayerState& place : places) {
        EXPECT_LT(place.foot_world.x, -0.2) << "behind the wall";
        EXPECT_NEAR(place.foot_world.y, 0.0, 0.01);
        cells.insert({static_cast<int>(std::floor(2 * place.foot_world.x)),
                      static_cast<int>(std::floor(2 * place.foot_world.z))});
    }
    EXPECT_EQ(cells.size(), places.size());
    EXPECT_EQ(places.size(), 7u * 12u) << "3.8 m less the body by 6 m, in cells of half a metre";
    EXPECT_EQ(measure::places_on_foot(walker, {&start, 1}, 0.5, 10).size(), 10u);
    const measure::Walker falls = [](PlayerState state, const PlayerInput&, double seconds) {
        state.foot_world.x += seconds;
        state.is_carried = false;
        return state;
    };
    EXPECT_EQ(measure::places_on_foot(falls, {&start, 1}, 0.5, 10).size(), 1u)
        << "who stands nowhere is nowhere on foot";
}

}  // namespace
}  // namespace hw
