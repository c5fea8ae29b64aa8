#include "measure/hatching/ink_level.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "hatchway/maps/stroke_drawing.hpp"

namespace hw {
namespace {

constexpr double kLeastContrast = 0.1;
constexpr double kStrokeShare = 0.3;  // of the contrast, that a texel of a stroke has above the paper

/// A plane seen along x or, turned, along y. Repeats.
class Rows {
 public:
    Rows(const InkPlane& plane, bool is_turned) : plane_(plane), is_turned_(is_turned) {}

    int length() const { return is_turned_ ? plane_.height : plane_.width; }
    int count() const { return is_turned_ ? plane_.width : plane_.height; }
    double at(int x, int y) const
    {
        x = (x % length() + length()) % length();
        y = (y % count() + count()) % count();
        return is_turned_ ? plane_.at(y, x) : plane_.at(x, y);
    }

 private:
    const InkPlane& plane_;
    bool is_turned_;
};

/// Adds the widths of strokes that cross row y rather than run along it: the ink of a run, foreshortened by the angle
/// at which the row cuts it.
void add_widths(std::vector<double>& widths, const Rows& rows, int y, double paper, double threshold)
{
    for (int x = 0; x < rows.length(); ++x) {
        if (rows.at(x, y) < threshold || rows.at(x - 1, y) >= threshold) continue;
        double ink = 0.0;
        double along = 0.0;
        double across = 0.0;
        int last = x;
        while (last < x + rows.length() && rows.at(last, y) >= threshold) ++last;
        for (int i = x - 1; i <= last; ++i) {
            ink += std::max(rows.at(i, y) - paper, 0.0);
            const double dx = rows.at(i + 1, y) - rows.at(i - 1, y);
            const double dy = rows.at(i, y + 1) - rows.at(i, y - 1);
            along += dx * dx;
            across += dy * dy;
        }
        if (along >= across) widths.push_back(ink * std::sqrt(along / (along + across)));
    }
}

}  // namespace

InkLevelFigures ink_level_figures(const Pixels& level)
{
    const InkPlane plane = plane_of(level);
    const auto [least, most] = std::minmax_element(plane.ink.begin(), plane.ink.end());
    InkLevelFigures figures{.tone = mean_ink(plane), .contrast = *most - *least};
    if (figures.contrast < kLeastContrast) return figures;
    std::vector<double> widths;
    for (const bool is_turned : {false, true}) {
        const Rows rows(plane, is_turned);
        for (int y = 0; y < rows.count(); ++y)
            add_widths(widths, rows, y, *least, *least + kStrokeShare * figures.contrast);
    }
    if (widths.empty()) return figures;
    const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
    std::nth_element(widths.begin(), middle, widths.end());
    figures.stroke_texels = *middle;
    return figures;
}

}  // namespace hw
