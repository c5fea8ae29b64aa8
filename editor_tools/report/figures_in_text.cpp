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
    R"re(<!--@(\w+)(?:\.(\w+))?((?: [^:>]*)?): (max |min )?(\w[\w.]*)(?: x([\d.]+))? (\.\d+f)-->[^<]*<!--@-->)re");

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

/// A number, or null for what nothing was measured of; no pointer to anything else.
const JsonCell* figure_in(const Row& row, const std::string& column)
{
    const auto cell = row.find(column);
    const bool is_figure = cell != row.end() && (std::holds_alternative<double>(cell->second) ||
                                                 std::holds_alternative<std::monostate>(cell->second));
    return is_figure ? &cell->second : nullptr;
}

/// Which of the rows that have the texts: the first, or the one with the most or the least.
enum class Choice { first, most, least };

/// Null where there is none.
const JsonCell* figure_of(const JsonTable& table, const std::map<std::string, std::string>& conditions,
                          const std::string& column, Choice choice)
{
    if (conditions.empty() && choice == Choice::first) return figure_in(table.facts, column);
    const JsonCell* found = nullptr;
    for (const Row& row : table.rows) {
        if (!has_texts(row, conditions)) continue;
        const JsonCell* figure = figure_in(row, column);
        if (choice == Choice::first) return figure;
        const double* number = figure == nullptr ? nullptr : std::get_if<double>(figure);
        const double* best = found == nullptr ? nullptr : std::get_if<double>(found);
        const bool is_better =
            number != nullptr && (best == nullptr || (choice == Choice::most ? *number > *best : *number < *best));
        if (found == nullptr || is_better) found = figure;
    }
    return found;
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
        const Choice choice = !figure[4].matched ? Choice::first : figure[4] == "max " ? Choice::most : Choice::least;
        const JsonCell* cell = figure_of(tables.at(key), conditions_in(figure[3]), figure[5], choice);
        if (cell == nullptr) throw Error({.what = "no such figure: " + place.substr(5), .file = page});
        const double factor = figure[6].matched ? std::stod(figure[6]) : 1.0;
        filled.append(text, done, static_cast<std::size_t>(figure.position()) - done);
        filled += place + "-->" + figure_text(*cell, factor, figure[7]) + "<!--@-->";
        done = static_cast<std::size_t>(figure.position() + figure.length());
    }
    filled.append(text, done);
    return filled;
}

}  // namespace hw
