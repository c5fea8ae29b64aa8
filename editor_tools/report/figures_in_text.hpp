#pragma once

#include <filesystem>
#include <string>

namespace hw {

/// Writes measured figures into a Markdown page, so that nobody types them. A figure stands between two comments:
///
///     <!--@NAME COLUMN=TEXT COLUMN=TEXT: [max|min] COLUMN [xFACTOR] FORMAT-->figure<!--@-->
///
/// NAME.json in `report` is a result as `hatchway measure ... --json` writes it; "NAME.PART" takes the rows of its
/// array PART instead of "rows". The row is the first whose columns have these texts; without any, the figure is one of
/// the plain members. With "max" or "min" it is the largest or the smallest of that column in all rows that have the
/// texts. FACTOR multiplies it, FORMAT is that of a number, such as ".2f".
///
/// Where the result has null there, since nothing was measured, the figure is a dash.
///
/// Throws hw::Error that names `page` and the figure when there is no such file, row, column or format.
std::string fill_figures(const std::string& text, const std::string& page, const std::filesystem::path& report);

}  // namespace hw
