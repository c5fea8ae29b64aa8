#include "hatchway/io/json/table.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/io/json/text.hpp"

namespace hw {
namespace {

using nlohmann::ordered_json;

void add_cells(const ordered_json& object, const std::string& prefix, std::map<std::string, JsonCell>& cells,
               std::vector<std::string>* columns)
{
    for (const auto& [key, value] : object.items()) {
        const std::string name = prefix + key;
        if (value.is_object()) add_cells(value, name + '.', cells, columns);
        if (value.is_structured()) continue;
        if (columns && std::find(columns->begin(), columns->end(), name) == columns->end()) columns->push_back(name);
        JsonCell& cell = cells[name];
        if (value.is_boolean()) cell = value.get<bool>();
        if (value.is_number()) cell = value.get<double>();
        if (value.is_string()) cell = value.get<std::string>();
    }
}

}  // namespace

JsonTable read_json_table(const std::filesystem::path& file, const std::string& rows)
{
    const std::string text = read_text_file(file, limits::kMaxFileBytes);
    parse_json(text, file.string(), JsonComments::refused);  // refuses what is no JSON, or nested too deep to copy
    const ordered_json json = ordered_json::parse(text);
    if (!json.is_object() || !json.contains(rows) || !json[rows].is_array())
        throw Error({.what = "is no measured result",
                     .file = file.string(),
                     .expected = "an object with a list \"" + rows + "\""});
    JsonTable table;
    add_cells(json, "", table.facts, nullptr);
    for (const ordered_json& row : json[rows]) {
        table.rows.emplace_back();
        if (row.is_object()) add_cells(row, "", table.rows.back(), &table.columns);
    }
    return table;
}

double number_in(const std::map<std::string, JsonCell>& row, const std::string& column, double missing)
{
    const auto found = row.find(column);
    const double* value = found == row.end() ? nullptr : std::get_if<double>(&found->second);
    return value ? *value : missing;
}

std::string text_in(const std::map<std::string, JsonCell>& row, const std::string& column)
{
    const auto found = row.find(column);
    if (found == row.end()) return "-";
    if (const bool* flag = std::get_if<bool>(&found->second)) return *flag ? "yes" : "no";
    if (const double* number = std::get_if<double>(&found->second))
        return *number == static_cast<double>(static_cast<std::int64_t>(*number)) && std::abs(*number) < 1e9
                   ? fmt::format("{}", static_cast<std::int64_t>(*number))
                   : fmt::format("{:.4g}", *number);
    const std::string* text = std::get_if<std::string>(&found->second);
    return text ? *text : "-";
}

}  // namespace hw
