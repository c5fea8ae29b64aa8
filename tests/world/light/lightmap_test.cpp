#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/packing.hpp>
#include <limits>
#include <numbers>
#include <set>

#include "hatchway/core/error.hpp"
#include "hatchway/io/compiled/lightmap_bytes.hpp"
#include "hatchway/world/light/bake.hpp"
#include "hatchway/world/light/charts.hpp"
#include "hatchway/world/light/lamp_choice.hpp"
#include "hatchway/world/light/layout.hpp"
#include "hatchway/world/light/pack.hpp"
#include "hatchway/world/light/random.hpp"
#include "hatchway/world/open_backs.hpp"
#include "measure/light/light_error.hpp"
#include "measure/light/light_reference.hpp"

namespace {

using namespace hw;

MeshData box_mesh()
{
    Scene scene;
    add_box(scene, add_material(scene, 0.5f), {{0, 0, 0}, {2, 1, 3}});
    return scene.meshes[0];
}

/// A floor of n x n squares, its corners shared.
MeshData grid_mesh(std::uint32_t n, double side, double bulge = 0.0)
{
    MeshData mesh;
    for (std::uint32_t z = 0; z <= n; ++z)
        for (std::uint32_t x = 0; x <= n; ++x) {
            const double u = double(x) / n, v = double(z) / n;
            const double height = bulge * std::sin(std::numbers::pi * u) * std::sin(std::numbers::pi * v);
            mesh.positions.emplace_back(side * u, height, side * v);
            mesh.normals.emplace_back(0.0f);
        }
    for (std::uint32_t z = 0; z < n; ++z)
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t a = z * (n + 1) + x;
            for (const std::uint32_t v : {a, a + n + 1, a + n + 2, a, a + n + 2, a + 1}) mesh.indices.push_back(v);
        }
    return mesh;
}

/// Two squares of a metre that share an edge, the second folded up.
MeshData folded_mesh(double angle_rad)
{
    MeshData mesh;
    const auto c = static_cast<float>(std::cos(angle_rad)), s = static_cast<float>(std::sin(angle_rad));
    mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}, {1 + c, s, 1}, {1 + c, s, 0}};
    mesh.normals.resize(6, glm::vec3(0.0f));
    mesh.indices = {0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5};
    return mesh;
}

Scene scene_of(MeshData mesh, const glm::dmat4& world_from_object = glm::dmat4(1.0))
{
    Scene scene;
    add_material(scene, 0.0f);
    scene.meshes.push_back(std::move(mesh));
    scene.nodes.push_back({.world_from_node = world_from_object});
    scene.objects.push_back({.node = 0, .mesh = 0, .material = 0});
    return scene;
}

Light lamp_at(const glm::dvec3& position)
{
    return {.type = LightType::point, .intensity = 1000.0f, .position_world = position};
}

Light sun_along(const glm::dvec3& direction)
{
    return {.type = LightType::sun, .intensity = 10000.0f, .direction_world = glm::normalize(direction)};
}

constexpr BakeOptions kQuick{.luxels_per_m = 4.0, .samples = 16};

LightError final_error(const std::string& name)
{
    const LightCase& known = light_case_named(name);
    BakeOptions options = bake_options(BakeQuality::final);
    options.luxels_per_m = known.luxels_per_m;
    return light_error(bake_lightmap(known.scene, known.sources, options), known);
}

double lux_at(const Lightmap& lightmap, const Scene& scene, const SurfacePoint& point)
{
    return baked_illuminance(lightmap, scene, point).g;
}

const glm::vec3 kMiddle(1.0f / 3.0f);

}  // namespace

TEST(planar_charts, a_box_has_six)
{
    EXPECT_EQ(planar_charts(box_mesh()).size(), 6u);
}

TEST(planar_charts, a_flat_floor_of_many_triangles_is_one)
{
    const auto charts = planar_charts(grid_mesh(9, 3.0));
    ASSERT_EQ(charts.size(), 1u);
    EXPECT_EQ(charts[0].triangles.size(), 162u);
    EXPECT_NEAR(charts[0].area, 9.0, 1e-5);
}

TEST(planar_charts, a_fold_of_a_degree_cuts_and_one_of_a_thousandth_does_not)
{
    EXPECT_EQ(planar_charts(folded_mesh(0.0175)).size(), 2u);
    EXPECT_EQ(planar_charts(folded_mesh(0.0000175)).size(), 1u);
}

TEST(planar_charts, a_triangle_without_area_joins_its_neighbour)
{
    MeshData mesh = folded_mesh(0.5);
    mesh.positions.emplace_back(0.5f, 0.0f, 0.0f);
    mesh.normals.emplace_back(0.0f);
    mesh.indices.insert(mesh.indices.end(), {0, 3, 6});
    EXPECT_EQ(planar_charts(mesh).size(), 2u);
}

TEST(planar_charts, a_sheet_and_its_other_side_are_two)
{
    MeshData mesh = folded_mesh(0.0);
    const std::vector<std::uint32_t> front = mesh.indices;
    for (std::size_t i = 0; i < front.size(); i += 3)
        mesh.indices.insert(mesh.indices.end(), {front[i], front[i + 2], front[i + 1]});
    EXPECT_EQ(planar_charts(mesh).size(), 2u);
}

TEST(packing, rectangles_do_not_overlap)
{
    std::vector<glm::ivec2> sizes;
    for (std::uint32_t i = 0; i < 200; ++i)
        sizes.emplace_back(1 + static_cast<int>(mixed(i) % 20), 1 + static_cast<int>(mixed(i + 999) % 20));
    const Packing packing = pack_in_rows(sizes, 64);
    std::set<std::pair<int, int>> taken;
    std::size_t area = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        area += static_cast<std::size_t>(sizes[i].x) * sizes[i].y;
        for (int y = 0; y < sizes[i].y; ++y)
            for (int x = 0; x < sizes[i].x; ++x) {
                EXPECT_LT(packing.corners[i].x + x, 64);
                EXPECT_LT(packing.corners[i].y + y, packing.height);
                taken.insert({packing.corners[i].x + x, packing.corners[i].y + y});
            }
    }
    EXPECT_EQ(taken.size(), area);
}

TEST(lay_out, charts_take_whole_luxels_and_have_a_border)
{
    const LightmapLayout layout = lay_out(box_mesh(), 4.0);
    EXPECT_FALSE(layout.is_per_vertex);
    std::set<std::pair<int, int>> taken;
    std::size_t area = 0;
    for (std::size_t face = 0; face < 6; ++face) {
        glm::vec2 low(1e9f), high(-1e9f);
        for (std::size_t k = 0; k < 6; ++k) {
            const glm::vec2 uv = layout.uv[layout.indices[face * 6 + k]];
            low = glm::min(low, uv);
            high = glm::max(high, uv);
            EXPECT_NEAR(uv.x, std::round(uv.x), 1e-4);
            EXPECT_NEAR(uv.y, std::round(uv.y), 1e-4);
        }
        const glm::ivec2 from = glm::ivec2(glm::round(low)) - 1;
        const glm::ivec2 to = glm::ivec2(glm::round(high)) + 1;
        EXPECT_GE(from.x, 0);
        EXPECT_LE(to.x, layout.size.x);
        EXPECT_LE(to.y, layout.size.y);
        area += static_cast<std::size_t>(to.x - from.x) * (to.y - from.y);
        for (int y = from.y; y < to.y; ++y)
            for (int x = from.x; x < to.x; ++x) taken.insert({x, y});
    }
    EXPECT_EQ(taken.size(), area) << "charts overlap";
    EXPECT_EQ(area, 2u * (10 * 6 + 10 * 14 + 6 * 14));
}

TEST(lay_out, a_vertex_of_two_charts_is_copied_and_nothing_moves)
{
    const MeshData before = folded_mesh(1.0);
    const LightmapLayout layout = lay_out(before, 4.0);
    EXPECT_EQ(layout.copied_vertices.size(), 2u);
    MeshData after = before;
    add_lightmap_stream(after, layout);
    EXPECT_EQ(after.positions.size(), 8u);
    EXPECT_EQ(after.normals.size(), 8u);
    EXPECT_EQ(after.lightmap_uv.size(), 8u);
    ASSERT_EQ(after.indices.size(), before.indices.size());
    for (std::size_t i = 0; i < before.indices.size(); ++i)
        EXPECT_EQ(after.positions[after.indices[i]], before.positions[before.indices[i]]);
}

TEST(lay_out, a_finely_curved_mesh_is_lit_per_vertex)
{
    EXPECT_TRUE(lay_out(grid_mesh(30, 1.0, 0.4), 4.0).is_per_vertex);
    EXPECT_FALSE(lay_out(grid_mesh(3, 12.0, 2.0), 4.0).is_per_vertex);
}

TEST(lay_out, an_empty_mesh_has_none)
{
    EXPECT_TRUE(lay_out(MeshData{}, 4.0).is_empty());
}

TEST(plan_lightmap, a_small_budget_makes_larger_luxels)
{
    const Scene scene = scene_of(grid_mesh(1, 20.0));
    const Lightmap lightmap = plan_lightmap(scene, 8.0, 2000);
    EXPECT_LT(lightmap.luxels_per_m, 2.3);
    EXPECT_LE(lightmap.luxels.size(), 2000u);
    EXPECT_THROW(plan_lightmap(scene, 8.0, 3), Error);
}

TEST(plan_lightmap, fits_scenes_of_any_size_as_densely_as_its_budget_allows)
{
    for (const double size_m : {1.0, 1e3, 1e6, 1e9, 1e12}) {
        SCOPED_TRACE(size_m);
        Scene scene;
        add_box(scene, add_material(scene, 0.5f), {glm::dvec3(0.0), glm::dvec3(size_m)});
        for (const double luxels_per_m : {0.01, 2.0, 1000.0}) {
            const Lightmap lightmap = plan_lightmap(scene, luxels_per_m, 100'000);
            EXPECT_LE(lightmap.luxels.size(), 100'000u);
            EXPECT_TRUE(lightmap.luxels_per_m == luxels_per_m || lightmap.luxels.size() > 50'000);
        }
    }
}

TEST(plan_lightmap, all_but_unlit_objects_have_luxels)
{
    Scene scene;
    for (int i = 0; i < 4; ++i) add_box(scene, add_material(scene, 0.5f), {{0, 0, 0}, {1, 1, 1}});
    scene.nodes[1].is_animated = true;
    scene.materials[2].alpha_mode = AlphaMode::blend;
    scene.materials[3].is_unlit = true;
    const Lightmap lightmap = plan_lightmap(scene, 2.0, 100000);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(lightmap.places[i].sides, 1);
    EXPECT_EQ(lightmap.places[3].sides, 0);
    EXPECT_TRUE(blended_luxels(lightmap, scene, {.object = 3}).empty());
}

TEST(plan_lightmap, only_receivers_get_a_place_where_some_are_named)
{
    Scene scene;
    for (int i = 0; i < 3; ++i) add_box(scene, add_material(scene, 0.5f), {{i, 0, 0}, {i + 1, 1, 1}});
    const std::vector<ObjectId> receivers{1};
    const Lightmap lightmap = plan_lightmap(scene, 2.0, 100000, receivers);
    EXPECT_EQ(lightmap.places[0].sides, 0);
    EXPECT_EQ(lightmap.places[1].sides, 1);
    EXPECT_EQ(lightmap.places[2].sides, 0);
    EXPECT_LT(lightmap.luxels.size(), plan_lightmap(scene, 2.0, 100000).luxels.size());
    EXPECT_EQ(lightmap_from_bytes(lightmap_bytes(lightmap), scene, "test"), lightmap);
}

TEST(light_samples, the_first_64_fall_one_each_into_8_by_8_cells)
{
    for (const std::uint32_t seed : {1u, 77u}) {
        std::set<std::pair<int, int>> cells;
        for (std::uint32_t i = 0; i < 64; ++i) {
            const glm::vec2 p = sample_2d(i, 3, seed);
            cells.insert({static_cast<int>(p.x * 8.0f), static_cast<int>(p.y * 8.0f)});
        }
        EXPECT_EQ(cells.size(), 64u);
    }
}

TEST(light_samples, two_sequences_are_independent)
{
    // Quarters of one against quarters of the other: chi-square with 9 degrees of freedom. Its mean is 9 for chance and
    // 13.4 for scrambling by hashes; sequences that are the same give 3072.
    constexpr int kSeeds = 100;
    double sum = 0.0;
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        std::vector<int> counts(16, 0);
        for (std::uint32_t i = 0; i < 1024; ++i) {
            const float a = sample_2d(i, 0, seed).x, b = sample_2d(i, 1, seed).x;
            ++counts[static_cast<int>(a * 4.0f) * 4 + static_cast<int>(b * 4.0f)];
        }
        for (const int count : counts) sum += (count - 64.0) * (count - 64.0) / 64.0;
    }
    EXPECT_LT(sum / kSeeds, 16.0);
}

TEST(baked_light, final_quality_is_within_a_percent_under_a_point)
{
    EXPECT_LT(final_error("point").rms, 0.01);
}
TEST(baked_light, final_quality_is_within_a_percent_under_a_sun)
{
    EXPECT_LT(final_error("sun").rms, 0.001);
}
TEST(baked_light, final_quality_is_within_a_percent_under_a_rectangle)
{
    EXPECT_LT(final_error("rectangle").rms, 0.01);
}
TEST(baked_light, final_quality_is_within_a_percent_under_a_covered_sky)
{
    EXPECT_LT(final_error("covered sky").rms, 0.01);
}
TEST(baked_light, a_wall_that_stands_on_a_floor_darkens_its_sunny_foot_and_nothing_else)
{
    const LightError foot = final_error("foot of the wall"), all = final_error("wall on the floor");
    EXPECT_LT(foot.bias, -0.01) << "the rule against leaks has its price, and the measure sees it";
    EXPECT_GT(foot.bias, -0.6);
    EXPECT_LT(std::abs(all.bias), 0.1);
}
TEST(baked_light, final_quality_is_within_a_percent_where_light_bounces_for_ever)
{
    EXPECT_LT(final_error("bright closed room").rms, 0.01);
}

TEST(baked_light, no_luxel_of_a_closed_room_is_lit_from_outside)
{
    for (const DarkRoom& room : dark_rooms())
        for (const double density : {1.0, 4.0}) {
            const Lightmap lightmap = bake_lightmap(room.scene, room.sources, {.luxels_per_m = density, .samples = 16});
            const LeakCount leaks = count_leaks(lightmap, room);
            EXPECT_GT(leaks.seen, 50u) << room.name;
            EXPECT_EQ(leaks.leaked, 0u) << room.name << ' ' << density << ": " << leaks.brightest_lux << " lux";
        }
}

TEST(baked_light, a_luxel_on_or_behind_a_wall_takes_the_dark_side)
{
    // A wall of 0.05 m stands across a floor, on the line between two luxels and on the middle of one.
    for (const double wall_at : {0.0, 0.125}) {
        Scene scene;
        const int black = add_material(scene, 0.0f);
        const ObjectId floor = add_quad(scene, black, {-2, 0, -2}, {0, 0, 4}, {4, 0, 0});
        add_box(scene, black, {{wall_at, 0, -9}, {wall_at + 0.05, 9, 9}});
        LightSources sources;
        sources.lights = {lamp_at({-1.0, 1.0, 0.0})};
        const Lightmap lightmap = bake_lightmap(scene, sources, kQuick);
        for (const ComparedPoint& p : compared_points(scene, floor, 400.0)) {
            const double lux = lux_at(lightmap, scene, p.point);
            if (p.place_world.x > wall_at + 0.05) {
                EXPECT_EQ(lux, 0.0) << p.place_world.x;
            }
            if (p.place_world.x < wall_at - 0.5) {
                EXPECT_GT(lux, 10.0) << p.place_world.x;
            }
        }
    }
}

TEST(baked_light, the_floor_under_a_chest_does_not_darken_the_floor_beside_it)
{
    Scene scene;
    const int black = add_material(scene, 0.0f);
    const ObjectId floor = add_quad(scene, black, {-2, 0, -2}, {0, 0, 4}, {4, 0, 0});
    const Box chest{{-0.5, 0.0, -0.5}, {0.5, 0.6, 0.5}};
    add_box(scene, black, chest);
    LightSources sources;
    sources.lights = {sun_along({0.0, -1.0, 0.0})};
    const Lightmap lightmap = bake_lightmap(scene, sources, kQuick);
    for (const ComparedPoint& p : compared_points(scene, floor, 400.0)) {
        const bool is_under = std::abs(p.place_world.x) < 0.51 && std::abs(p.place_world.z) < 0.51;
        if (!is_under) {
            EXPECT_NEAR(lux_at(lightmap, scene, p.point), 10000.0, 10.0);
        }
    }
}

TEST(baked_light, a_light_in_a_faces_plane_gives_it_nothing)
{
    const Scene scene = scene_of(grid_mesh(1, 2.0));
    LightSources sources;
    sources.lights = {lamp_at({1.0, 0.0, 1.0}), sun_along({1.0, 0.0, 0.2})};
    const Lightmap lightmap = bake_lightmap(scene, sources, kQuick);
    for (std::uint32_t i = 0; i < lightmap.luxels.size(); ++i) EXPECT_EQ(luxel_illuminance(lightmap, i).g, 0.0f);
}

/// Of few lamps each is asked, of many some: they have to give what all do.
TEST(baked_light, of_many_lamps_is_that_of_their_parts)
{
    Scene scene = scene_of(grid_mesh(1, 6.0));
    add_box(scene, add_material(scene, 0.5f), {{2, 0, 2}, {3, 1, 3}});
    std::vector<Light> lamps;
    for (std::uint32_t i = 0; i < 128; ++i) {
        const glm::vec2 place = 6.0f * sample_2d(i, 0, 1);
        lamps.push_back(lamp_at({place.x, 0.5 + 0.02 * i, place.y}));
        lamps.back().intensity *= i % 7 == 0 ? 10.0f : 0.1f;
        if (i % 3 == 0) lamps.back().range_m = 2.0f;
        if (i % 2 == 0) continue;
        lamps.back().type = LightType::spot;
        lamps.back().direction_world = glm::normalize(glm::dvec3(0.01 * i - 0.6, -1.0, 0.3));
    }
    for (const double x : {0.2, -0.5, 4.0}) lamps.push_back(sun_along({x, -1.0, 0.1}));
    const auto baked = [&](std::size_t first, std::size_t end) {
        LightSources sources;
        sources.lights.assign(lamps.begin() + first, lamps.begin() + end);
        return bake_lightmap(scene, sources, {.luxels_per_m = 1.0, .samples = 256});
    };
    const Lightmap all = baked(0, lamps.size());
    double error = 0.0, total = 0.0, total_of_all = 0.0;
    std::vector<double> sums(all.luxels.size(), 0.0);
    for (std::size_t first = 0; first < lamps.size(); first += LampChoice::kMostAsked) {
        const Lightmap part = baked(first, std::min(lamps.size(), first + LampChoice::kMostAsked));
        for (std::uint32_t i = 0; i < sums.size(); ++i) sums[i] += luxel_illuminance(part, i).g;
    }
    for (std::uint32_t i = 0; i < sums.size(); ++i) {
        error += std::abs(luxel_illuminance(all, i).g - sums[i]);
        total += sums[i];
        total_of_all += luxel_illuminance(all, i).g;
    }
    EXPECT_GT(total, 0.0);
    EXPECT_LT(error / total, 0.05) << "noise";
    EXPECT_NEAR(total_of_all / total, 1.0, 0.01) << "the mean";
}

TEST(baked_light, a_double_sided_sheet_has_light_of_its_own_on_each_side)
{
    Scene scene = scene_of(grid_mesh(1, 2.0));
    scene.materials[0].is_double_sided = true;
    LightSources sources;
    sources.lights = {sun_along({0.0, -1.0, 0.0})};
    const Lightmap lightmap = bake_lightmap(scene, sources, kQuick);
    EXPECT_NEAR(lux_at(lightmap, scene, {0, 0, kMiddle, false}), 10000.0, 10.0);
    EXPECT_EQ(lux_at(lightmap, scene, {0, 0, kMiddle, true}), 0.0);
}

TEST(baked_light, a_vertex_lit_sheet_has_two_sides_too)
{
    Scene scene = scene_of(grid_mesh(30, 1.0, 0.05));
    scene.materials[0].is_double_sided = true;
    LightSources sources;
    sources.lights = {sun_along({0.0, -1.0, 0.0})};
    const Lightmap lightmap = bake_lightmap(scene, sources, kQuick);
    ASSERT_TRUE(lightmap.layouts[0].is_per_vertex);
    EXPECT_NEAR(lux_at(lightmap, scene, {0, 900, kMiddle, false}), 10000.0, 200.0);
    EXPECT_EQ(lux_at(lightmap, scene, {0, 900, kMiddle, true}), 0.0);
}

namespace {

/// A closed box of 4 m with two sides to its faces under a bright sun, and a crate of a metre beside it.
struct BoxOutside {
    BoxOutside()
    {
        const int material = add_material(scene, 0.5f);
        scene.materials[material].is_double_sided = true;
        box = add_box(scene, material, {{-2, 0, -2}, {2, 3, 2}});
        crate = add_box(scene, material, {{4, 0, 0}, {5, 1, 1}});
        sources.lights = {sun_along({0.3, -1.0, 0.2})};
    }
    /// Of the middle of the box' floor (the triangle that looks down) from within; of its roof from outside.
    double lux(bool is_inside) const { return lux(is_inside, is_inside ? 0.0f : 3.0f); }
    double lux(bool is_inside, float wanted) const
    {
        const Lightmap lightmap = bake_lightmap(scene, sources, kQuick);
        EXPECT_EQ(lightmap.places[crate].sides, 1) << "beside it is a solid";
        const MeshData& mesh = scene.meshes[scene.objects[box].mesh];
        for (std::uint32_t triangle = 0; triangle < mesh.triangle_count(); ++triangle) {
            const auto height = [&](int k) { return mesh.positions[mesh.indices[3 * triangle + k]].y; };
            if (height(0) == wanted && height(1) == wanted && height(2) == wanted)
                return lux_at(lightmap, scene, {box, triangle, kMiddle, is_inside});
        }
        return -1.0;
    }

    Scene scene;
    LightSources sources;
    ObjectId box = 0, crate = 0;
};

}  // namespace

TEST(baked_light, a_closed_box_with_a_lamp_inside_is_a_room_and_its_inside_has_the_lamps_light)
{
    BoxOutside level;
    const double outside = level.lux(false);
    EXPECT_GT(outside, 5000.0);
    level.sources.lights.push_back(lamp_at({0.0, 2.0, 0.0}));
    EXPECT_NEAR(level.lux(false), outside, 0.05 * outside) << "its outside is as bright as it was";
    EXPECT_GT(level.lux(true), 100.0);
    EXPECT_LT(level.lux(true), 1500.0) << "1,000 cd at 2 m, and what the walls send back";
}

TEST(baked_light, a_closed_box_around_something_that_shines_is_a_room)
{
    BoxOutside level;
    const int glowing = add_material(level.scene, 0.5f, 1.0f);
    level.sources.emission_luminance = 1000.0f;
    level.scene.materials[glowing].is_double_sided = true;
    const ObjectId bulb = add_box(level.scene, glowing, {{-0.2, 1.8, -0.2}, {0.2, 2.2, 0.2}});
    const std::vector<bool> open = find_open_backs(level.scene);
    EXPECT_TRUE(open[level.box]);
    EXPECT_FALSE(open[level.crate]);
    EXPECT_FALSE(open[bulb]) << "what shines is not inside of itself";
}

TEST(baked_light, a_crate_with_something_in_it_and_lamps_around_it_stays_a_solid)
{
    BoxOutside level;
    add_box(level.scene, add_material(level.scene, 0.5f), {{4.3, 0.2, 0.3}, {4.6, 0.5, 0.6}});
    const std::vector<Light> lamps{lamp_at({3.9, 0.5, 0.5}), lamp_at({4.5, 1.1, 0.5}), sun_along({0, -1, 0})};
    EXPECT_EQ(find_open_backs(level.scene, lamps), std::vector<bool>(3, false));
    level.scene.materials[0].is_double_sided = false;
    EXPECT_FALSE(find_open_backs(level.scene, std::vector<Light>{lamp_at({0, 1, 0})})[level.box]);
}

TEST(baked_light, a_closed_box_around_an_eye_is_a_room_and_dark_inside)
{
    BoxOutside level;
    const double outside = level.lux(false);
    const std::uint64_t key = lightmap_key(level.scene, level.sources);
    level.sources.eyes_world = {{7.0, 1.0, 0.0}, {0.0, 4.0, 0.0}};
    EXPECT_EQ(lightmap_key(level.scene, level.sources), key) << "who looks from outside changes nothing";
    EXPECT_GT(level.lux(true, 3.0f), 1000.0) << "the back of a solid's roof has the light of its front";
    level.sources.eyes_world.push_back({1.0, 1.7, 0.5});
    for (const float height : {0.0f, 3.0f}) EXPECT_EQ(level.lux(true, height), 0.0);
    EXPECT_NEAR(level.lux(false), outside, 0.05 * outside);
    const std::uint64_t room_key = lightmap_key(level.scene, level.sources);
    EXPECT_NE(room_key, key);
    level.sources.eyes_world.back().x = -1.0;
    EXPECT_EQ(lightmap_key(level.scene, level.sources), room_key) << "a camera may move about in its room";
}

TEST(baked_light, a_room_is_one_however_it_is_placed)
{
    for (const glm::dvec3& scale : {glm::dvec3(1.0), glm::dvec3(-1, 1, 1), glm::dvec3(3, 0.2, 1)}) {
        Scene scene;
        const int material = add_material(scene, 0.5f);
        scene.materials[material].is_double_sided = true;
        const glm::dmat4 place = glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(1e4, 5, -3)), scale);
        add_box(scene, material, {{-2, 0, -2}, {2, 3, 2}}, place);
        const auto is_open = [&](const glm::dvec3& lamp_in_box) -> bool {
            return find_open_backs(scene, std::vector<Light>{lamp_at(place * glm::dvec4(lamp_in_box, 1.0))})[0];
        };
        EXPECT_TRUE(is_open({1.9, 2.9, -1.9}));
        EXPECT_FALSE(is_open({2.1, 1.0, 0.0}));
        EXPECT_FALSE(is_open({0.0, -0.1, 0.0}));
    }
}

TEST(baked_light, light_falls_through_what_a_mask_cuts_out)
{
    for (const std::uint8_t alpha : {0, 255}) {
        Scene scene;
        const ObjectId floor = add_quad(scene, add_material(scene, 0.0f), {-0.5, 0, -0.5}, {0, 0, 1}, {1, 0, 0});
        const int masked = add_material(scene, 0.0f);
        scene.images.push_back({1, 1, 4, {255, 255, 255, alpha}});
        scene.textures.push_back({.image = 0});
        scene.materials[masked].alpha_mode = AlphaMode::mask;
        scene.materials[masked].base_colour_texture.texture = 0;
        add_quad(scene, masked, {-5, 1, -5}, {0, 0, 10}, {10, 0, 0});
        scene.meshes.back().uv0.resize(4, glm::vec2(0.0f));
        LightSources sources;
        sources.lights = {sun_along({0.0, -1.0, 0.0})};
        const Lightmap lightmap = bake_lightmap(scene, sources, kQuick);
        EXPECT_NEAR(lux_at(lightmap, scene, {floor, 0, kMiddle, false}), alpha == 0 ? 10000.0 : 0.0, 10.0);
    }
}

TEST(baked_light, what_moves_and_glass_have_the_light_of_their_place_and_take_none_away)
{
    for (const bool is_glass : {false, true}) {
        Scene scene;
        const int plain = add_material(scene, 0.0f), own = add_material(scene, 0.0f);
        const ObjectId floor = add_quad(scene, plain, {-4, 0, -4}, {0, 0, 8}, {8, 0, 0});
        add_quad(scene, plain, {-4, 3, -4}, {0, 0, 8}, {4, 0, 0});
        scene.materials[plain].is_double_sided = true;
        const ObjectId shaded = add_box(scene, own, {{-2.5, 1, -0.5}, {-1.5, 2, 0.5}});
        const ObjectId sunny = add_box(scene, own, {{1.5, 1, -0.5}, {2.5, 2, 0.5}});
        for (const ObjectId id : {shaded, sunny}) scene.nodes[scene.objects[id].node].is_animated = !is_glass;
        if (is_glass) scene.materials[own].alpha_mode = AlphaMode::blend;
        LightSources sources;
        sources.lights = {sun_along({0.0, -1.0, 0.0})};
        const Lightmap lightmap = bake_lightmap(scene, sources, kQuick);
        const auto top_of = [&](ObjectId box) {
            double lux = 0.0;
            for (std::uint32_t t = 0; t < 12; ++t) lux = std::max(lux, lux_at(lightmap, scene, {box, t, kMiddle}));
            return lux;
        };
        EXPECT_NEAR(top_of(sunny), 10000.0, 10.0);
        EXPECT_EQ(top_of(shaded), 0.0);
        // The middle of the floor's second triangle lies below the sunny box.
        EXPECT_NEAR(lux_at(lightmap, scene, {floor, 1, {0.25f, 0.5f, 0.25f}}), 10000.0, 10.0);
    }
}

TEST(baked_light, instances_that_are_scaled_turned_or_mirrored_get_the_light_of_their_place)
{
    const glm::dmat4 one(1.0);
    const glm::dmat4 moved = glm::translate(one, {3.0, 1.0, -2.0});
    for (const glm::dmat4& matrix : {glm::scale(moved, {3.0, 1.0, 2.0}), glm::rotate(moved, 0.6, {0.3, 0.2, 0.9}),
                                     glm::scale(moved, {-2.0, 1.0, 1.0})}) {
        const Scene scene = scene_of(grid_mesh(1, 1.0), matrix);
        const glm::dvec3 up = glm::normalize(glm::transpose(glm::inverse(glm::dmat3(matrix))) * glm::dvec3(0, 1, 0));
        const glm::dvec3 lamp = glm::dvec3(matrix * glm::dvec4(0.5, 0.0, 0.5, 1.0)) + 2.0 * up;
        LightSources sources;
        sources.lights = {lamp_at(lamp)};
        const Lightmap lightmap = bake_lightmap(scene, sources, {.luxels_per_m = 8.0, .samples = 16});
        for (const ComparedPoint& p : compared_points(scene, 0, 50.0)) {
            const double expected = point_illuminance(1000.0, lamp, p.place_world, up);
            EXPECT_NEAR(lux_at(lightmap, scene, p.point), expected, 0.01 * expected + 1.0);
        }
    }
}

TEST(baked_light, the_smallest_instance_shares_the_layout_of_the_largest)
{
    Scene scene = scene_of(grid_mesh(1, 1.0));
    scene.nodes.push_back({.world_from_node = glm::scale(glm::dmat4(1.0), glm::dvec3(4.0))});
    scene.objects.push_back({.node = 1, .mesh = 0, .material = 0});
    const Lightmap lightmap = plan_lightmap(scene, 2.0, 1 << 20);
    EXPECT_EQ(lightmap.layouts[0].size, glm::ivec2(10));
    EXPECT_NE(lightmap.places[0].corner, lightmap.places[1].corner);
}

TEST(baked_light, one_thread_and_two_give_the_same_bytes)
{
    const LightCase& room = light_case_named("lit room");
    const auto bytes_with = [&](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        return lightmap_bytes(bake_lightmap(room.scene, room.sources, {.luxels_per_m = 2.0, .samples = 16}));
    };
    EXPECT_EQ(bytes_with(1), bytes_with(2));
}

TEST(baked_light, another_seed_is_other_noise_of_the_same_light)
{
    const LightCase& room = light_case_named("lit room");
    const auto baked = [&](std::uint32_t seed) {
        return bake_lightmap(room.scene, room.sources, {.luxels_per_m = 2.0, .samples = 64, .seed = seed});
    };
    const Lightmap first = baked(0), second = baked(1);
    EXPECT_EQ(lightmap_bytes(first), lightmap_bytes(baked(0)));
    const LightError difference = light_difference(first, second, room);
    EXPECT_GT(difference.rms, 0.01);
    EXPECT_LT(difference.rms, 0.1);
}

TEST(baked_light, passes_are_shown_as_they_come_and_the_last_is_the_result)
{
    const LightCase& sun = light_case_named("sun");
    std::vector<std::uint32_t> samples;
    Lightmap last;
    const Lightmap result = bake_lightmap(sun.scene, sun.sources, kQuick, [&](const BakeState& state) {
        samples.push_back(state.samples);
        last = state.lightmap;
    });
    EXPECT_EQ(samples, (std::vector<std::uint32_t>{8, 16}));
    EXPECT_EQ(last, result);
}

TEST(baked_light, takes_no_more_samples_than_its_budget_of_rays_holds)
{
    const LightCase& sun = light_case_named("sun");
    const auto taken = [&](std::uint64_t rays) {
        std::uint32_t samples = 0;
        BakeOptions options = kQuick;
        options.samples = 64;
        options.ray_budget = rays;
        bake_lightmap(sun.scene, sun.sources, options, [&](const BakeState& state) { samples = state.samples; });
        return samples;
    };
    EXPECT_EQ(taken(0), 1u);
    EXPECT_EQ(taken(BakeOptions{}.ray_budget), 64u);
    std::uint32_t before = 1;
    for (std::uint64_t rays = 1; rays < 1ull << 40; rays *= 2) {
        EXPECT_TRUE(taken(rays) == before || taken(rays) == 2 * before) << rays;
        before = taken(rays);
    }
}

TEST(lightmap_key, changes_with_whatever_the_light_depends_on)
{
    const LightCase& room = light_case_named("lit room");
    const std::uint64_t key = lightmap_key(room.scene, room.sources);
    EXPECT_EQ(lightmap_key(room.scene, room.sources), key);
    Scene moved = room.scene;
    moved.nodes[2].world_from_node[3][0] += 1e-9;
    EXPECT_NE(lightmap_key(moved, room.sources), key);
    Scene darker = room.scene;
    darker.materials[0].base_colour.r = 0.59f;
    EXPECT_NE(lightmap_key(darker, room.sources), key);
    LightSources brighter = room.sources;
    brighter.lights[0].intensity *= 1.001f;
    EXPECT_NE(lightmap_key(room.scene, brighter), key);
}

// The measures themselves, on broken input whose wrong value is known.

TEST(light_measure, a_lightmap_that_is_a_tenth_too_bright_has_a_tenth_of_error)
{
    const LightCase& sun = light_case_named("sun");
    LightSources brighter = sun.sources;
    brighter.lights[0].intensity *= 1.1f;
    const LightError error = light_error(bake_lightmap(sun.scene, brighter, kQuick), sun);
    EXPECT_NEAR(error.rms, 0.1, 5e-4);
    EXPECT_NEAR(error.worst, 0.1, 5e-4);
    EXPECT_NEAR(error.local_p95, 0.1, 5e-4);
    EXPECT_NEAR(error.bias, 0.1, 5e-4);
}

TEST(light_measure, an_error_in_a_dark_corner_is_small_beside_the_mean_and_large_beside_its_place)
{
    LightCase half = light_case_named("sun");
    const auto sun = half.reference;
    const auto is_dark = [](const glm::dvec3& place) { return place.x > 1.0; };
    half.reference = [=](const glm::dvec3& place, const glm::dvec3& normal) {
        return sun(place, normal) * (is_dark(place) ? 0.9 : 1.0);
    };
    const LightError error = light_error(bake_lightmap(half.scene, half.sources, kQuick), half);
    EXPECT_NEAR(error.worst, 0.1 / 0.975, 1e-3);
    EXPECT_NEAR(error.local_p95, 0.1 / 0.9, 1e-3);
    EXPECT_NEAR(error.bias, 0.025 / 0.975, 2e-3);
    half.reference = [=](const glm::dvec3& place, const glm::dvec3& normal) {
        return is_dark(place) ? std::numeric_limits<double>::quiet_NaN() : sun(place, normal);
    };
    EXPECT_LT(light_error(bake_lightmap(half.scene, half.sources, kQuick), half).rms, 1e-3) << "where nobody looks";
}

TEST(light_measure, one_lit_luxel_in_a_dark_room_is_one_leak)
{
    const DarkRoom room = dark_rooms().front();
    Lightmap lightmap = plan_lightmap(room.scene, 4.0, 1 << 20);
    EXPECT_EQ(count_leaks(lightmap, room).leaked, 0u);
    for (const ComparedPoint& p : compared_points(room.scene, 0, 4000.0)) {
        const glm::dvec3 at = p.place_world;
        if (p.normal_world.x < 0.5 || std::abs(at.y - 1.2) > 0.05 || std::abs(at.z) > 0.05) continue;
        lightmap.luxels[blended_luxels(lightmap, room.scene, p.point)[0].luxel] = {
            glm::packHalf1x16(0.002f), glm::packHalf1x16(0.002f), glm::packHalf1x16(0.002f), 0};
        break;
    }
    const LeakCount leaks = count_leaks(lightmap, room);
    EXPECT_EQ(leaks.leaked, 1u);
    EXPECT_NEAR(leaks.brightest_lux, 2.0, 0.01);
}

TEST(light_measure, a_room_without_its_roof_leaks)
{
    DarkRoom room = dark_rooms().front();
    room.scene.objects.pop_back();
    const Lightmap lightmap = bake_lightmap(room.scene, room.sources, {.luxels_per_m = 2.0, .samples = 8});
    const LeakCount leaks = count_leaks(lightmap, room);
    EXPECT_EQ(leaks.leaked, leaks.seen);
}

TEST(light_reference, a_polygon_that_fills_the_sky_gives_pi_times_its_luminance)
{
    const std::array<glm::dvec3, 4> sky{{{-1e6, 1, -1e6}, {1e6, 1, -1e6}, {1e6, 1, 1e6}, {-1e6, 1, 1e6}}};
    EXPECT_NEAR(polygon_illuminance(1.0, sky, {0, 0, 0}, {0, 1, 0}), std::numbers::pi, 1e-5);
}

TEST(light_reference, a_small_far_polygon_is_a_point)
{
    const std::array<glm::dvec3, 4> plate{{{1, 9, 1}, {1.01, 9, 1}, {1.01, 9, 1.01}, {1, 9, 1.01}}};
    const glm::dvec3 way(1.005, 9.0, 1.005);
    const double cosine = 9.0 / glm::length(way);
    EXPECT_NEAR(polygon_illuminance(1e6, plate, {0, 0, 0}, {0, 1, 0}),
                point_illuminance(1e6 * 1e-4 * cosine, way, {0, 0, 0}, {0, 1, 0}), 1e-3);
}
