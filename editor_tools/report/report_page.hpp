#pragma once

#include <string>
#include <vector>

#include "hatchway/io/json/table.hpp"
#include "report/report_plan.hpp"

namespace hw {

/// One section with its rows, or why it has none.
struct MeasuredSection {
    ReportSection section;
    JsonTable table;
    std::vector<JsonTable> more;  ///< For each name in section.more.
    std::string failure;
};

/// One HTML page: figures, tables, and for each section the commit, machine, day and command that made its rows, as
/// they say themselves. Needs nothing beside it.
std::string report_page(const std::vector<MeasuredSection>& sections);

}  // namespace hw
