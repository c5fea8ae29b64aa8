#include "hatchway/io/compiled/portal_file.hpp"

#include <gtest/gtest.h>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

constexpr const char* kThreeLeaves =
    "PRT1\n3\n2\n4 0 1 (0 0 0 ) (0 1 0 ) (0 1 1 ) (0 0 1 )\n4 1 2 (2 0 0 ) (2 1 0 ) (2 1 1 ) (2 0 1 )\n";

TEST(portal_file, reads_both_directions_of_each_portal)
{
    const PortalFile file = parse_portals(kThreeLeaves, "t.prt");
    EXPECT_EQ(file.graph.leaf_count, 3);
    ASSERT_EQ(file.graph.portals.size(), 4u);
    EXPECT_EQ(file.graph.portals[0].from_leaf, 0);
    EXPECT_DOUBLE_EQ(file.graph.portals[0].normal.x, 1.0);  // from leaf 0 to leaf 1
    EXPECT_DOUBLE_EQ(file.graph.portals[1].normal.x, -1.0);
    EXPECT_TRUE(build_pvs(file.graph, {}).rows.sees(0, 2));
}

TEST(portal_file, clusters_hold_leaves)
{
    const PortalFile file = parse_portals("PRT2\n3\n2\n1\n3 0 1 (0 0 0) (0 1 0) (0 1 1)\n0 -1\n1 2 -1\n", "t.prt");
    EXPECT_EQ(file.graph.leaf_count, 2);
    EXPECT_EQ(file.cluster_of_leaf, (std::vector<int>{0, 1, 1}));
}

TEST(portal_file, what_is_written_reads_back)
{
    const PortalFile file = parse_portals(kThreeLeaves, "t.prt");
    const PortalFile again = parse_portals(portals_text(file.graph), "t.prt");
    EXPECT_EQ(again.portals_in_file, 2);
    EXPECT_EQ(again.graph.leaf_count, 3);
}

TEST(portal_file, a_portal_without_area_is_left_out)
{
    const PortalFile file = parse_portals("PRT1\n2\n1\n3 0 1 (0 0 0) (0 1 0) (0 2 0)\n", "t.prt");
    EXPECT_TRUE(file.graph.portals.empty());
    EXPECT_EQ(file.portals_without_area, 1);
}

TEST(portal_file, what_follows_the_last_portal_a_portal_to_its_own_leaf_and_one_of_one_point_are_refused)
{
    const std::pair<const char*, const char*> cases[] = {
        {"PRT1\n2\n1\n3 0 1 (0 0 0) (0 1 0) (0 1 1)\n7\n", "found \"7\""},
        {"PRT1\n2\n1\n3 1 1 (0 0 0) (0 1 0) (0 1 1)\n", "the portal leads from leaf 1 to itself"},
        {"PRT1\n2\n1\n3 0 1 (5 0 0) (5 0 0) (5 0 0)\n", "all corners of the portal are one point"}};
    for (const auto& [text, what] : cases) {
        try {
            parse_portals(text, "t.prt");
            ADD_FAILURE() << text;
        } catch (const Error& error) {
            EXPECT_EQ(error.parts().what, what);
            EXPECT_TRUE(error.parts().pointer.starts_with("line ")) << error.what();
        }
    }
}

TEST(portal_file, bad_text_is_refused_with_its_line)
{
    for (const char* text :
         {"", "PRT3\n1\n0\n", "PRT1\n-1\n0\n", "PRT1\n99999999999\n0\n", "PRT1\n2\n1\n",
          "PRT1\n2\n1\n3 0 2 (0 0 0) (0 1 0) (0 1 1)\n", "PRT1\n2\n1\n2 0 1 (0 0 0) (0 1 0)\n",
          "PRT1\n2\n1\n3 0 1 (0 0 nan) (0 1 0) (0 1 1)\n", "PRT1\n2\n1\n3 0 1 (0 0 1e300) (0 1 0) (0 1 1)\n",
          "PRT1\n2\n1\n3 0 1 (0 0 x) (0 1 0) (0 1 1)\n", "PRT1\n2\n1\n3 0 1 (0 0 0) (0 1 0) (0 1 1)\nmore\n",
          "PRT1\n2\n1\n3 1 1 (0 0 0) (0 1 0) (0 1 1)\n", "PRT1\n2\n1\n3 0 1 (5 0 0) (5 0 0) (5 0 0)\n"}) {
        try {
            parse_portals(text, "t.prt");
            FAIL() << text;
        } catch (const Error& error) {
            EXPECT_EQ(error.parts().file, "t.prt");
            EXPECT_NE(error.parts().pointer.find("line"), std::string::npos);
        }
    }
}

}  // namespace
}  // namespace hw
