#include "report/report_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <sstream>

#include "report/svg_plot.hpp"

namespace hw {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// The sum of the columns named in "a+b"; not a number when one is missing.
double sum_in(const std::map<std::string, JsonCell>& row, const std::string& columns)
{
    double sum = 0.0;
    std::istringstream names(columns);
    for (std::string name; std::getline(names, name, '+');) sum += number_in(row, name, kMissing);
    return sum;
}

std::string series_name(const std::map<std::string, JsonCell>& row, const std::vector<std::string>& columns)
{
    std::string name;
    for (const std::string& column : columns) name += (name.empty() ? "" : ", ") + text_in(row, column);
    return name;
}

std::string table_of(const JsonTable& table)
{
    std::string html = "<table><tr>";
    for (const std::string& column : table.columns) html += "<th>" + escaped(column) + "</th>";
    html += "</tr>\n";
    for (const auto& row : table.rows) {
        html += "<tr>";
        for (const std::string& column : table.columns) html += "<td>" + escaped(text_in(row, column)) + "</td>";
        html += "</tr>\n";
    }
    return html + "</table>\n";
}

/// What a result says of its origin: the command, then all else that it has.
std::string origin_html(const std::map<std::string, JsonCell>& facts)
{
    const std::string origin = "origin.";
    std::string html = "<pre>" + escaped(text_in(facts, origin + "command")) + "</pre>\n<p>";
    const char* separator = "";
    for (const auto& [name, cell] : facts) {
        if (name.rfind(origin, 0) != 0 || name == origin + "command") continue;
        html += separator + escaped(name.substr(origin.size()) + " " + text_in(facts, name));
        separator = "; ";
    }
    return html + "</p>\n";
}

/// The table of a list of a section's result; null where it has none.
const JsonTable* table_named(const MeasuredSection& measured, const std::string& list)
{
    if (list == "rows") return &measured.table;
    const auto& names = measured.section.more;
    const auto at = static_cast<std::size_t>(std::find(names.begin(), names.end(), list) - names.begin());
    return at < measured.more.size() ? &measured.more[at] : nullptr;
}

/// The figures of a recipe, without series where no row has both columns.
std::vector<Plot> plots_of(const PlotRecipe& recipe, const JsonTable& table)
{
    std::vector<Plot> plots;
    for (const auto& row : table.rows) {
        const std::string part = recipe.per_column.empty() ? "" : ": " + text_in(row, recipe.per_column);
        auto plot = std::find_if(plots.begin(), plots.end(),
                                 [&](const Plot& known) { return known.title == recipe.title + part; });
        if (plot == plots.end()) plot = plots.insert(plot, {recipe.title + part, recipe.x_label, recipe.y_label, {}});
        const double x = sum_in(row, recipe.x_column);
        const double y = sum_in(row, recipe.y_column);
        if (!(x >= 0.0) || !(y >= 0.0)) continue;
        const std::string name = series_name(row, recipe.series_columns);
        auto series = std::find_if(plot->series.begin(), plot->series.end(),
                                   [&](const PlotSeries& candidate) { return candidate.name == name; });
        if (series == plot->series.end()) series = plot->series.insert(series, {name, {}, recipe.is_joined});
        series->points.emplace_back(x, y);
    }
    return plots;
}

std::string section_html(const MeasuredSection& measured)
{
    const ReportSection& section = measured.section;
    std::string html = fmt::format("<h2>{}</h2>\n", escaped(section.title));
    if (!measured.failure.empty()) return html + "<p class=\"failure\">" + escaped(measured.failure) + "</p>\n";
    html += fmt::format("<p><b>Does not show:</b> {}</p>\n<p>{}</p>\n<p><b>Judge:</b> {}</p>\n",
                        escaped(section.leaves_out), escaped(section.says), escaped(section.judge));
    html += origin_html(measured.table.facts);
    for (const PlotRecipe& recipe : section.plots)
        if (const JsonTable* table = table_named(measured, recipe.list))
            for (const Plot& plot : plots_of(recipe, *table)) html += svg_of(plot);
    const auto add_table = [&](const std::string& name, const JsonTable& table) {
        html += "<details><summary>" + escaped(name) + "</summary>\n" + table_of(table) + "</details>\n";
    };
    add_table("All rows", measured.table);
    for (std::size_t i = 0; i < section.more.size(); ++i) add_table("More: " + section.more[i], measured.more[i]);
    return html;
}

constexpr const char* kStyleSheet =
    "body{font:15px/1.5 sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;color:#222}"
    "table{border-collapse:collapse;font-size:12px;display:block;overflow-x:auto}"
    "td,th{border:1px solid #ddd;padding:2px 6px;text-align:right}"
    "pre{background:#f5f3ee;padding:.5rem;overflow-x:auto}.failure{color:#a00}svg{max-width:100%;height:auto}";

}  // namespace

std::string report_page(const std::vector<MeasuredSection>& sections)
{
    std::string html =
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Hatchway: measured</title>";
    html += fmt::format("<style>{}</style></head>\n<body>\n<h1>Hatchway: time against error</h1>\n", kStyleSheet);
    html +=
        "<p>Each section says what it does not show, what judges it, and which commit was measured where, by which "
        "command. A row's time and its error are of one run; ink maps and coherence have errors alone. A dash stands "
        "where there was nothing to measure.</p>\n";
    for (const MeasuredSection& section : sections) html += section_html(section);
    return html + "</body></html>\n";
}

}  // namespace hw
