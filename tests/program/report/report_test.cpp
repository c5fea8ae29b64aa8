// Figures in documents are those of the report, and what is no result has none.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/program/run_program.hpp"

namespace hw::test {
namespace {

namespace fs = std::filesystem;

const fs::path kDocs = fs::path(HATCHWAY_SOURCE_DIR) / "docs";

/// A folder with the committed results as `report`, and an empty folder `pages`.
class ReportFolder {
 public:
    ReportFolder()
    {
        fs::create_directories(folder_.path() / "report/results");
        fs::create_directories(folder_.path() / "pages");
        for (const auto& entry : fs::directory_iterator(kDocs / "report/results"))
            if (entry.path().extension() == ".json")
                fs::copy_file(entry.path(), folder_.path() / "report/results" / entry.path().filename());
    }
    fs::path page(const std::string& name) const { return folder_.path() / "pages" / name; }
    ProgramResult fill() const
    {
        return run_program({"report", "--out", folder_ / "report", "--reuse", "--fill", folder_ / "pages"});
    }
    const TemporaryFolder& folder() const { return folder_; }

 private:
    TemporaryFolder folder_;
};

}  // namespace

TEST(report_program, every_figure_of_the_method_pages_is_that_of_the_report)
{
    const ReportFolder report;
    std::size_t figures = 0;
    for (const auto& entry : fs::directory_iterator(kDocs / "method")) {
        fs::copy_file(entry.path(), report.page(entry.path().filename().string()));
        const std::string text = bytes_of(entry.path());
        for (std::size_t at = text.find("<!--@-->"); at != std::string::npos; at = text.find("<!--@-->", at + 1))
            ++figures;
    }
    EXPECT_GT(figures, 100u);
    const ProgramResult result = report.fill();
    ASSERT_EQ(result.exit_code, 0) << result.err;
    for (const auto& entry : fs::directory_iterator(kDocs / "method"))
        EXPECT_EQ(bytes_of(report.page(entry.path().filename().string())), bytes_of(entry.path()))
            << entry.path().filename();
}

TEST(report_program, the_page_is_made_of_the_results_and_of_nothing_else)
{
    const ReportFolder report;
    // Folders that are not there: with --reuse nothing in them is measured.
    const ProgramResult result =
        run_program({"report", "--out", report.folder() / "report", "--reuse", "--data", report.folder() / "none"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    // `hatchway report --out docs/report --reuse --data FOLDER` writes it again. EXPECT_EQ would print both pages.
    EXPECT_TRUE(bytes_of(report.folder().path() / "report/index.html") == bytes_of(kDocs / "report/index.html"));
}

TEST(report_program, every_committed_result_of_a_measurement_is_of_a_commit_as_it_stands)
{
    std::size_t results = 0;
    for (const auto& entry : fs::directory_iterator(kDocs / "report/results")) {
        const std::string name = entry.path().stem().string();
        const char* by = name == "game_map"  ? "game_map_share.py "
                         : name == "fuzz"    ? "campaign.py "
                         : name == "devices" ? "test_program "
                                             : "hatchway measure ";
        const std::string json = bytes_of(entry.path());
        EXPECT_TRUE(std::regex_search(json, std::regex("\"commit\": \"[0-9a-f]{10,40}\""))) << name;
        EXPECT_THAT(json, testing::HasSubstr(std::string("\"command\": \"") + by)) << name;
        ++results;
    }
    EXPECT_GT(results, 12u);
}

TEST(report_program, a_result_that_is_made_elsewhere_has_its_section_where_its_file_is)
{
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "results");
    const auto page = [&] {
        const ProgramResult result = run_program(
            {"report", "--out", folder.path().string(), "--only", "fuzz", "--only", "devices", "--only", "game_map"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return bytes_of(folder.path() / "index.html");
    };
    EXPECT_THAT(page(), testing::Not(testing::HasSubstr("<h2>")));
    for (const std::string name : {"fuzz", "devices", "game_map"})
        folder.write("results/" + name + ".json",
                     R"({"rows": [{"file": "svg", "faults": 77}], "origin": {"commit": ")" + name +
                         R"(_1", "command": "made by )" + name + R"(", "cpu_s_of_commits": {"abc": 5}}})");
    const std::string shown = page();
    for (const std::string name : {"fuzz", "devices", "game_map"})
        EXPECT_THAT(shown, testing::AllOf(testing::HasSubstr("<pre>made by " + name + "</pre>"),
                                          testing::HasSubstr("commit " + name + "_1; cpu_s_of_commits.abc 5</p>")));
    EXPECT_THAT(shown, testing::HasSubstr("<td>77</td>"));
}

TEST(report_program, where_nothing_was_measured_the_figure_is_a_dash)
{
    const ReportFolder report;
    report.folder().write("report/results/walk.json", R"({"rows": [{"file": "a", "stuck": null}]})");
    report.folder().write("pages/a.md", "<!--@walk file=a: stuck .0f-->0<!--@-->");
    ASSERT_EQ(report.fill().exit_code, 0);
    EXPECT_EQ(bytes_of(report.page("a.md")), "<!--@walk file=a: stuck .0f-->-<!--@-->");
}

TEST(report_program, a_figure_that_was_typed_is_replaced)
{
    const ReportFolder report;
    report.folder().write("pages/a.md", "| <!--@walk file=hall.level.json: inputs .0f-->5<!--@--> |\n");
    ASSERT_EQ(report.fill().exit_code, 0);
    EXPECT_THAT(bytes_of(report.page("a.md")), testing::HasSubstr("-->100000<!--@-->"));
}

TEST(report_program, a_page_can_tell_the_worst_of_all_rows)
{
    const ReportFolder report;
    report.folder().write("pages/a.md",
                          "<!--@lines path=quads: max missed x100 .3f-->0<!--@-->\n"
                          "<!--@lines path=quads: min width_p5 .3f-->0<!--@-->\n");
    ASSERT_EQ(report.fill().exit_code, 0);
    double worst = 0.0, narrowest = 1e9;
    const auto lines = nlohmann::json::parse(bytes_of(kDocs / "report/results/lines.json"));
    for (const auto& row : lines["rows"])
        if (row["path"] == "quads") {
            worst = std::max(worst, row["missed"].get<double>());
            narrowest = std::min(narrowest, row["width_p5"].get<double>());
        }
    EXPECT_GT(worst, 0.0);
    EXPECT_THAT(bytes_of(report.page("a.md")), testing::HasSubstr(fmt::format("-->{:.3f}<!--@-->", narrowest)));
    EXPECT_THAT(bytes_of(report.page("a.md")), testing::HasSubstr(fmt::format("-->{:.3f}<!--@-->", 100.0 * worst)));
}

TEST(report_program, a_figure_that_no_result_has_is_refused_and_no_page_is_written)
{
    const ReportFolder report;
    const std::string stale = "<!--@walk file=hall.level.json: inputs .0f-->5<!--@-->";
    report.folder().write("pages/a.md", stale);
    report.folder().write("pages/b.md", "<!--@walk file=hall.level.json: no_such_column .0f-->5<!--@-->");
    const ProgramResult result = report.fill();
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, testing::HasSubstr("no_such_column"));
    EXPECT_EQ(bytes_of(report.page("a.md")), stale);
}

TEST(report_program, lines_from_images_have_a_figure_of_time_against_error_for_each_model)
{
    const TemporaryFolder folder;
    const std::string origin = R"("origin": {"commit": "0123456789", "command": "hatchway measure edge-map"})";
    fs::create_directories(folder.path() / "results");
    folder.write("results/edge_map.json",
                 R"({"rows": [
{"model": "pot", "variant": "ids", "normal": null, "ms": 5, "profile_missed": 0.1, "profile_extra": 0.02},
{"model": "pot", "variant": "object", "normal": null, "ms": 9, "profile_missed": 0.01, "profile_extra": 0},
{"model": "hall", "variant": "ids", "normal": null, "ms": 7, "profile_missed": 0.2, "profile_extra": null}],
"cases": [], "curve": [], )" +
                     origin + "}");
    folder.write("results/ids.json",
                 R"({"rows": [{"model": "pot"}], "cases": [], "fan": [
{"sides": 16, "storage": "lists", "resolve_ms": 3}, {"sides": 64, "storage": "lists", "resolve_ms": 12}], )" +
                     origin + "}");
    const ProgramResult result =
        run_program({"report", "--out", folder.path().string(), "--reuse", "--only", "edge_map", "--only", "ids"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::string page = bytes_of(folder.path() / "index.html");
    EXPECT_THAT(page, testing::HasSubstr("Time against error of profiles: pot<"));
    EXPECT_THAT(page, testing::Not(testing::HasSubstr("Time against error of profiles: hall<")))
        << "of what nothing was measured there is no point, and so no figure";
    EXPECT_THAT(page, testing::HasSubstr(">The fan around one edge<"));
    EXPECT_THAT(page, testing::Not(testing::HasSubstr("class=\"failure\"")));
}

/// A square of glass: it hides nothing.
const char* const kGlass =
    R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "scene": 0, "nodes": [{"mesh": 0}],
"materials": [{"alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.3]}}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
{"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
"bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
"buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAAAAABAAIAAAACAAMA"}]})";

TEST(measure_program, where_there_is_nothing_to_judge_there_is_no_perfect_result)
{
    const TemporaryFolder folder;
    const std::string glass = folder.write("glass.gltf", kGlass);
    const std::string triangle = folder.write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::map<std::vector<std::string>, std::string> refused{
        {{"pvs", glass, "--rays", "64", "--pvs", "fast"}, "no polygon that hides anything"},
        {{"bsp", glass, "--points", "10"}, "no polygon that hides anything"},
        {{"silhouettes", triangle, "--views", "2", "--offset", "0"}, "no edge is a silhouette from any view"}};
    for (const auto& [words, reason] : refused) {
        std::vector<std::string> all{"measure"};
        all.insert(all.end(), words.begin(), words.end());
        all.insert(all.end(), {"--json", folder / "rows.json"});
        const ProgramResult result = run_program(all);
        EXPECT_EQ(result.exit_code, 2) << words[0];
        EXPECT_THAT(result.err, testing::HasSubstr(reason));
    }
    EXPECT_THAT(folder.names(), testing::ElementsAre("glass.gltf", "triangle.obj"));
}

TEST(measure_program, what_looks_away_from_everything_has_no_share_of_errors)
{
    const TemporaryFolder folder;
    folder.write("prism.glb", bytes_of(kContent / "models" / "prism.glb"));
    const std::string away = folder.write("away.level.json", R"({"format": "hatchway-level/1", "scene": "prism.glb",
"cameras": {"away": {"position": [50, 0, 0], "look_at": [60, 0, 0]}},
"paths": {"away": {"fps": 25, "keys": [{"t_s": 0, "position": [50, 0, 0], "look_at": [60, 0, 0]},
{"t_s": 1, "position": [51, 0, 0], "look_at": [60, 0, 0]}]}}})");
    const std::string out = folder / "rows.json";
    const auto expect_null = [&](std::vector<std::string> words, const char* column) {
        words.insert(words.begin(), "measure");
        words.insert(words.end(), {"--json", out});
        ASSERT_EQ(run_program(words).exit_code, 0);
        const nlohmann::json result = nlohmann::json::parse(bytes_of(out));
        ASSERT_FALSE(result["rows"].empty());
        for (const nlohmann::json& row : result["rows"]) EXPECT_TRUE(row.at(column).is_null()) << row;
    };
    expect_null({"visible-lines", away}, "missed");
    expect_null({"frame", away, "--path", "away", "--frames", "2", "--size", "64x48", "--style", "*=photoreal"},
                "pixels_unlike_without_pvs");
}

TEST(measure_program, of_ink_maps_the_largest_step_of_any_level_is_told_and_the_pen_is_the_one_that_was_given)
{
    const TemporaryFolder folder;
    const fs::path maps = kContent / "maps" / "ink";
    const auto measured = [&](const std::string& pen) {
        const ProgramResult result =
            run_program({"measure", "ink", (maps / "stone_courses").string(), "--by-hand", (maps / "bricks").string(),
                         "--pen", pen, "--json", folder / "ink.json"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return nlohmann::json::parse(bytes_of(folder / "ink.json"));
    };
    const nlohmann::json fine = measured("1.5"), wide = measured("3");
    std::map<std::string, double> largest;
    for (const nlohmann::json& row : fine["rows"]) {
        double& step = largest[row["filter"]];
        step = std::max(step, std::abs(row["tone_step"].get<double>()));
    }
    EXPECT_THAT(largest, testing::SizeIs(5)) << "as made, by hand, and three ways from a drawing";
    for (const nlohmann::json& kind : fine["summary"])
        EXPECT_NEAR(kind["largest_tone_step"].get<double>(), largest[kind["filter"]], 1e-6) << kind["filter"];
    const auto width = [](const nlohmann::json& result) {
        for (const nlohmann::json& row : result["rows"])
            if (row["map"] == "bricks" && row["filter"] == "from pixels") return row["stroke_texels"].get<double>();
        return 0.0;
    };
    EXPECT_NEAR(width(wide) / width(fine), 2.0, 0.1);
}

TEST(report_program, a_result_says_what_was_measured_where_and_the_page_repeats_it_when_results_are_reused)
{
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "results");
    const std::string result = folder / "results/silhouettes.json";
    const std::string prism = (kContent / "models" / "prism.glb").string();
    ASSERT_EQ(
        run_program({"measure", "silhouettes", prism, "--offset", "0,1e3", "--json", result, "--views", "1"}).exit_code,
        0);
    const std::string json = bytes_of(result);
    for (const char* part : {"\"commit\": \"", "\"processor\": \"", "\"threads\": ", "\"date\": \""})
        EXPECT_THAT(json, testing::HasSubstr(part));
    EXPECT_THAT(json, testing::HasSubstr("hatchway measure silhouettes " + prism + " --views 1 --offset 0,1e3\""));

    const auto page = [&] {
        EXPECT_EQ(
            run_program({"report", "--out", folder.path().string(), "--reuse", "--only", "silhouettes"}).exit_code, 0);
        return bytes_of(folder.path() / "index.html");
    };
    folder.write("results/silhouettes.json",
                 std::regex_replace(json, std::regex("\"date\": \"[^\"]*"), "\"date\": \"1999-12-31"));
    EXPECT_THAT(page(), testing::AllOf(testing::HasSubstr("1999-12-31"), testing::HasSubstr("--offset 0,1e3</pre>"),
                                       testing::HasSubstr("<table>")));
    folder.write("results/silhouettes.json", R"({"rows": [{"model": "prism"}]})");
    EXPECT_THAT(page(), testing::AllOf(testing::HasSubstr("does not say what was measured where"),
                                       testing::Not(testing::HasSubstr("<table>"))));
}

TEST(measure_program, a_mesh_whose_faces_collapse_is_no_result)
{
    const TemporaryFolder folder;
    const std::string prism = (kContent / "models" / "prism.glb").string();
    const auto measured = [&](const std::string& offsets) {
        return run_program({"measure", "silhouettes", prism, "--views", "2", "--scale", "1e-6", "--offset", offsets,
                            "--json", folder / "rows.json"});
    };
    const ProgramResult none = measured("1e3");
    EXPECT_EQ(none.exit_code, 2);
    EXPECT_THAT(none.err, testing::HasSubstr("of 28 faces are left: not measured"));
    EXPECT_THAT(folder.names(), testing::IsEmpty());

    ASSERT_EQ(measured("0,1e3").exit_code, 0);
    const std::string rows = bytes_of(folder / "rows.json");
    EXPECT_THAT(rows, testing::HasSubstr("\"faces_left\""));
    EXPECT_THAT(rows, testing::Not(testing::HasSubstr("1000")));
}

}  // namespace hw::test
