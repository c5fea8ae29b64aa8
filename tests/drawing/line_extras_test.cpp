#include "hatchway/drawing/line_extras.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace hw::test {
namespace {

const glm::dmat4 kHere(1.0);

glm::dmat4 shift(double x, double y, double z)
{
    return glm::translate(kHere, glm::dvec3(x, y, z));
}

/// Two triangles from (0, 0, 0) to (1, 0, 1), looking up.
MeshData tile()
{
    MeshData mesh;
    mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}};
    mesh.normals.assign(4, glm::vec3(0, 1, 0));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

Scene scene_of_tiles(const std::vector<glm::dmat4>& places, bool is_double_sided)
{
    Scene scene;
    scene.meshes.push_back(tile());
    scene.materials.emplace_back();
    scene.materials[0].is_double_sided = is_double_sided;
    for (const glm::dmat4& place : places) {
        Node node;
        node.local = node.world_from_node = place;
        Object object;
        object.node = static_cast<int>(scene.nodes.size());
        object.mesh = 0;
        object.material = 0;
        object.bounds_world = transformed({.min = glm::dvec3(0.0), .max = {1, 0, 1}}, place);
        scene.nodes.push_back(node);
        scene.objects.push_back(object);
    }
    return scene;
}

EdgeDemand demand(bool has_intersections = false)
{
    EdgeDemand result{.crease_rad = {}, .has_intersections = has_intersections, .style_group = 1};
    result.crease_rad.push_back(0.7f);
    return result;
}

}  // namespace

TEST(line_extras, a_groove_of_a_small_thing_keeps_its_edges)
{
    // Of a chip of 4 cm: 0.05 mm wide. In a scene of 40 m such a gap is how a kit was placed.
    const auto hidden = [](double scale) {
        const double wide = 5e-5;
        Scene scene = scene_of_tiles(
            {glm::scale(kHere, glm::dvec3(scale)), glm::scale(shift(scale + wide, 0, 0), glm::dvec3(scale))}, false);
        for (const Object& object : scene.objects) scene.bounds_world.add(object.bounds_world);
        SceneSurfaces surfaces(scene);
        const std::vector<EdgeDemand> demands(2, demand());
        const LineExtras extras = find_line_extras(scene, demands, surfaces);
        return extras.objects[0].seams.hidden.size() + extras.objects[1].seams.hidden.size();
    };
    EXPECT_EQ(hidden(0.02), 0u);
    EXPECT_EQ(hidden(20.0), 2u);
}

TEST(line_extras, sheets_with_two_sides_keep_a_line_that_is_seen_from_below)
{
    const glm::dmat4 hanging = glm::rotate(shift(1, 0, 0), -0.5 * M_PI, glm::dvec3(0, 0, 1));
    for (const bool is_double_sided : {false, true}) {
        const Scene scene = scene_of_tiles({shift(0, 0, 0), shift(1, 0, 0), hanging}, is_double_sided);
        SceneSurfaces surfaces(scene);
        const LineExtras extras = find_line_extras(scene, std::vector<EdgeDemand>(3, demand()), surfaces);
        EXPECT_EQ(extras.objects[0].seams.hidden.size(), is_double_sided ? 0u : 1u);
    }
}

TEST(line_extras, a_drawn_object_has_a_line_where_it_goes_through_one_that_is_not_drawn)
{
    const glm::dmat4 upright = glm::rotate(shift(0.5, -0.5, 0.1), 0.5 * M_PI, glm::dvec3(0, 0, 1));
    const Scene scene = scene_of_tiles({shift(0, 0, 0), upright, shift(5, 0, 0)}, false);
    for (const ObjectId drawn : {0u, 1u}) {
        std::vector<EdgeDemand> demands(3);
        demands[drawn] = demand(true);
        SceneSurfaces surfaces(scene);
        const LineExtras extras = find_line_extras(scene, demands, surfaces);
        ASSERT_FALSE(extras.intersections.empty());
        EXPECT_EQ(extras.intersections[0].objects, (std::array<std::uint32_t, 2>{0u, 1u}));
        EXPECT_EQ(extras.objects[drawn].intersections.size(), extras.intersections.size());
        EXPECT_TRUE(extras.objects[1 - drawn].is_empty());
        for (const ObjectIntersection& piece : extras.objects[drawn].intersections)
            for (const glm::vec3& end : piece.ends) {
                const glm::dvec4 world = scene.world_from_object(drawn) * glm::dvec4(glm::dvec3(end), 1.0);
                EXPECT_NEAR(world.x, 0.5, 1e-6) << "where the upright one stands";
                EXPECT_NEAR(world.y, 0.0, 1e-6);
            }
    }
    std::vector<EdgeDemand> none(3, demand(false));
    SceneSurfaces surfaces(scene);
    EXPECT_TRUE(find_line_extras(scene, none, surfaces).intersections.empty());
}

TEST(line_extras, a_meeting_knows_where_its_one_sided_faces_look_in_the_space_of_its_object)
{
    const glm::dmat4 upright =
        glm::scale(glm::rotate(shift(0.5, -0.5, 0.1), 0.5 * M_PI, glm::dvec3(0, 0, 1)), glm::dvec3(-1, 2, 0.5));
    for (const bool is_double_sided : {false, true}) {
        const Scene scene =
            scene_of_tiles({shift(0, 0, 0), glm::translate(upright, glm::dvec3(-1, 0, 0))}, is_double_sided);
        SceneSurfaces surfaces(scene);
        const LineExtras extras = find_line_extras(scene, std::vector<EdgeDemand>(2, demand(true)), surfaces);
        ASSERT_FALSE(extras.objects[0].intersections.empty());
        const auto& [own, other] = extras.objects[0].intersections[0].culled_normals;
        const glm::dvec3 place(0.5, 0.0, 0.5);  // of the other, and what it sees of points beside it
        for (const double x : {-3.0, 3.0}) {
            const glm::dmat4 to_other = glm::inverse(scene.world_from_object(1));
            const glm::dvec3 seen = glm::dvec3(to_other * glm::dvec4(place + glm::dvec3(x, 0, 0), 1.0));
            const double side = is_double_sided ? 0.0 : seen.y - glm::dvec3(to_other * glm::dvec4(place, 1.0)).y;
            const Surface& surface = surfaces.of(1);
            const auto& [a, b, c] = surface.faces[0];
            const auto& at = surface.positions;
            const double up = glm::cross(at[b] - at[a], at[c] - at[a]).y;
            EXPECT_EQ(other.x * x > 0.0, side * up > 0.0) << x;
        }
        EXPECT_NEAR(glm::length(other), is_double_sided ? 0.0f : 1.0f, 1e-6f);
        EXPECT_NEAR(std::abs(own.y), is_double_sided ? 0.0f : 1.0f, 1e-6f);
    }
}

TEST(edge_demand, is_of_both_styles_of_an_object)
{
    std::vector<Needs> needs(3);
    needs[0].edges = EdgeNeed{.crease_rad = 0.7f};
    needs[1].edges = EdgeNeed{.crease_rad = 0.2f, .intersections = true};
    const std::vector<StyledObject> objects{{.style = 0, .over = 1}, {.style = 0, .over = 0}, {.style = 2}};
    const std::vector<EdgeDemand> demands = edge_demands(objects, needs);
    EXPECT_EQ(demands[0].crease_rad, (std::vector<float>{0.2f, 0.7f}));
    EXPECT_TRUE(demands[0].has_intersections);
    EXPECT_EQ(demands[1].crease_rad, std::vector<float>{0.7f});
    EXPECT_FALSE(demands[2].is_any());
    EXPECT_NE(demands[0].style_group, demands[1].style_group);
}

}  // namespace hw::test
