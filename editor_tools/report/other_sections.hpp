#pragma once

#include <vector>

#include "report/report_plan.hpp"

namespace hw {

/// Sections of results that no `hatchway measure` makes: scripts and tests do, for hours or with what not every machine
/// has. The report shows them where their files are, and says what made them.
std::vector<ReportSection> sections_made_elsewhere();

}  // namespace hw
