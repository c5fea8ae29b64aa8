// What commands of `hatchway measure` write, where the tests of measure/ see libraries alone.
#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/program/run_program.hpp"

namespace hw::test {

TEST(measure_program, openmesh_finds_nearly_the_edges_of_the_oracle_where_it_takes_every_face)
{
    const TemporaryFolder folder;
    ASSERT_EQ(run_program({"measure", "silhouettes", "--smooth", "8000", "--views", "3", "--offset", "0", "--json",
                           folder / "rows.json"})
                  .exit_code,
              0);
    const nlohmann::json result = nlohmann::json::parse(bytes_of(folder / "rows.json"));
    int judged = 0;
    for (const nlohmann::json& row : result["rows"]) {
        if (row["method"].get<std::string>().rfind("openmesh", 0) != 0) continue;
        ASSERT_EQ(row["refused_faces"], 0);
        for (const char* kind : {"fp", "fn", "repaired_fp", "repaired_fn"})
            EXPECT_LE(row[kind].get<double>(), 0.01 * row["expected"].get<double>()) << kind;
        ++judged;
    }
    EXPECT_EQ(judged, 2);
}

TEST(measure_program, an_edge_that_repair_did_not_change_has_no_error_of_changed_ones)
{
    const TemporaryFolder folder;
    const std::string prism = (kContent / "models" / "prism.glb").string();
    ASSERT_EQ(
        run_program({"measure", "silhouettes", prism, "--views", "1", "--offset", "0", "--json", folder / "rows.json"})
            .exit_code,
        0);
    const nlohmann::json rows = nlohmann::json::parse(bytes_of(folder / "rows.json"))["rows"];
    ASSERT_FALSE(rows.empty());
    for (const nlohmann::json& row : rows) {
        EXPECT_EQ(row["changed_edges"], 0);
        EXPECT_TRUE(row["changed_fp"].is_null()) << row;
    }
}

TEST(measure_program, ids_agree_with_the_rule_on_the_processor_and_outline_paper_on_a_desk)
{
    const TemporaryFolder folder;
    const std::string prism = (kContent / "models" / "prism.glb").string();
    ASSERT_EQ(run_program({"measure", "ids", prism, "--views", "2", "--size", "280x180", "--fan", "8,32", "--json",
                           folder / "ids.json"})
                  .exit_code,
              0);
    const nlohmann::json result = nlohmann::json::parse(bytes_of(folder / "ids.json"));
    std::set<std::string> ways;
    for (const nlohmann::json& row : result["rows"]) {
        ways.insert(row["operator"].get<std::string>() + " " + row["storage"].get<std::string>());
        EXPECT_EQ(row["differing_pixels"], 0) << row;
        EXPECT_GT(row["profile_recall"], 0.95) << row;
        for (const char* time : {"plain_ms", "ids_ms", "ids_over_plain", "device_fps", "object_fps"})
            EXPECT_GT(row[time], 0.0) << time;
        EXPECT_EQ(row["triangles"], 28);
    }
    EXPECT_THAT(ways, testing::ElementsAre("ids lists", "ids vertices", "ids_2011 lists", "ids_2011 vertices"));
    for (const nlohmann::json& known : result["cases"]) {
        EXPECT_EQ(known["differing_pixels"], 0) << known;
        if (known["case"] == "paper on a desk") {
            EXPECT_GT(known["flush_recall"], 0.9) << known;
        }
        if (known["case"].get<std::string>().starts_with("floor")) {
            EXPECT_EQ(known["false_share"], 0.0) << known;
        }
    }
    EXPECT_THAT(result["cases"], testing::SizeIs(5 * 4));
    EXPECT_THAT(result["fan"], testing::SizeIs(2 * 2));
}

TEST(measure_program, edge_maps_stand_beside_the_lines_of_the_meshes)
{
    const TemporaryFolder folder;
    const std::string prism = (kContent / "models" / "prism.glb").string();
    ASSERT_EQ(run_program({"measure", "edge-map", prism, "--views", "2", "--size", "280x180", "--operators",
                           "diagonal,ids,object", "--json", folder / "map.json"})
                  .exit_code,
              0);
    const nlohmann::json result = nlohmann::json::parse(bytes_of(folder / "map.json"));
    std::map<std::string, nlohmann::json> rows;
    for (const nlohmann::json& row : result["rows"]) rows[row["variant"]] = row;
    EXPECT_THAT(rows, testing::SizeIs(5));
    const nlohmann::json &lines = rows.at("object"), &anew = rows.at("object, made anew");
    for (const char* share : {"profile_recall", "profile_precision", "inner_recall", "inner_precision"})
        EXPECT_GT(lines[share], 0.99) << share << " of the lines of the mesh";
    EXPECT_GT(anew["ms"], lines["ms"]) << "edge table and adjacency";
    EXPECT_EQ(anew["profile_recall"], lines["profile_recall"]);
    EXPECT_NEAR(lines["profile_missed"].get<double>(), 1.0 - lines["profile_recall"].get<double>(), 1e-6);
    EXPECT_TRUE(rows.at("ids")["format"].is_null());
    EXPECT_LT(rows.at("ids")["inner_recall"], 0.9) << "numbers know no creases";
    EXPECT_EQ(rows.at("diagonal rgba8")["normal"], "geometric");
    EXPECT_THAT(result["cases"], testing::SizeIs(5 * 4));
    EXPECT_THAT(result["curve"], testing::SizeIs(7 * 4));
}

TEST(measure_program, a_fan_of_more_walls_than_a_picture_may_have_layers_is_refused)
{
    const ProgramResult result = run_program({"measure", "ids", "--fan", "1501"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, testing::HasSubstr("expected 3 to 1500"));
}

TEST(measure_program, a_seed_draws_other_places_and_the_same_ones_again)
{
    const TemporaryFolder folder;
    const std::string prism = (kContent / "models" / "prism.glb").string();
    const std::string hall = (kContent / "levels" / "hall.level.json").string();
    const std::vector<std::vector<std::string>> measures{
        {"silhouettes", prism, "--views", "1", "--random", "20", "--offset", "0"},
        {"pvs", prism, "--rays", "640", "--pvs", "fast"},
        {"walk", hall, "--inputs", "200"}};
    const std::vector<const char*> columns{"expected", "hits", "way_m"};
    for (std::size_t i = 0; i < measures.size(); ++i) {
        const auto measured = [&](const std::string& seed) {
            std::vector<std::string> words = measures[i];
            words.insert(words.begin(), "measure");
            words.insert(words.end(), {"--seed", seed, "--json", folder / "rows.json"});
            EXPECT_EQ(run_program(words).exit_code, 0) << words[1];
            return nlohmann::json::parse(bytes_of(folder / "rows.json"))["rows"][0].at(columns[i]).get<double>();
        };
        const double one = measured("1");
        EXPECT_EQ(measured("1"), one) << measures[i][0];
        EXPECT_NE(measured("2"), one) << measures[i][0];
    }
}

TEST(measure_program, distances_of_hatching_are_those_that_the_help_allows)
{
    for (const char* distance : {"0.5", "1001"}) {
        const ProgramResult result = run_program({"measure", "hatch", "--distances", distance});
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_THAT(result.err, testing::HasSubstr("expected 1 to 1000"));
    }
}

TEST(measure_program, a_slit_whose_eye_reads_no_row_is_neither_lost_nor_kept)
{
    const TemporaryFolder folder;
    ASSERT_EQ(run_program({"measure", "pvs", "--pvs", "fast", "--json", folder / "rows.json"}).exit_code, 0);
    const nlohmann::json slits = nlohmann::json::parse(bytes_of(folder / "rows.json"))["slits"];
    ASSERT_FALSE(slits.empty());
    for (const nlohmann::json& slit : slits) {
        const bool is_behind = slit["scene"] == "one-sided wall, from behind";
        EXPECT_EQ(slit.value("reads_row", is_behind), !is_behind) << slit;
        EXPECT_EQ(slit.contains("is_lost"), !is_behind) << slit;
    }
}

}  // namespace hw::test
