// Figures in documents are those of the report, and what is no result has none.
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

/// A page without filled figures, code and the targets of links.
std::string prose_of(std::string page)
{
    for (const char* passed :
         {"<!--@[^>]*-->[^<]*<!--@-->", "```[^]*?```", "`[^`]*`", "\\]\\([^)]*\\)", "\n    [^\n]*"})
        page = std::regex_replace(page, std::regex(passed), "#");
    return page;
}

/// What of a page looks measured and was typed: numbers with a unit of time, size or comparison.
std::vector<std::string> typed_figures(const std::string& page)
{
    const std::string prose = prose_of(page);
    const std::regex figure(
        R"((^|[^\w.#])(\d[\d,.]*(e-?\d+)?)\s?(ms|us|ns|s|seconds|minutes|hours|%|times|x|fps|percent|frames|[KMG]i?B)(?=[^\w]|$))");
    std::vector<std::string> found;
    for (std::sregex_iterator match(prose.begin(), prose.end(), figure), end; match != end; ++match) {
        // "3 x 3" is a size.
        const std::string after = match->suffix().str().substr(0, 2);
        if ((*match)[4] == "x" && after.size() == 2 && std::isdigit(static_cast<unsigned char>(after[1]))) continue;
        found.push_back((*match)[2].str() + ' ' + (*match)[4].str());
    }
    return found;
}

/// The parts of a page that tell what was measured.
std::string measured_parts(const std::string& page)
{
    std::string parts;
    for (const std::string begin : {"\n## Measured\n", "\n## Other implementations\n", "\n**Measured**"})
        if (const std::size_t at = page.find(begin); at != std::string::npos)
            parts += page.substr(at, page.find("\n## ", at + 1) - at);
    return parts;
}

/// All that is typed in digits, names like F12 apart.
std::string typed_numbers(const std::string& text)
{
    const std::string prose = prose_of(text);
    const std::regex number(R"((^|[^\w.#])(\d([\d,.]*\d)?(e-?\d+)?))");
    std::string found;
    for (std::sregex_iterator match(prose.begin(), prose.end(), number), end; match != end; ++match)
        found += (found.empty() ? "" : " ") + (*match)[2].str();
    return found;
}

std::vector<fs::path> pages_in(const fs::path& folder)
{
    std::vector<fs::path> pages;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".md") pages.push_back(entry.path());
    return pages;
}

TEST(report_program, documents_hold_no_figure_that_looks_measured_and_was_typed)
{
    EXPECT_THAT(
        typed_figures("takes 12.5 ms, 3x less, 40 % of `7 s`, <!--@a: b .1f-->9 s<!--@-->, 2 GiB and 3 x 3 pixels"),
        testing::ElementsAre("12.5 ms", "3 x", "40 %", "2 GiB"));
    // What is set, not measured: limits that tests hold, steps and sizes of a method.
    const std::map<std::string, std::vector<std::string>> set{
        {"devices.md", {"30 frames"}},                        // what a walk holds
        {"drawn_lines.md", {"99.5 %", "99.1 %"}},             // limits of picture_and_drawing_test
        {"hatching.md", {"6 %", "95 %"}},                     // the largest step of that definition; an interval
        {"level_files.md", {"2 GiB", "16 MiB"}},              // limits
        {"light.md", {"8 times"}},                            // samples of the reference
        {"strangers_files.md", {"2 GB", "64 KiB", "600 s"}},  // limits of the fuzzers
        {"walking.md", {"120 s", "100 ms"}},                  // ticks, and the longest frame of the random walks
    };
    std::vector<fs::path> pages{kDocs.parent_path() / "README.md"};
    for (const fs::path& folder : {kDocs, kDocs / "method", kDocs / "report"})
        for (const fs::path& page : pages_in(folder)) pages.push_back(page);
    EXPECT_GT(pages.size(), 12u);
    for (const fs::path& page : pages) {
        const auto known = set.find(page.filename().string());
        EXPECT_EQ(typed_figures(bytes_of(page)), known == set.end() ? std::vector<std::string>() : known->second)
            << page;
    }
}

TEST(report_program, where_documents_tell_what_was_measured_every_number_is_filled_in_or_known_to_be_set)
{
    EXPECT_EQ(typed_numbers("of 1,000 rays 3.5 went on, in `7` rows of <!--@a: b .0f-->9<!--@-->; F12, 1e-6."),
              "1,000 3.5 1e-6");
    // By page: sizes of pictures, views and windows, limits of tests, columns. A figure that was measured is none of
    // them.
    const std::map<std::string, std::string> set{
        {"devices.md", "320 200 16 255 5 25 1 256"},
        {"drawn_lines.md", "4 3.5 1000 99.5 99.4"},
        {"hatching.md", "3 1 1.5 6 99 5 200 1 5 3 11 90 200 700 45 80 85 85 48 17 17 95 95 1280 720 1 4 0 100 1 0 1 4"},
        {"light.md", "512 95 8 8 8 8 8 8 4 8 4 0"},
        {"silhouettes.md", "64 16 10,000 90 100 100"},
        {"strangers_files.md", "64 600 30"},
        {"visibility.md", "64 64 1 0.001"},
        {"visible_lines.md", "1400 900 1.5"},
        {"walking.md", "1 100 16 0.1"},
    };
    for (const fs::path& page : pages_in(kDocs / "method")) {
        const auto known = set.find(page.filename().string());
        EXPECT_EQ(typed_numbers(measured_parts(bytes_of(page))), known == set.end() ? "" : known->second) << page;
    }
    // Debian, keys, exit codes.
    EXPECT_EQ(typed_numbers(bytes_of(kDocs.parent_path() / "README.md")), "12 1 9 0 0 1 2");
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

TEST(report_program, a_figure_that_was_typed_is_replaced)
{
    const ReportFolder report;
    report.folder().write("pages/a.md", "| <!--@walk file=hall.level.json: inputs .0f-->5<!--@--> |\n");
    ASSERT_EQ(report.fill().exit_code, 0);
    EXPECT_THAT(bytes_of(report.page("a.md")), testing::HasSubstr("-->100000<!--@-->"));
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
