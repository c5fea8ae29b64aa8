#pragma once

#include <string>
#include <vector>

namespace hw {

/// Points of one method, joined by a line in the order given when `is_joined`.
struct PlotSeries {
    std::string name;
    std::vector<std::pair<double, double>> points;  ///< x, y; both at least 0.
    bool is_joined = false;
};

/// A plot of two quantities that span decades. Both axes are logarithmic; zero has a band of its own at the edge.
struct Plot {
    std::string title;
    std::string x_label;
    std::string y_label;
    std::vector<PlotSeries> series;
};

/// The plot as an <svg> element, fixed decimals, no scripts. Empty when there are no points.
std::string svg_of(const Plot& plot);

/// Text with &, < and > made safe for HTML and SVG.
std::string escaped(const std::string& text);

}  // namespace hw
