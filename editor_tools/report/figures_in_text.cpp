#include "report/figures_in_text.hpp"

#include <fmt/format.h>

#include <map>
#include <regex>

#include "hatchway/core/error.hpp"
#include "hatchway/io/json/table.hpp"

namespace hw {
namespace {

using Row = std::map<std::string, JsonCell>;

const std::regex kFigure(
    R"re(<!--@(\w+)(?:\.(\w+))?((?: [^:>]*)?): (\w[\w.]*)(?: x([\d.]+))? (\.\d+f)-->[^<]*<!--@-->)re");

/// The texts that a row must have, from "file=hall.level.json effort=full". A text may hold blanks.
std::map<std::string, std::string> conditions_in(const std::string& text)
{
    std::map<std::string, std::string> conditions;
    static const std::regex condition(R"((\w[\w.]*)=(.*?)(?= \w[\w.]*=|$))");
    for (std::sregex_iterator match(text.begin(), text.end(), condition), end; match != end; ++match)
        conditions[(*match)[1]] = (*match)[2];
    return conditions;
}

bool has_texts(const Row& row, const std::map<std::string, std::string>& conditions)
{
    for (const auto& [column, wanted] : conditions)
        if (text_in(row, column) != wanted) return false;
    return true;
}

const Row* row_of(const JsonTable& table, const std::map<std::string, std::string>& conditions)
{
    if (conditions.empty()) return &table.facts;
    for (const Row& row : table.rows)
        if (has_texts(row, conditions)) return &row;
    return nullptr;
}

/// A number, or null for what nothing was measured of.
bool is_figure(const JsonCell& cell)
{
    return std::holds_alternative<double>(cell) || std::holds_alternative<std::monostate>(cell);
}

std::string figure_text(const JsonCell& cell, double factor, const std::string& format)
{
    const double* number = std::get_if<double>(&cell);
    return number ? fmt::format(fmt::runtime("{:" + format + "}"), *number * factor) : "-";
}

}  // namespace

std::string fill_figures(const std::string& text, const std::string& page, const std::filesystem::path& report)
{
    std::map<std::string, JsonTable> tables;
    std::string filled;
    std::size_t done = 0;
    for (std::sregex_iterator match(text.begin(), text.end(), kFigure), end; match != end; ++match) {
        const std::smatch& figure = *match;
        const std::string place = figure.str().substr(0, figure.str().find("-->"));
        const std::string rows = figure[2].matched ? figure[2].str() : "rows";
        const std::string key = figure[1].str() + '.' + rows;
        if (!tables.contains(key)) tables[key] = read_json_table(report / (figure[1].str() + ".json"), rows);
        const Row* row = row_of(tables.at(key), conditions_in(figure[3]));
        const auto cell = row == nullptr ? Row::const_iterator() : row->find(figure[4]);
        if (row == nullptr || cell == row->end() || !is_figure(cell->second))
            throw Error({.what = "no such figure: " + place.substr(5), .file = page});
        const double factor = figure[5].matched ? std::stod(figure[5]) : 1.0;
        filled.append(text, done, static_cast<std::size_t>(figure.position()) - done);
        filled += place + "-->" + figure_text(cell->second, factor, figure[6]) + "<!--@-->";
        done = static_cast<std::size_t>(figure.position() + figure.length());
    }
    filled.append(text, done);
    return filled;
}

}  // namespace hw
