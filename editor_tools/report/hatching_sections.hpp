#pragma once

#include "report/report_plan.hpp"

namespace hw {

// The sections of the report on hatching: hatch maps, ink maps (`maps`: a folder of them), and both from frame to frame
// along the tour of a level.

ReportSection hatch_section();
ReportSection ink_section(const std::filesystem::path& maps);
ReportSection coherence_section(const std::string& level);

}  // namespace hw
