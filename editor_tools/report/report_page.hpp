#pragma once

#include <string>
#include <vector>

#include "hatchway/io/json/table.hpp"
#include "report/report_plan.hpp"

namespace hw {

/// What was measured where.
struct ReportOrigin {
    std::string version;
    std::string commit;
    std::string processor;
    int threads = 1;
    std::string date;
};

/// One section with its rows, or why it has none.
struct MeasuredSection {
    ReportSection section;
    JsonTable table;
    std::string failure;
};

/// The figure of a recipe; without series when no row has both columns.
struct Plot plot_of(const PlotRecipe& recipe, const JsonTable& table);

/// One HTML page: figures, tables, and the command of each section. Needs nothing beside it.
std::string report_page(const ReportOrigin& origin, const std::vector<MeasuredSection>& sections);

}  // namespace hw
