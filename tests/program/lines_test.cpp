#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/program/run_program.hpp"

namespace hw::test {
namespace {

using nlohmann::json;

const std::string kPrism = (kContent / "models" / "prism.glb").string();
const std::string kHall = (kContent / "levels" / "hall.level.json").string();

}  // namespace

TEST(lines, of_the_prism_are_drawn_by_class_and_told_as_json)
{
    const TemporaryFolder folder;
    const auto result =
        run_program({"lines", kPrism, "--eye", "3,2,7", "--target", "0,0.5,0", "--size", "400x300", "--hidden",
                     "dashed", "--crease-deg", "60", "--out", folder / "prism.svg", "--json", folder / "prism.json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json found = json::parse(bytes_of(folder / "prism.json"));
    EXPECT_EQ(found["width"], 400);
    EXPECT_EQ(found["height"], 300);
    EXPECT_EQ(found["mode"], "all");
    EXPECT_GT(found["prepare_ms"], 0.0);
    EXPECT_GT(found["find_ms"], 0.0);
    EXPECT_THAT(result.out, testing::MatchesRegex("prepared in [0-9.]+ ms\n.* lines in [0-9.]+ ms\n"));
    std::set<std::string> classes;
    bool has_hidden = false;
    for (const json& line : found["lines"]) {
        classes.insert(line["class"]);
        has_hidden = has_hidden || !line["visible"].get<bool>();
        EXPECT_GE(line["points"].size(), 2u);
    }
    EXPECT_THAT(classes, testing::ElementsAre("ridge", "silhouette"));
    EXPECT_TRUE(has_hidden);
    const std::string svg = bytes_of(folder / "prism.svg");
    EXPECT_THAT(svg, testing::HasSubstr("silhouette\""));
    EXPECT_THAT(svg, testing::HasSubstr("ridge hidden\""));
}

TEST(lines, of_a_level_are_the_same_bytes_every_time)
{
    const TemporaryFolder folder;
    for (const char* name : {"a.svg", "b.svg"})
        ASSERT_EQ(run_program({"lines", kHall, "--camera", "entrance", "--size", "700x450", "--out", folder / name})
                      .exit_code,
                  0);
    EXPECT_EQ(bytes_of(folder / "a.svg"), bytes_of(folder / "b.svg"));
    EXPECT_GT(bytes_of(folder / "a.svg").size(), 20'000u);
}

TEST(lines, never_replace_what_they_are_drawn_from_and_write_svg_or_pdf_alone)
{
    const TemporaryFolder folder;
    EXPECT_EQ(run_program({"lines", kPrism, "--out", folder / "prism.png"}).exit_code, 2);
    EXPECT_EQ(run_program({"lines", kPrism, "--out", folder / "x.svg", "--json", kPrism}).exit_code, 2);
    EXPECT_EQ(run_program({"export-edges", kPrism, "--out", kPrism}).exit_code, 2);
    EXPECT_TRUE(folder.names().empty());
    EXPECT_EQ(run_program({"lines", kPrism, "--out", folder / "prism.pdf"}).exit_code, 0);
    EXPECT_EQ(bytes_of(folder / "prism.pdf").rfind("%PDF", 0), 0u);
}

}  // namespace hw::test
