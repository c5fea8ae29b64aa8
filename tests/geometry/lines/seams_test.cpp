#include "hatchway/geometry/lines/seams.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <span>

#include "hatchway/geometry/lines/cross_section.hpp"
#include "hatchway/geometry/lines/visible_lines.hpp"
#include "tests/geometry/test_meshes.hpp"

namespace {

using namespace hw::test;

constexpr double kQuarter = 1.5707963267948966;

glm::dmat4 shift(double x, double y, double z)
{
    return glm::translate(glm::dmat4(1.0), glm::dvec3(x, y, z));
}

hw::Surface floor_tile()
{
    return hw::build_surface(sheet(1, [](float, float) { return 0.0f; }), {.is_solid = false});
}

/// Line length of one object that its seams hide, world space of unscaled objects.
double hidden_length(const hw::Surface& surface, const hw::Seams& seams)
{
    const auto length = [&](std::uint32_t edge) {
        const auto [a, b] = hw::edge_vertices(surface, edge);
        return glm::distance(surface.positions[a], surface.positions[b]);
    };
    double sum = 0.0;
    for (const std::uint32_t edge : seams.hidden) sum += length(edge);
    for (const std::uint32_t edge : seams.partly_hidden) sum += length(edge);
    for (const hw::KeptPiece& piece : seams.kept) sum -= glm::distance(piece.ends[0], piece.ends[1]);
    return sum;
}

}  // namespace

TEST(seams, two_coplanar_tiles_side_by_side_lose_their_common_border)
{
    const hw::Surface tile = floor_tile();
    const std::vector<hw::SeamObject> objects{{&tile, shift(0, 0, 0)}, {&tile, shift(1, 0, 0)}};
    const auto seams = hw::find_seams(objects);
    ASSERT_EQ(seams[0].hidden.size(), 1u);
    ASSERT_EQ(seams[1].hidden.size(), 1u);
    for (const std::uint32_t end : hw::edge_vertices(tile, seams[0].hidden[0])) EXPECT_EQ(tile.positions[end].x, 1.0f);
    for (const std::uint32_t end : hw::edge_vertices(tile, seams[1].hidden[0])) EXPECT_EQ(tile.positions[end].x, 0.0f);
}

TEST(seams, tiles_of_different_styles_keep_their_borders)
{
    const hw::Surface tile = floor_tile();
    const std::vector<hw::SeamObject> objects{{&tile, shift(0, 0, 0), 0}, {&tile, shift(1, 0, 0), 1}};
    EXPECT_TRUE(hw::find_seams(objects)[0].hidden.empty());
}

TEST(seams, tiles_with_a_step_a_fold_or_a_gap_keep_their_borders)
{
    const hw::Surface tile = floor_tile();
    for (const glm::dmat4& second :
         {shift(1, 0.01, 0), glm::rotate(shift(1, 0, 0), 0.3, glm::dvec3(0, 0, 1)), shift(1.01, 0, 0)}) {
        const std::vector<hw::SeamObject> objects{{&tile, shift(0, 0, 0)}, {&tile, second}};
        EXPECT_TRUE(hw::find_seams(objects)[0].hidden.empty());
    }
}

TEST(seams, a_tile_over_the_same_place_keeps_its_borders)
{
    const hw::Surface tile = floor_tile();
    const std::vector<hw::SeamObject> objects{{&tile, shift(0, 0, 0)}, {&tile, shift(0, 0, 0)}};
    EXPECT_TRUE(hw::find_seams(objects)[0].hidden.empty());
}

TEST(seams, a_wall_under_sheets_with_two_sides_keeps_the_line_that_is_seen_from_below)
{
    const hw::Surface tile = floor_tile();
    const glm::dmat4 hanging = glm::rotate(shift(1, 0, 0), -kQuarter, glm::dvec3(0, 0, 1));
    std::vector<hw::SeamObject> objects{{&tile, shift(0, 0, 0)}, {&tile, shift(1, 0, 0)}, {&tile, hanging}};
    const auto of_one_side = hw::find_seams(objects);
    EXPECT_EQ(of_one_side[0].hidden.size(), 1u) << "from above nothing ends, and below is the inside";
    EXPECT_EQ(of_one_side[1].hidden.size(), 1u);
    for (hw::SeamObject& object : objects) object.is_double_sided = true;
    for (const hw::Seams& seams : hw::find_seams(objects)) EXPECT_TRUE(seams.hidden.empty());
    objects.pop_back();
    for (const hw::Seams& seams : hw::find_seams(objects)) EXPECT_EQ(seams.hidden.size(), 1u) << "no wall, no line";
}

TEST(seams, rounding_of_the_placing_matrices_does_not_matter)
{
    const hw::Surface tile = floor_tile();
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.4321, glm::dvec3(0.1, 0.9, 0.3));
    const std::vector<hw::SeamObject> objects{{&tile, shift(100, 3, 7) * turn},
                                              {&tile, shift(100, 3, 7) * turn * shift(1.00001, 0.00001, 0)}};
    EXPECT_EQ(hw::find_seams(objects)[0].hidden.size(), 1u);
}

TEST(seams, a_long_border_is_hidden_by_two_short_ones)
{
    const hw::Surface tile = floor_tile();
    const glm::dmat4 twice = glm::scale(glm::dmat4(1.0), glm::dvec3(2.0));
    const std::vector<hw::SeamObject> objects{{&tile, twice}, {&tile, shift(2, 0, 0)}, {&tile, shift(2, 0, 1)}};
    const auto seams = hw::find_seams(objects);
    EXPECT_EQ(seams[0].hidden.size(), 1u);
    EXPECT_TRUE(seams[0].kept.empty());
    EXPECT_EQ(seams[1].hidden.size(), 2u);
}

TEST(seams, of_a_border_covered_in_part_the_rest_stays)
{
    const hw::Surface tile = floor_tile();
    const std::vector<hw::SeamObject> objects{{&tile, shift(0, 0, 0)}, {&tile, shift(1, 0, 0.25)}};
    const auto seams = hw::find_seams(objects);
    ASSERT_EQ(seams[0].partly_hidden.size(), 1u);
    ASSERT_EQ(seams[0].kept.size(), 1u);
    EXPECT_NEAR(std::abs(seams[0].kept[0].ends[0].z - seams[0].kept[0].ends[1].z), 0.25, 1e-6);
    EXPECT_NEAR(hidden_length(tile, seams[0]), 0.75, 1e-6);
    EXPECT_NEAR(hidden_length(tile, seams[1]), 0.75, 1e-6);
}

TEST(seams, what_stays_of_a_culled_border_is_seen_from_its_front_alone)
{
    const hw::Surface tile = floor_tile();
    const std::vector<hw::SeamObject> objects{{&tile, shift(0, 0, 0)}, {&tile, shift(1, 0, 0.25)}};
    const auto seams = hw::find_seams(objects);
    const auto kept_pieces = [&](double eye_y) {
        std::vector<hw::LineObject> drawn;
        for (std::size_t i = 0; i < 2; ++i)
            drawn.push_back({.surface = objects[i].surface,
                             .world_from_object = objects[i].world_from_object,
                             .seams = &seams[i],
                             .is_culled = true});
        std::size_t kept = 0;
        for (const hw::VisibleLine& line :
             hw::find_visible_lines(drawn, {.eye_world = {1, eye_y, 3}, .target_world = {1, 0, 0.5}}))
            for (const hw::LineSource& source : line.sources) kept += source.kind() == hw::LineSource::Kind::kept;
        return kept;
    };
    EXPECT_EQ(kept_pieces(2.0), 2u);
    EXPECT_EQ(kept_pieces(-2.0), 0u);
}

TEST(seams, boxes_side_by_side_lose_the_flat_lines_and_keep_the_corners)
{
    const hw::Surface block = hw::build_surface(box({0, 0, 0}, {1, 1, 1}));
    const std::vector<hw::SeamObject> objects{{&block, shift(0, 0, 0)}, {&block, shift(1, 0, 0)}};
    const auto seams = hw::find_seams(objects);
    EXPECT_EQ(seams[0].hidden.size(), 4u);
    EXPECT_EQ(seams[1].hidden.size(), 4u);
}

TEST(seams, mirrored_boxes_are_boxes)
{
    const hw::Surface block = hw::build_surface(box({0, 0, 0}, {1, 1, 1}));
    const glm::dmat4 mirror = glm::scale(shift(2, 0, 0), glm::dvec3(-1, 1, 1));
    const std::vector<hw::SeamObject> objects{{&block, shift(0, 0, 0)}, {&block, mirror}};
    EXPECT_EQ(hw::find_seams(objects)[0].hidden.size(), 4u);
}

TEST(seams, a_wall_on_a_floor_keeps_the_corner_between_them)
{
    const hw::Surface tile = floor_tile();
    const glm::dmat4 upright = glm::rotate(shift(1, 0, 0), kQuarter, glm::dvec3(0, 0, 1));
    const std::vector<hw::SeamObject> objects{{&tile, shift(0, 0, 0)}, {&tile, shift(1, 0, 0)}, {&tile, upright}};
    const auto seams = hw::find_seams(objects);
    EXPECT_TRUE(seams[2].hidden.empty());
    EXPECT_TRUE(seams[0].hidden.empty());
}

TEST(seams, a_block_that_lies_into_another_loses_the_lines_inside_of_their_common_top)
{
    const hw::Surface block = hw::build_surface(box({0, 0, 0}, {1, 1, 1}));
    // As high as the first, half as wide, and half inside of it: three lines of its top are cut to what is outside.
    const glm::dmat4 post = glm::scale(shift(0.75, 0, 0.25), glm::dvec3(0.5, 1.0, 0.5));
    const std::vector<hw::SeamObject> objects{{&block, shift(0, 0, 0)}, {&block, post}};
    const auto seams = hw::find_seams(objects);
    EXPECT_EQ(seams[1].hidden.size() + seams[1].partly_hidden.size(), 6u) << "three at the top, three at the bottom";
    EXPECT_EQ(seams[1].hidden.size(), 2u) << "the one across lies inside whole";
    EXPECT_EQ(seams[1].kept.size(), 4u);
    // The first block's own corner is cut where the post's top goes on: at the top and at the bottom.
    EXPECT_EQ(seams[0].partly_hidden.size(), 2u);
    EXPECT_NEAR(hidden_length(block, seams[0]), 1.0, 2e-3);
    const std::vector<hw::SeamObject> lower{{&block, shift(0, 0, 0)}, {&block, shift(0, -0.1, 0) * post}};
    EXPECT_TRUE(hw::find_seams(lower)[1].hidden.empty()) << "a tenth lower is a step";
    std::vector<hw::SeamObject> two_styles = objects;
    two_styles[1].style = 7;
    EXPECT_TRUE(hw::find_seams(two_styles)[1].hidden.empty());
}

TEST(seams, a_box_standing_inside_of_a_floor_tile_keeps_its_foot)
{
    const hw::Surface tile = floor_tile();
    const hw::Surface block = hw::build_surface(box({0.25, 0, 0.25}, {0.75, 1, 0.75}));
    const std::vector<hw::SeamObject> objects{{&tile, shift(0, 0, 0)}, {&block, shift(0, 0, 0)}};
    const auto seams = hw::find_seams(objects);
    EXPECT_TRUE(seams[1].hidden.empty()) << "its walls stand before the floor's plane";
    EXPECT_TRUE(seams[0].hidden.empty());
}

TEST(seams, a_box_is_the_same_alone)
{
    const hw::Surface block = hw::build_surface(box({0, 0, 0}, {1, 1, 1}));
    const std::vector<hw::SeamObject> objects{{&block, shift(0, 0, 0)}};
    const auto seams = hw::find_seams(objects);
    EXPECT_TRUE(seams[0].hidden.empty());
    EXPECT_TRUE(seams[0].partly_hidden.empty());
}

TEST(cross_section, a_sheet_hanging_from_a_ceiling_is_seen_but_the_gap_between_touching_solids_is_not)
{
    // Angles: 0 right, a quarter up. The ceiling looks down, the floor up; the two sheets hang down and look apart.
    const hw::FaceAtLine sheet_right{-kQuarter, true, false}, sheet_left{-kQuarter, false, true};
    const std::array<hw::FaceAtLine, 4> ceiling{
        {{0.0, false, true}, {2 * kQuarter, true, false}, sheet_right, sheet_left}};
    EXPECT_FALSE(hw::is_flat_across(ceiling, 0.01));
    const std::array<hw::FaceAtLine, 4> solids{
        {{0.0, true, false}, {2 * kQuarter, false, true}, sheet_right, sheet_left}};
    EXPECT_TRUE(hw::is_flat_across(solids, 0.01));
}

TEST(cross_section, both_sides_of_a_double_sided_sheet_count)
{
    const std::array<hw::FaceAtLine, 2> flat{{{0.0, true, true}, {2 * kQuarter, true, true}}};
    EXPECT_TRUE(hw::is_flat_across(flat, 0.01));
    const std::array<hw::FaceAtLine, 2> bent{{{0.0, true, true}, {1.8 * kQuarter, true, true}}};
    EXPECT_FALSE(hw::is_flat_across(bent, 0.01));
    EXPECT_FALSE(hw::is_flat_across(std::span(flat).first(1), 0.01));
}

TEST(cross_section, a_wall_inside_of_an_open_shell_makes_no_line_on_its_outside)
{
    // A straight front, and behind it one side of a partition: who looks at the front sees neither.
    const std::array<hw::FaceAtLine, 3> front{
        {{0.0, true, false}, {2 * kQuarter, false, true}, {-kQuarter, false, true}}};
    EXPECT_TRUE(hw::is_flat_across(front, 0.01));
    // The same wall in front of it is seen.
    const std::array<hw::FaceAtLine, 3> fence{
        {{0.0, true, false}, {2 * kQuarter, false, true}, {kQuarter, false, true}}};
    EXPECT_FALSE(hw::is_flat_across(fence, 0.01));
}

namespace {

/// Pixels of visible lines on the edge from the origin to +z, of a fan of faces around it at these angles whose winding
/// the bits of `winding` turn over.
double line_px_on_edge(std::span<const float> angles, unsigned winding, bool is_culled)
{
    hw::MeshData mesh = mesh_of({{0, 0, 0}, {0, 0, 1}}, {});
    for (const float angle : angles) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back({std::cos(angle), std::sin(angle), 0.0f});
        mesh.positions.push_back({std::cos(angle), std::sin(angle), 1.0f});
        std::vector<std::uint32_t> two{0, 1, first + 1, 0, first + 1, first};
        if (winding & 1) two = {0, first + 1, 1, 0, first, first + 1};
        winding >>= 1;
        mesh.indices.insert(mesh.indices.end(), two.begin(), two.end());
    }
    const hw::Surface surface = hw::build_surface(mesh, {.is_solid = false});
    const std::vector<hw::SeamObject> together{{.surface = &surface, .is_double_sided = !is_culled}};
    const std::vector<hw::Seams> seams = hw::find_seams(together);
    const std::vector<hw::LineObject> objects{{.surface = &surface, .seams = &seams[0], .is_culled = is_culled}};
    const hw::LineCamera camera{.eye_world = {1.0, 5.0, 2.5}, .target_world = {0, 0, 0.5}};
    double sum = 0.0;
    for (const hw::VisibleLine& line : hw::find_visible_lines(objects, camera))
        for (std::size_t i = 0; i < line.sources.size(); ++i) {
            if (!line.sources[i].is_edge()) continue;
            const auto [a, b] = hw::edge_vertices(surface, line.sources[i].index());
            const auto is_on = [&](std::uint32_t p) { return glm::vec2(surface.positions[p]) == glm::vec2(0.0f); };
            if (is_on(a) && is_on(b))
                sum += glm::distance(line.points_px[i], line.points_px[(i + 1) % line.points_px.size()]);
        }
    return sum;
}

}  // namespace

TEST(complex_edges, of_three_to_six_two_sided_faces_are_drawn_however_the_faces_wind)
{
    const std::vector<std::vector<float>> fans{{0.0f, 3.1415927f, 1.5707964f},
                                               {0.0f, 3.1415927f, 0.8f},
                                               {0.0f, 3.1415927f, 1.5707964f, -1.5707964f},
                                               {0.0f, 1.2f, 2.4f, 3.6f, 4.8f},
                                               {0.1f, 1.1f, 2.1f, 3.1f, 4.1f, 5.1f}};
    for (const std::vector<float>& fan : fans)
        for (unsigned winding = 0; winding < 1u << fan.size(); ++winding)
            EXPECT_GT(line_px_on_edge(fan, winding, false), 50.0) << fan.size() << " faces, winding " << winding;
}

TEST(complex_edges, of_culled_faces_are_drawn_wherever_one_of_them_is_seen_from_the_front)
{
    const std::vector<float> fan{0.0f, 3.1415927f, 1.5707964f};
    for (unsigned winding = 0; winding < 8; ++winding) {
        const bool left_is_seen = (winding & 2) != 0, right_is_seen = (winding & 1) == 0;
        if (!left_is_seen && !right_is_seen) continue;
        // Of a wall that runs straight on, the third face is culled.
        const bool is_flat = left_is_seen && right_is_seen && (winding & 4) == 0;
        const double length_px = line_px_on_edge(fan, winding, true);
        EXPECT_TRUE(is_flat ? length_px == 0.0 : length_px > 50.0) << "winding " << winding << ": " << length_px;
    }
}
