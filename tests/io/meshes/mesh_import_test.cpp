#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <locale>
#include <set>

#include "hatchway/core/srgb.hpp"
#include "tests/io/meshes/mesh_texts.hpp"

using namespace mesh_texts;

namespace {

using Point = std::array<float, 3>;
using Triangle = std::array<Point, 3>;

Point point_of(const glm::vec3& v)
{
    return {v.x, v.y, v.z};
}

/// Triangles by position, each begun at its smallest corner.
std::multiset<Triangle> triangles_of(const hw::Scene& scene)
{
    std::multiset<Triangle> all;
    for (const hw::MeshData& mesh : scene.meshes)
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            Triangle triangle;
            for (std::size_t k = 0; k < 3; ++k) triangle[k] = point_of(mesh.positions[mesh.indices[i + k]]);
            std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
            all.insert(triangle);
        }
    return all;
}

/// The colour that a mesh has at a position.
glm::vec4 colour_at(const hw::MeshData& mesh, const glm::vec3& place)
{
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        if (mesh.positions[i] == place) return mesh.colours.at(i);
    ADD_FAILURE() << "no vertex there";
    return {};
}

void expect_colour(const glm::vec4& found, const glm::vec4& expected)
{
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(found[i], expected[i], 1e-5f) << i;
}

std::string with(std::string text, const std::string& old, const std::string& fresh)
{
    const std::size_t place = text.find(old);
    EXPECT_NE(place, std::string::npos) << old;
    return text.replace(place, old.size(), fresh);
}

std::string with_carriage_returns(const std::string& text)
{
    std::string result;
    for (const char c : text) result += c == '\n' ? std::string("\r\n") : std::string(1, c);
    return result;
}

}  // namespace

TEST(mesh_import, every_format_gives_the_same_cube)
{
    const std::multiset<Triangle> cube = triangles_of(import_text(off_text("OFF"), "cube.off"));
    EXPECT_EQ(cube.size(), 12u);
    EXPECT_EQ(triangles_of(import_text(ply_text(), "cube.ply")), cube);
    EXPECT_EQ(triangles_of(import_text(ply_binary(false), "cube.ply")), cube);
    EXPECT_EQ(triangles_of(import_text(ply_binary(true), "cube.ply")), cube);
    EXPECT_EQ(triangles_of(import_text(obj_text(), "cube.obj")), cube);
    EXPECT_EQ(triangles_of(import_text(stl_text(), "cube.stl")), cube);
    EXPECT_EQ(triangles_of(import_text(stl_binary(), "cube.STL")), cube);
    EXPECT_EQ(triangles_of(import_text(off_text("COFF"), "cube.off")), cube);
}

TEST(mesh_import, colours_of_vertices_are_srgb_in_the_file_and_linear_in_the_mesh)
{
    const std::pair<std::string, std::string> files[] = {{ply_text(), "a.ply"},
                                                         {ply_binary(false), "a.ply"},
                                                         {ply_binary(true), "a.ply"},
                                                         {obj_text(), "a.obj"},
                                                         {off_text(), "a.off"}};
    for (const auto& [text, name] : files) {
        const hw::Scene scene = import_text(text, name);
        ASSERT_EQ(scene.meshes.size(), 1u) << name;
        for (int i = 0; i < 8; ++i)
            for (int channel = 0; channel < 3; ++channel) {
                const glm::vec3 place(corner(i, 0), corner(i, 1), corner(i, 2));
                const float expected = hw::linear_from_srgb(static_cast<float>(colour(i, channel)) / 255.0f);
                EXPECT_NEAR(colour_at(scene.meshes[0], place)[channel], expected, 1e-5f) << name << ' ' << i;
            }
    }
    EXPECT_TRUE(import_text(off_text("OFF"), "a.off").meshes[0].colours.empty());
}

TEST(mesh_import, a_mesh_without_normals_is_smooth_and_breaks_at_creases)
{
    const hw::Scene cube = import_text(stl_text(), "cube.stl");
    EXPECT_FALSE(cube.meshes[0].has_own_normals);
    EXPECT_EQ(cube.meshes[0].positions.size(), 24u) << "four corners on each of six sides";
    const hw::Scene roof = import_text("OFF 4 2 0\n-1 0 0\n0 0.1 -1\n0 0.1 1\n1 0 0\n3 0 2 1\n3 1 2 3\n",
                                       "roof.off");  // folded by 11 degrees
    EXPECT_EQ(roof.meshes[0].positions.size(), 4u);
    EXPECT_NEAR(roof.meshes[0].normals[1].y, 1.0f, 1e-6f);
}

TEST(mesh_import, stated_normals_are_kept)
{
    const std::string off = "NOFF\n3 1 0\n0 0 0 0 0 2\n1 0 0 0 0 2\n0 1 0 0 2 0\n3 0 1 2\n";
    const hw::Scene scene = import_text(off, "a.off");
    EXPECT_TRUE(scene.meshes[0].has_own_normals);
    EXPECT_EQ(scene.meshes[0].normals[2], glm::vec3(0, 1, 0));
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0 3 0\nf 1//1 2//2 3//1\nf 1//2 3//2 2//2\n";
    const hw::Scene corners = import_text(obj, "a.obj");
    EXPECT_TRUE(corners.meshes[0].has_own_normals);
    EXPECT_EQ(corners.meshes[0].positions.size(), 5u) << "two vertices have two normals each";
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\nelement face 1\n"
        "property list uchar int vertex_index\nend_header\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 nan nan nan\n3 0 1 2\n";
    EXPECT_FALSE(import_text(ply, "a.ply").meshes[0].has_own_normals) << "one is no number";
    EXPECT_TRUE(import_text(with(ply, "nan nan nan", "0 0 -5"), "a.ply").meshes[0].has_own_normals);
}

TEST(mesh_import, faces_that_a_half_edge_mesh_refuses_are_kept)
{
    const std::string off =
        "OFF\n6 4 0\n0 0 0\n0 1 0\n1 0 0\n-1 0 0\n0 0 1\n0 0 -1\n3 0 1 2\n3 0 1 3\n3 0 1 4\n3 1 0 5\n";
    EXPECT_EQ(triangles_of(import_text(off, "fan.off")).size(), 4u);
}

TEST(mesh_import, a_concave_polygon_is_filled_and_not_its_hull)
{
    // An arrow: the notch at (0, 1) lies inside of the hull.
    const std::string off = "OFF\n4 1 0\n-2 0 0\n0 1 0\n2 0 0\n0 4 0\n4 0 1 2 3\n";
    const hw::Scene scene = import_text(off, "arrow.off");
    double area = 0.0;
    const hw::MeshData& mesh = scene.meshes[0];
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[i]];
        const glm::vec3 cross =
            glm::cross(mesh.positions[mesh.indices[i + 1]] - a, mesh.positions[mesh.indices[i + 2]] - a);
        EXPECT_GT(cross.z, 0.0f);
        area += 0.5 * cross.z;
    }
    EXPECT_NEAR(area, 6.0, 1e-6);
}

TEST(mesh_import, groups_and_materials_of_obj_become_objects_with_names)
{
    const std::string obj =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\no Tower\ng Roof\nusemtl Slate\nf 1 2 3\ng Wall\nusemtl Stone\nf 1 2 3\nusemtl "
        "Slate\n"
        "f 3 2 1\no Tower\ng Roof\nf 1 3 2\no Gate\nf 1 2 3\n";
    const hw::Scene scene = import_text(obj, "a.obj");
    std::vector<std::string> found;
    for (const hw::Object& object : scene.objects)
        found.push_back(scene.nodes[object.node].path + " in " + scene.materials[object.material].name + ": " +
                        std::to_string(scene.meshes[object.mesh].triangle_count()));
    const std::vector<std::string> expected{"Tower/Roof in Slate: 2", "Tower/Wall in Stone: 1",
                                            "Tower/Wall in Slate: 1", "Gate in Slate: 1"};
    EXPECT_EQ(found, expected);
    EXPECT_EQ(scene.materials.size(), 2u);
}

TEST(mesh_import, a_file_without_names_is_a_node_of_the_files_name)
{
    EXPECT_EQ(import_text(ply_text(), "find_17.ply").nodes[0].path, "find_17");
    EXPECT_EQ(import_text(stl_text(), "a.stl").nodes[0].path, "Cube");
}

TEST(mesh_import, obj_reads_negative_indices_comments_continued_lines_and_texture_coordinates)
{
    const std::string obj =
        "# v 9 9 9\nv 0 0 0 # here\nv 1 0 0\nv 0 1 0\nvt 0.25 0.25\nvt 1 0\nvt 0 1\nf -3/-3 \\\n -2/-2 -1/-1\n"
        "v 5 0 0\nv 6 0 0\nv 5 1 0\nf -3/1 -2/2 -1/3\n";
    const hw::Scene scene = import_text(with_carriage_returns(obj), "a.obj");
    const hw::MeshData& mesh = scene.meshes[0];
    ASSERT_EQ(mesh.triangle_count(), 2u);
    EXPECT_EQ(mesh.positions[mesh.indices[0]], glm::vec3(0, 0, 0));
    EXPECT_EQ(mesh.positions[mesh.indices[3]], glm::vec3(5, 0, 0));
    EXPECT_EQ(mesh.uv0[mesh.indices[0]], glm::vec2(0.25f, 0.75f)) << "v runs downwards";
}

TEST(mesh_import, materials_are_read_beside_the_file)
{
    const TemporaryFolder folder;
    folder.write("parts/a.mtl",
                 "newmtl Wood\r\nKd 0.5 0.25 1\r\nd 0.5\r\nmap_Kd -s 1 1 1 ..\\missing picture.png\r\n"
                 "newmtl Glass\nTr 0.75\n");
    const auto file = folder.write("parts/a.obj",
                                   "mtllib a.mtl\nmtllib missing.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                                   "usemtl Wood\nf 1 2 3\nusemtl Glass\nf 1 2 3\nusemtl None\nf 1 2 3\n");
    const hw::Scene scene = hw::import_model(file, folder.path());
    ASSERT_EQ(scene.materials.size(), 3u);
    expect_colour(scene.materials[0].base_colour, {hw::linear_from_srgb(0.5f), hw::linear_from_srgb(0.25f), 1, 0.5f});
    EXPECT_EQ(scene.materials[0].alpha_mode, hw::AlphaMode::blend);
    EXPECT_EQ(scene.materials[0].base_colour_texture.texture, hw::kNone) << "missing: told, not refused";
    EXPECT_EQ(scene.materials[1].base_colour.a, 0.25f);
    EXPECT_EQ(scene.materials[2].base_colour.a, 1.0f);
    EXPECT_TRUE(scene.materials[2].is_double_sided);
}

TEST(mesh_import, ply_lists_properties_and_elements_that_are_not_used_are_passed_over)
{
    const std::string ply =
        "ply\nformat ascii 1.0\nelement camera 1\nproperty list uchar float matrix\nelement vertex 3\n"
        "property double quality\nproperty double x\nproperty double y\nproperty double z\n"
        "property list ushort int neighbours\nelement face 1\nproperty uchar red\nproperty uchar green\n"
        "property uchar blue\nproperty list uint uint vertex_indices\nproperty list uchar float texcoord\nend_header\n"
        "3 1 2 3\n7 0 0 0 1 5\n7 1 0 0 0\n7 0 1 0 2 1 1\n255 0 0 3 0 1 2 6 0 0 0 0 0 0\n";
    const hw::Scene scene = import_text(ply, "a.ply");
    ASSERT_EQ(scene.meshes[0].triangle_count(), 1u);
    EXPECT_EQ(scene.meshes[0].positions[1], glm::vec3(1, 0, 0));
    expect_colour(scene.meshes[0].colours[0], {1, 0, 0, 1});  // the face's
}

TEST(mesh_import, off_reads_comments_counts_in_the_first_line_and_colours_of_faces)
{
    const std::string off =
        "# made by hand\nOFF 4 2 0 # counts\n\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2 255 0 0\n3 2 1 3 0.0 1.0 0.0\n";
    const hw::Scene scene = import_text(off, "a.off");
    ASSERT_EQ(scene.meshes[0].triangle_count(), 2u);
    EXPECT_EQ(scene.meshes[0].positions.size(), 6u) << "two vertices have two colours";
    expect_colour(scene.meshes[0].colours[0], {1, 0, 0, 1});
    expect_colour(scene.meshes[0].colours[scene.meshes[0].indices[3]], {0, 1, 0, 1});
}

TEST(mesh_import, an_stl_solid_called_outer_is_no_facet_and_each_solid_is_a_node)
{
    const std::string text = with(stl_text(), "solid Cube", "solid outer loop") + stl_text();
    const hw::Scene scene = import_text(text, "a.stl");
    EXPECT_EQ(triangles_of(scene).size(), 24u);
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(scene.nodes[1].path, "Cube");
    EXPECT_EQ(import_text(with(stl_text(), "solid Cube", "solids"), "a.stl").nodes[0].path, "a");
}

TEST(mesh_import, numbers_have_points_whatever_the_locale_says)
{
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
    const auto half = [](std::string text) { return with(std::move(text), "1.000000", "0.5"); };
    for (const auto& [text, name] : {std::pair(ply_text(), "a.ply"), std::pair(obj_text(), "a.obj"),
                                     std::pair(stl_text(), "a.stl"), std::pair(off_text(), "a.off")}) {
        const hw::Scene scene = import_text(half(text), name);
        const auto is_half = [](const glm::vec3& v) { return v.x == 0.5f || v.x == -0.5f; };
        EXPECT_TRUE(std::ranges::any_of(scene.meshes[0].positions, is_half)) << name;
    }
    std::locale::global(before);
}

TEST(mesh_import, a_file_is_what_its_first_bytes_say)
{
    EXPECT_EQ(triangles_of(import_text(ply_binary(false), "wrong.obj")).size(), 12u);
    EXPECT_EQ(triangles_of(import_text(off_text(), "wrong.stl")).size(), 12u);
}
