#pragma once

#include "report/report_plan.hpp"

namespace hw {

/// Lines from images. `data` may be empty: then only what the project brings is measured.
std::vector<ReportSection> edge_sections(const std::string& hall, const std::filesystem::path& data);

}  // namespace hw
