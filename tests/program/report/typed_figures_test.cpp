// Figures that were measured are filled into documents from the report. What is typed is set: a limit, a size, a step
// of a method. Each typed number that looks measured is listed here with its reason.
#include <gmock/gmock.h>

#include <filesystem>
#include <map>
#include <regex>

#include "tests/program/run_program.hpp"

namespace hw::test {
namespace {

namespace fs = std::filesystem;

const fs::path kSource(HATCHWAY_SOURCE_DIR);
const fs::path kMethod = kSource / "docs/method";

/// A page without filled figures, code, the targets of links, and numbers of versions and chapters.
std::string prose_of(std::string page)
{
    for (const char* passed : {"<!--@[^>]*-->[^<]*<!--@-->", "```[^]*?```", "`[^`]*`", "\\]\\([^)]*\\)", "\n    [^\n]*",
                               "(OpenGL|OpenGL ES|glTF|sections?) \\d\\.\\d(\\.\\d)?( and \\d\\.\\d)?", "\n## [^\n]*"})
        page = std::regex_replace(page, std::regex(passed), "#");
    return page;
}

/// Ranges and defaults are what a table of parameters is for. Of methods there is none.
std::string without_parameters(const fs::path& page)
{
    const std::string text = bytes_of(page);
    return page.parent_path() == kMethod ? text : std::regex_replace(text, std::regex("\n\\| `[^\n]*"), "");
}

/// All matches of the second group, each with one blank between its words.
std::vector<std::string> matches(const std::string& text, const std::string& pattern)
{
    const std::regex expression(pattern, std::regex::icase);
    std::vector<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match) {
        std::string words = std::regex_replace((*match)[2].str(), std::regex("\\s+"), " ");
        // "3 x 3" is a size.
        const std::string after = match->suffix().str().substr(0, 2);
        if (words.back() == 'x' && after.size() == 2 && std::isdigit(static_cast<unsigned char>(after[1]))) continue;
        found.push_back(std::move(words));
    }
    return found;
}

const std::string kDigits = R"(\d(?:[\d,]*\d)?(?:\.\d+)?(?:e-?\d+)?)";
const std::string kWords =
    "(?:half|a third|a quarter|two|three|four|five|six|seven|eight|nine|ten|twelve|twenty|thirty|forty|fifty|sixty|"
    "hundred|thousand|million)";

/// What of a page looks measured and was typed: numbers, in digits or words, with a unit of time, size or comparison,
/// and bare ones that are more exact than a count by hand: with a point, a comma or a power of ten.
std::vector<std::string> typed_figures(const std::string& page)
{
    const std::string unit =
        "(?:seconds?|minutes?|hours?|percent|times|bytes?|frames|(?:in|of) a (?:hundred|thousand))";
    const std::string sign = "(?:ms|us|ns|s|%|x|fps|[KMGk]i?B|cm|mm)";
    const std::string exact = R"((?:\d[\d,]*\.\d+(?:e-?\d+)?|\d+,\d[\d,]*|\d+e-?\d+))";
    return matches(prose_of(page),
                   R"((^|[^\w.#,]))" +
                       ("(" + kDigits + "\\s?(?:" + unit + "|" + sign + ")|" + kWords + "\\s+" + unit + "|" + exact) +
                       R"()(?![\w,.]*\d)(?=[^\w]|$))");
}

/// The parts of a page that tell what was measured.
std::string measured_parts(const std::string& page)
{
    std::string parts;
    for (const std::string begin : {"\n## Measured\n", "\n## Other implementations\n", "\n**Measured**"})
        if (const std::size_t at = page.find(begin); at != std::string::npos)
            parts += "\n" + page.substr(at + begin.size(), page.find("\n## ", at + 1) - at - begin.size());
    return parts;
}

/// All numbers that are typed, names like F12 apart.
std::string typed_numbers(const std::string& text)
{
    std::string found;
    for (const std::string& number :
         matches(prose_of(text), R"((^|[^\w.#,])()" + kDigits + "|" + kWords + R"()(?=[^\w]|$))"))
        found += (found.empty() ? "" : " ") + number;
    return found;
}

std::vector<fs::path> pages_in(const fs::path& folder)
{
    std::vector<fs::path> pages;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".md") pages.push_back(entry.path());
    return pages;
}

/// The pages that speak to users: all but the licences of content.
std::vector<fs::path> documents()
{
    std::vector<fs::path> pages = pages_in(kSource);
    std::vector<fs::path> folders{kSource / "docs", kMethod, kSource / "docs/report"};
    for (const char* parent : {"npr_plugins", "docs/examples"})
        for (const auto& entry : fs::directory_iterator(kSource / parent))
            if (entry.is_directory()) folders.push_back(entry.path());
    for (const fs::path& folder : folders)
        for (const fs::path& page : pages_in(folder)) pages.push_back(page);
    return pages;
}

}  // namespace

TEST(typed_figures, are_found_in_digits_and_in_words)
{
    EXPECT_THAT(
        typed_figures("takes 12.5 ms, 3x less, 40 % of `7 s`, <!--@a: b .1f-->9 s<!--@-->, 2 GiB and 3 x 3 pixels"),
        testing::ElementsAre("12.5 ms", "3x", "40 %", "2 GiB"));
    EXPECT_THAT(typed_figures("twelve\ntimes, 16 bytes an edge, over 12,288 inputs, 1e-4, section 3.1, OpenGL ES 3.0, "
                              "F12, two faces; three in a hundred, 1.5 of 7"),
                testing::ElementsAre("twelve times", "16 bytes", "12,288", "1e-4", "three in a hundred", "1.5"));
    EXPECT_EQ(typed_numbers("of 1,000 rays 3.5 went on, in `7` rows of <!--@a: b .0f-->9<!--@-->; F12, 1e-6, five."),
              "1,000 3.5 1e-6 five");
}

TEST(typed_figures, of_no_document_were_measured)
{
    // What is set, not measured.
    const std::map<std::string, std::vector<std::string>> set{
        // a limit of hatching_test, places, a limit, the size of a struct
        {"CHANGELOG.md", {"0.08", "1e6", "2 GiB", "thousand times", "8 bytes"}},
        // how long fuzzers run in ./check
        {"CONTRIBUTING.md", {"20 seconds"}},
        // limits and periods; 1e6 m in floats: arithmetic
        {"docs/level_files.md", {"2 GiB", "two seconds", "0.05 mm", "16 MiB", "10,000", "4,096", "1e6", "6 cm"}},
        // what a walk holds, limits of layers
        {"docs/method/devices.md", {"1,000", "4,000", "30 frames"}},
        // a proof, a setting, a window of the judge, limits of picture_and_drawing_test
        {"docs/method/drawn_lines.md",
         {"0.5", "0.5", "0.5", "0.5", "0.75", "0.75", "3.5", "99.5 %", "99.1 %", "2 %", "12 %"}},
        // the triangles of a case
        {"docs/method/edge_maps.md", {"20,000"}},
        // an example, and the largest step of that definition by its formula
        {"docs/method/hatching.md", {"1.5", "6 %", "95 %"}},
        // a limit of the atlas, samples of the reference
        {"docs/method/light.md", {"six times", "8 times"}},
        // tolerances, sizes of structs, where a model is put, a setting
        {"docs/method/silhouettes.md", {"1e-5", "8 bytes", "8 bytes", "two bytes", "10,000", "2,000"}},
        // limits of the fuzzers, how a file was damaged
        {"docs/method/strangers_files.md", {"2 GB", "four bytes", "64 KiB", "600 s"}},
        // a width of the slits
        {"docs/method/visibility.md", {"0.001"}},
        // numbers in a file, a tolerance
        {"docs/method/visible_lines.md", {"1e-8", "1.2e-7", "1e-5"}},
        // ticks, the longest frame of the random walks, the judge's tolerance
        {"docs/method/walking.md", {"120 s", "100 ms", "0.1 mm"}},
        // sections of a paper
        {"docs/references.md", {"3.2", "3.3"}},
        // defaults, a limit
        {"docs/write_a_style.md", {"1.5", "1.2", "ten seconds"}},
        // a parameter of the picture
        {"npr_plugins/pen_and_ink/README.md", {"0.9"}},
    };
    const std::vector<fs::path> pages = documents();
    EXPECT_GT(pages.size(), 20u);
    for (const fs::path& page : pages) {
        const std::string name = fs::relative(page, kSource).string();
        const auto known = set.find(name);
        EXPECT_EQ(typed_figures(without_parameters(page)),
                  known == set.end() ? std::vector<std::string>() : known->second)
            << name;
    }
}

TEST(typed_figures, where_pages_tell_what_was_measured_are_all_known_to_be_set)
{
    // By page: sizes of pictures, views and windows, limits of tests, columns, cases, years. A figure that was measured
    // is none of them.
    const std::map<std::string, std::string> set{
        {"devices.md", "320 200 16 255 thousand 5 25 1 thirty half thirty"},
        {"drawn_lines.md", "4 3.5 1000 ten 99.5 99.1 half 2 12"},
        {"edge_maps.md",
         "1400 900 2003 2011 2003 2011 2011 2003 2003 2011 two 2003 2003 2011 1 5 20,000 1 5 1 2011 2011 2 16 64 256 "
         "1024 2003 2011"},
        {"hatching.md",
         "two a third two two 3 1 half half two 1.5 two 6 200 1 3 11 90 200 700 45 80 85 85 two 48 two 17 17 95 1280 "
         "720 1 4 0 100 1 four 0 five five five half 1 4"},
        {"light.md", "512 8 8 8 8 8 two 8 4 8 4 0"},
        {"silhouettes.md", "three two two two two three two 64 16 10,000 90 100 100"},
        {"strangers_files.md", "four 64 600 30"},
        {"visibility.md", "64 half half 64 1 0.001 two half"},
        {"visible_lines.md", "1400 900 two 15 30 two two"},
        {"walking.md", "1 100 eight half 16 0.1"},
    };
    for (const fs::path& page : pages_in(kMethod)) {
        const auto known = set.find(page.filename().string());
        EXPECT_EQ(typed_numbers(measured_parts(bytes_of(page))), known == set.end() ? "" : known->second) << page;
    }
    // Debian, keys, exit codes.
    EXPECT_EQ(typed_numbers(bytes_of(kSource / "README.md")), "three 12 1 9 0 0 1 2");
}

}  // namespace hw::test
