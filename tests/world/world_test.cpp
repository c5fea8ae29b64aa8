#include <gtest/gtest.h>

#include "hatchway/world/level.hpp"
#include "hatchway/world/looks.hpp"

namespace {

hw::Scene two_columns_in_a_hall()
{
    hw::Scene scene;
    scene.nodes.resize(3);
    scene.nodes[0].path = "Hall";
    scene.nodes[1] = {.name = "Column_01", .path = "Hall/Column_01", .parent = 0};
    scene.nodes[2] = {.name = "Column_02", .path = "Hall/Column_02", .parent = 0};
    scene.materials.resize(1);
    scene.meshes.resize(1);
    scene.objects = {{.node = 1, .mesh = 0, .material = 0}, {.node = 2, .mesh = 0, .material = 0}};
    return scene;
}

}  // namespace

TEST(looks, the_last_rule_that_fits_wins)
{
    hw::Level level;
    level.assign = {{.nodes = "*", .style = "assumed"}, {.nodes = "Hall/Column_02", .style = "excavated"}};
    const auto looks = hw::resolve_looks(level, two_columns_in_a_hall(), "pen_and_ink");
    EXPECT_EQ(looks[0].style, "assumed");
    EXPECT_EQ(looks[1].style, "excavated");
}

TEST(looks, a_rule_reaches_the_children_of_the_node_that_it_names)
{
    hw::Level level;
    level.assign = {{.nodes = "Hall", .style = "assumed"}};
    EXPECT_EQ(hw::resolve_looks(level, two_columns_in_a_hall(), "photoreal")[1].style, "assumed");
}

TEST(looks, one_style_serves_brick_plank_and_tile_with_a_map_for_each)
{
    hw::Scene scene = two_columns_in_a_hall();
    scene.materials = {{.name = "Brick_Old"}, {.name = "Plank"}, {.name = "Roof_Tile"}, {.name = "Plaster"}};
    scene.objects.clear();
    for (int material = 0; material < 4; ++material)
        scene.objects.push_back({.node = 1, .mesh = 0, .material = material});
    hw::Level level;
    level.assign = {{.nodes = "*", .style = "drawn"},
                    {.materials = "Brick*", .maps = {{hw::MapKind::ink, "brick"}}},
                    {.materials = "Plank", .maps = {{hw::MapKind::ink, "plank"}, {hw::MapKind::hatch, "fine"}}},
                    {.materials = "*Tile", .maps = {{hw::MapKind::ink, "tile"}}}};
    const auto looks = hw::resolve_looks(level, scene, "photoreal");
    for (const hw::ObjectLook& look : looks) EXPECT_EQ(look.style, "drawn");
    EXPECT_EQ(looks[0].maps, (std::map<hw::MapKind, std::string>{{hw::MapKind::ink, "brick"}}));
    EXPECT_EQ(looks[1].maps,
              (std::map<hw::MapKind, std::string>{{hw::MapKind::ink, "plank"}, {hw::MapKind::hatch, "fine"}}));
    EXPECT_EQ(looks[2].maps, (std::map<hw::MapKind, std::string>{{hw::MapKind::ink, "tile"}}));
    EXPECT_TRUE(looks[3].maps.empty());
}

TEST(looks, tell_where_their_style_was_said)
{
    hw::Level level;
    level.file = "hall.level.json";
    level.certainty_styles = {{0.8, "excavated"}, {0.0, "assumed"}};
    level.assign = {{.nodes = "Hall/Column_01", .certainty = 0.3}};
    hw::Scene scene = two_columns_in_a_hall();
    scene.file = "hall.glb";
    scene.nodes[scene.objects[1].node].style = "found";
    const auto looks = hw::resolve_looks(level, scene, "photoreal");
    EXPECT_EQ(looks[0].style_pointer, "/certainty_styles/1/style");
    const std::string place = "style in the extras of " + scene.nodes[scene.objects[1].node].path;
    EXPECT_EQ(looks[1].style_pointer, "hall.glb: " + place);
    level.scene_file = level.file;
    EXPECT_EQ(hw::resolve_looks(level, scene, "photoreal")[1].style_pointer, place) << "a bare model";
}

TEST(looks, without_a_rule_the_certainty_table_decides)
{
    hw::Level level;
    level.certainty_styles = {{0.0, "assumed"}, {0.8, "excavated"}};
    level.assign = {{.nodes = "Hall/Column_01", .certainty = 0.3}};
    const auto looks = hw::resolve_looks(level, two_columns_in_a_hall(), "photoreal");
    EXPECT_EQ(looks[0].style, "assumed");
    EXPECT_EQ(looks[1].style, "excavated");
}
