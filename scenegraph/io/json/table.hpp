#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace hw {

/// A plain value of a result; monostate stands for null.
using JsonCell = std::variant<std::monostate, bool, double, std::string>;

/// A machine-readable result as a table. Members of nested objects are columns "outer.inner"; arrays inside of a row
/// are left out.
struct JsonTable {
    std::map<std::string, JsonCell> facts;              ///< The members beside the rows.
    std::vector<std::string> columns;                   ///< In the order of their first appearance.
    std::vector<std::map<std::string, JsonCell>> rows;  ///< The elements of the list.
};

/// Reads a file as `hatchway measure ... --json` writes it; `rows` names the list that becomes the table's rows. Throws
/// hw::Error when it is no such file.
JsonTable read_json_table(const std::filesystem::path& file, const std::string& rows = "rows");

/// The number in a column, or `missing`.
double number_in(const std::map<std::string, JsonCell>& row, const std::string& column, double missing);

/// The cell as a person reads it: numbers with at most 4 significant digits, "-" for null or no cell.
std::string text_in(const std::map<std::string, JsonCell>& row, const std::string& column);

}  // namespace hw
