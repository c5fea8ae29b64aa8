// Runs the measurements one after the other, keeps what they write as JSON, and makes one page of it. A measurement
// that fails leaves its reason on the page and the others run on.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/core/plain_text.hpp"
#include "program/commands.hpp"
#include "program/output_files.hpp"
#include "report/figures_in_text.hpp"
#include "report/report_page.hpp"

namespace hw {
namespace {

constexpr const char* kResults = "results";  // the folder of the JSON files, beside the page

namespace fs = std::filesystem;

struct ReportArguments {
    fs::path out;
    fs::path data;
    std::vector<std::string> only;
    bool is_reused = false;
    fs::path pages;
};

void run_measure(const ReportSection& section, const fs::path& json)
{
    CommandLineReader line("hatchway", "");
    add_measure_command(line.program());
    std::vector<std::string> words{"measure"};
    words.insert(words.end(), section.arguments.begin(), section.arguments.end());
    words.insert(words.end(), {"--json", json.string()});
    line.run(words);
}

fs::path json_of(const ReportSection& section, const ReportArguments& arguments)
{
    return arguments.out / kResults / (section.name + ".json");
}

MeasuredSection measured(const ReportSection& section, const ReportArguments& arguments)
{
    const fs::path json = json_of(section, arguments);
    MeasuredSection result{section, {}, {}, ""};
    try {
        if (!arguments.is_reused && !section.arguments.empty()) run_measure(section, json);
        result.table = read_json_table(json);
        if (text_in(result.table.facts, "origin.commit") == "-")
            throw Error({.what = "does not say what was measured where", .file = json.string()});
        for (const std::string& name : section.more) result.more.push_back(read_json_table(json, name));
    } catch (const std::exception& error) {
        result.failure = error.what();
        log_warning("measure " + section.name + ": " + result.failure);
    }
    return result;
}

void refuse_unknown_sections(const std::vector<std::string>& wanted, const std::vector<ReportSection>& plan)
{
    std::vector<std::string> names;
    for (const ReportSection& section : plan) names.push_back(section.name);
    for (const std::string& name : wanted)
        if (std::find(names.begin(), names.end(), name) == names.end())
            throw Error({.what = "--only " + name, .expected = fmt::format("one of: {}", fmt::join(names, ", "))});
}

/// Fills the figures of all Markdown pages of a folder; none is written when one of them has an unknown figure.
void fill_pages(const fs::path& pages, const fs::path& report)
{
    std::map<fs::path, std::string> filled;
    for (const auto& entry : fs::directory_iterator(pages)) {
        if (entry.path().extension() != ".md") continue;
        const std::string text = read_text_file(entry.path(), limits::kMaxFileBytes);
        std::string result = fill_figures(text, entry.path().string(), report);
        if (result != text) filled[entry.path()] = std::move(result);
    }
    for (const auto& [page, text] : filled) write_file_atomically(page, text);
}

void write_report(const ReportArguments& arguments)
{
    std::error_code missing;
    if (!fs::is_directory(fs::symlink_status(arguments.out, missing)))
        throw Error(
            {.what = "is no folder", .file = arguments.out.string(), .expected = "an existing folder for --out"});
    if (!arguments.pages.empty() && !fs::is_directory(arguments.pages, missing))
        throw Error(
            {.what = "is no folder", .file = arguments.pages.string(), .expected = "a folder of Markdown pages"});
    // Relative to the working folder: a report that is shown to others names no folder of this machine.
    const std::filesystem::path share = std::filesystem::proximate(installation_prefix() / "share" / "hatchway");
    const std::vector<ReportSection> plan = report_plan(share, arguments.data);
    refuse_unknown_sections(arguments.only, plan);
    make_folder(arguments.out / kResults);
    std::vector<MeasuredSection> sections;
    for (const ReportSection& section : plan) {
        const auto& only = arguments.only;
        if (!only.empty() && std::find(only.begin(), only.end(), section.name) == only.end()) continue;
        if (section.arguments.empty() && !fs::exists(json_of(section, arguments))) continue;
        sections.push_back(measured(section, arguments));
    }
    const fs::path page = arguments.out / "index.html";
    write_file_atomically(page, report_page(sections));
    if (!arguments.pages.empty()) fill_pages(arguments.pages, arguments.out / kResults);
    print_line(page.string());
}

}  // namespace

void add_report_command(CommandLine app)
{
    auto arguments = std::make_shared<ReportArguments>();
    CommandLine command =
        app.add_subcommand("report", "Runs the measurements and makes one page of time against error");
    command.add_option("--out", arguments->out, "An existing folder for index.html and results/*.json").required();
    command.add_option("--data", arguments->data,
                       "A folder with models/*.glb, scenes/*.glb and hard/*.glb to measure, too");
    command.add_option("--only", arguments->only, "Names of sections; default: all");
    command.add_option("--fill", arguments->pages, "A folder of Markdown pages whose figures are written anew");
    command.add_flag("--reuse", arguments->is_reused, "Make the page from the JSON files that are there");
    command.callback([arguments] { write_report(*arguments); });
}

}  // namespace hw
