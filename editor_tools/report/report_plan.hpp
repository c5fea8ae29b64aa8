#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hw {

/// How one figure is made from the rows of a measurement.
struct PlotRecipe {
    std::string title;
    std::string x_column;
    std::string x_label;
    std::string y_column;  ///< Several joined by '+': their sum.
    std::string y_label;
    std::vector<std::string> series_columns;  ///< Rows with equal cells in these are one series.
    bool is_joined = false;
    std::string list = "rows";  ///< Of the JSON, whose elements are the points; one of `more` if not the rows.
    std::string per_column;     ///< One figure for each value of this; empty: one for all.
};

/// One measurement of the report: a command line after `hatchway measure`, and what is shown of its rows. Without
/// arguments something else makes its file, and the section is shown where that is there.
struct ReportSection {
    std::string name;  ///< Of the JSON file, without ending.
    std::string title;
    std::string judge;       ///< What the result is compared with, and what that shares with the engine.
    std::string leaves_out;  ///< What the section does not show.
    std::string says;        ///< What is measured against what, in one or two sentences.
    std::vector<std::string> arguments;
    std::vector<std::string> more = {};  ///< Lists of the JSON that are shown beside its rows.
    std::vector<PlotRecipe> plots;
};

/// All sections: the measurements that are made with what the project itself brings (`content`, its folder), and, when
/// `data` is not empty, with the models and scenes found in that folder, too; then those that are made elsewhere.
std::vector<ReportSection> report_plan(const std::filesystem::path& content, const std::filesystem::path& data);

}  // namespace hw
