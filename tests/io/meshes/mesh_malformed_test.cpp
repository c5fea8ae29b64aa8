#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/io/expect_error.hpp"
#include "tests/io/meshes/mesh_texts.hpp"

using namespace mesh_texts;

namespace {

hw::ErrorParts error_of_text(const std::string& text, const std::string& name)
{
    SCOPED_TRACE(name + ": " + text.substr(0, 200));
    return error_of([&] { import_text(text, name); });
}

/// The error of a text with one part changed.
hw::ErrorParts error_of_change(std::string text, const std::string& name, const std::string& old,
                               const std::string& fresh)
{
    const std::size_t place = text.find(old);
    EXPECT_NE(place, std::string::npos) << old;
    return error_of_text(text.replace(place, old.size(), fresh), name);
}

}  // namespace

TEST(mesh_malformed, counts_that_the_file_cannot_hold_are_refused_before_anything_is_reserved)
{
    for (const std::string count : {"4000000000", "99999999999999999999", "-1", "7000000", "x"}) {
        error_of_change(ply_text(), "a.ply", "face 6", "face " + count);
        error_of_change(ply_binary(false), "a.ply", "face 6", "face " + count);
        error_of_change(ply_binary(true), "a.ply", "vertex 8", "vertex " + count);
        error_of_change(off_text(), "a.off", "8 6 12", "8 " + count + " 12");
        error_of_change(off_text(), "a.off", "8 6 12", count + " 6 12");
    }
    EXPECT_EQ(error_of_change(ply_text(), "a.ply", "face 6", "face 4000000000").pointer, "line 11");
    EXPECT_EQ(error_of_change(off_text(), "a.off", "8 6 12", "8 600000 12").pointer, "line 2");
}

TEST(mesh_malformed, a_count_over_or_under_what_follows_is_refused)
{
    EXPECT_EQ(error_of_change(ply_text(), "a.ply", "face 6", "face 7").pointer, "face 6");
    error_of_change(ply_binary(false), "a.ply", "face 6", "face 7");
    error_of_change(off_text(), "a.off", "8 6 12", "8 7 12");
}

TEST(mesh_malformed, an_stl_whose_count_contradicts_its_size_is_refused)
{
    std::string stl = stl_binary();
    for (const char count : {0, 11, 13, -1}) {
        stl[80] = count;
        EXPECT_EQ(error_of_text(stl, "a.stl").pointer, "byte 80");
    }
    EXPECT_EQ(error_of_text(stl_binary() + "x", "a.stl").pointer, "byte 80");
    EXPECT_EQ(error_of_text("short", "a.stl").pointer, "byte 0");
}

TEST(mesh_malformed, polygons_of_millions_of_corners_are_refused)
{
    EXPECT_THAT(error_of_change(ply_text(), "a.ply", "4 0 3", "4000000000 0 3").what,
                testing::HasSubstr("4000000000 corners"));
    EXPECT_THAT(error_of_change(off_text(), "a.off", "4 0 3", "4000000000 0 3").what, testing::HasSubstr("corners"));
    error_of_change(ply_text(), "a.ply", "4 0 3", "-4 0 3");
    std::string ply = ply_binary(false);
    ply.replace(ply.find("end_header\n") + 11 + 8 * 15, 1, "\xff\xff\xff\xff");  // behind eight vertices
    ply.replace(ply.find("list uchar"), 10, "list uint");
    EXPECT_THAT(error_of_text(ply, "a.ply").what, testing::HasSubstr("4294967295 corners"));
    std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
    for (int i = 0; i < 5000; ++i) obj += " 1";
    EXPECT_EQ(error_of_text(obj, "a.obj").pointer, "line 4");
}

TEST(mesh_malformed, indices_out_of_range_are_refused)
{
    EXPECT_EQ(error_of_change(ply_text(), "a.ply", "4 0 3", "4 8 3").pointer, "face 0");
    EXPECT_EQ(error_of_change(ply_text(), "a.ply", "4 0 3", "4 -1 3").pointer, "face 0");
    EXPECT_EQ(error_of_change(off_text(), "a.off", "4 0 3", "4 8 3").pointer, "line 11");
    EXPECT_EQ(error_of_change(off_text(), "a.off", "4 0 3", "4 -1 3").pointer, "line 11");
    EXPECT_EQ(error_of_change(obj_text(), "a.obj", "f 1 4", "f 9 4").pointer, "line 17");
    for (const char* corner : {"0", "-9", "x", "1/0", "1/3", "1//2", "1/2/3/4x", "99999999999999999999"})
        error_of_change(obj_text(), "a.obj", "f 1 4", std::string("f ") + corner + " 4");
}

TEST(mesh_malformed, positions_that_are_not_finite_are_refused)
{
    for (const std::string number : {"nan", "inf", "-inf", "1e40", "1e16", "1e999", "zero", "1.0.0", "0x1p3"}) {
        error_of_change(ply_text(), "a.ply", "-1.000000", number);
        error_of_change(off_text(), "a.off", "-1.000000", number);
        error_of_change(obj_text(), "a.obj", "-1.000000", number);
        error_of_change(stl_text(), "a.stl", "-1.000000", number);
    }
    const std::string nan = bytes_of(std::bit_cast<float>(0x7fc00000u), false);
    std::string stl = stl_binary();
    EXPECT_EQ(error_of_text(stl.replace(84 + 12, 4, nan), "a.stl").pointer, "byte 84");
    std::string ply = ply_binary(false);
    EXPECT_EQ(error_of_text(ply.replace(ply.find("end_header\n") + 11, 4, nan), "a.ply").pointer, "vertex 0");
}

TEST(mesh_malformed, broken_headers_are_refused_with_their_line)
{
    EXPECT_EQ(error_of_text("", "a.ply").pointer, "line 0");
    EXPECT_EQ(error_of_text("ply\n", "a.ply").pointer, "line 1");
    EXPECT_EQ(error_of_change(ply_text(), "a.ply", "end_header", "end").pointer, "line 13");
    EXPECT_EQ(error_of_change(ply_text(), "a.ply", "ascii", "unheard_of").pointer, "line 2");
    EXPECT_EQ(error_of_change(ply_text(), "a.ply", "float y", "quad y").pointer, "line 6");
    EXPECT_EQ(error_of_change(ply_text(), "a.ply", "float y", "float x").pointer, "line 6");
    error_of_change(ply_text(), "a.ply", "float y", "int y");
    error_of_change(ply_text(), "a.ply", "float y", "float q");
    error_of_change(ply_text(), "a.ply", "vertex_indices", "corners");
    error_of_change(ply_text(), "a.ply", "list uchar", "list float");
    error_of_change(off_text(), "a.off", "COFF", "4OFF");
    error_of_change(off_text(), "a.off", "COFF", "OFF BINARY");
    error_of_text("", "a.off");
    error_of_text("", "a.stl");
}

TEST(mesh_malformed, files_without_faces_are_refused)
{
    for (const auto& [text, name] :
         {std::pair("v 0 0 0\n", "a.obj"), std::pair("", "a.obj"), std::pair("OFF\n1 0 0\n0 0 0\n", "a.off"),
          std::pair("solid a\nendsolid a\n", "a.stl"), std::pair("v 0 0 0\nf 1 1 1\n", "a.obj")})
        EXPECT_EQ(error_of_text(text, name).what, "there are no faces");
}

TEST(mesh_malformed, facets_of_other_than_three_corners_are_refused)
{
    error_of_change(stl_text(), "a.stl", "vertex", "corner");
    error_of_change(stl_text(), "a.stl", "endloop\n", "");
    error_of_text("solid a\nfacet\nouter loop\nvertex 0 0 0\n", "a.stl");
}

TEST(mesh_malformed, material_files_and_textures_outside_of_the_project_are_left_out)
{
    const TemporaryFolder folder;
    folder.write("secret.mtl", "newmtl Wood\nd 0.5\n");
    ASSERT_EQ(::mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
    const std::string secret = (folder.path() / "secret.mtl").string();
    const std::string face = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl Wood\nf 1 2 3\n";
    folder.write("project/bad.mtl", "newmtl Wood\nmap_Kd ../secret.mtl\nKd nan x\nd 7\n");
    for (const std::string& named : {std::string("../secret.mtl"), secret, std::string("../pipe"),
                                     std::string("bad.mtl"), std::string("."), std::string("a\0b", 3)}) {
        const auto file = folder.write("project/a.obj", "mtllib " + named + "\n" + face);
        const hw::Scene scene = hw::import_model(file, folder.path() / "project");
        EXPECT_EQ(scene.materials[0].alpha_mode, hw::AlphaMode::opaque) << named;
        EXPECT_TRUE(scene.images.empty());
    }
}
