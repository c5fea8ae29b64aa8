#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/report_plan.hpp"

namespace hw {

/// The sections of the report on silhouettes: of `models`, the first of which is the prism; of random views; of one
/// shape, ever finer; and, where `data` has them, of meshes that are known to be hard.
std::vector<ReportSection> silhouette_sections(const std::vector<std::string>& models,
                                               const std::filesystem::path& data);

}  // namespace hw
