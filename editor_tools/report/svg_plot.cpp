#include "report/svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hw {
namespace {

constexpr double kWidth = 760.0;
constexpr double kHeight = 420.0;
constexpr double kLeft = 78.0;
constexpr double kRight = 190.0;
constexpr double kTop = 34.0;
constexpr double kBottom = 52.0;
constexpr double kZeroBand = 30.0;  // pixels between the value 0 and the smallest decade
// Colours that stay apart for colour-blind readers (Okabe and Ito).
constexpr std::array<const char*, 8> kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                              "#e69f00", "#56b4e9", "#000000", "#9a8c00"};

/// Maps a value to pixels: whole decades on a logarithmic scale, and 0 beside them.
struct Axis {
    double from_px;
    double to_px;
    int first_decade = 0;
    int last_decade = 1;
    bool has_zero = false;

    double decades_begin_px() const
    {
        return has_zero ? from_px + (to_px > from_px ? kZeroBand : -kZeroBand) : from_px;
    }
    double at(double value) const
    {
        if (value <= 0.0) return from_px;
        const double share = (std::log10(value) - first_decade) / (last_decade - first_decade);
        return decades_begin_px() + share * (to_px - decades_begin_px());
    }
};

template <typename Pick>
Axis axis_over(const Plot& plot, double from_px, double to_px, Pick pick)
{
    Axis axis{from_px, to_px};
    double low = 1e300;
    double high = 0.0;
    for (const PlotSeries& series : plot.series)
        for (const auto& point : series.points) {
            const double value = pick(point);
            if (value > 0.0) low = std::min(low, value);
            high = std::max(high, value);
            axis.has_zero = axis.has_zero || value <= 0.0;
        }
    if (high <= 0.0) low = high = 1.0;
    axis.first_decade = static_cast<int>(std::floor(std::log10(low)));
    axis.last_decade = std::max(static_cast<int>(std::ceil(std::log10(high))), axis.first_decade + 1);
    return axis;
}

std::string label_of_decade(int decade)
{
    return decade >= -3 && decade <= 3 ? fmt::format("{:g}", std::pow(10.0, decade)) : fmt::format("1e{}", decade);
}

std::string text_at(double x, double y, const std::string& anchor, const std::string& text)
{
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, escaped(text));
}

std::string grid_line(double x0, double y0, double x1, double y1)
{
    return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#ddd\"/>\n", x0, y0, x1, y1);
}

std::string axes_of(const Axis& x, const Axis& y)
{
    std::string svg;
    const auto vertical = [&](double px, const std::string& label) {
        svg += grid_line(px, y.from_px, px, y.to_px) + text_at(px, y.from_px + 18.0, "middle", label);
    };
    const auto horizontal = [&](double px, const std::string& label) {
        svg += grid_line(x.from_px, px, x.to_px, px) + text_at(x.from_px - 8.0, px + 4.0, "end", label);
    };
    if (x.has_zero) vertical(x.from_px, "0");
    if (y.has_zero) horizontal(y.from_px, "0");
    for (int decade = x.first_decade; decade <= x.last_decade; ++decade)
        vertical(x.at(std::pow(10.0, decade)), label_of_decade(decade));
    for (int decade = y.first_decade; decade <= y.last_decade; ++decade)
        horizontal(y.at(std::pow(10.0, decade)), label_of_decade(decade));
    return svg;
}

/// The colour and form that tell series `i` from all others of a plot.
std::string mark_at(double x, double y, std::size_t i, double opacity)
{
    static constexpr std::array<const char*, 4> kForms{"M-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0", "M-3.5 -3.5h7v7h-7z",
                                                       "M-4.5 3.5h9L0 -4.5z", "M-5 0L0 -5L5 0L0 5z"};
    return fmt::format("<path transform=\"translate({:.1f} {:.1f})\" d=\"{}\" fill=\"{}\" fill-opacity=\"{}\"/>\n", x,
                       y, kForms[i / kColours.size() % kForms.size()], kColours[i % kColours.size()], opacity);
}

std::string series_of(const PlotSeries& series, const Axis& x, const Axis& y, std::size_t i)
{
    std::string svg;
    std::string path;
    for (const auto& [px, py] : series.points) {
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x.at(px), y.at(py));
        svg += mark_at(x.at(px), y.at(py), i, 0.75);
    }
    if (series.is_joined)
        svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\"/>\n", path, kColours[i % kColours.size()]);
    return svg;
}

}  // namespace

std::string escaped(const std::string& text)
{
    std::string safe;
    for (const char c : text) {
        if (c == '&')
            safe += "&amp;";
        else if (c == '<')
            safe += "&lt;";
        else if (c == '>')
            safe += "&gt;";
        else
            safe += c;
    }
    return safe;
}

std::string svg_of(const Plot& plot)
{
    const bool is_empty = std::all_of(plot.series.begin(), plot.series.end(),
                                      [](const PlotSeries& series) { return series.points.empty(); });
    if (is_empty) return "";
    const Axis x = axis_over(plot, kLeft, kWidth - kRight, [](const auto& point) { return point.first; });
    const Axis y = axis_over(plot, kHeight - kBottom, kTop, [](const auto& point) { return point.second; });
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" font-family=\"sans-serif\" font-size=\"12\">\n",
        kWidth, kHeight);
    svg += text_at(kLeft, 20.0, "start", plot.title) + axes_of(x, y);
    svg += text_at(0.5 * (x.from_px + x.to_px), kHeight - 12.0, "middle", plot.x_label);
    svg += fmt::format("<text transform=\"translate(16 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                       0.5 * (y.from_px + y.to_px), escaped(plot.y_label));
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const double row = kTop + 10.0 + 18.0 * static_cast<double>(i);
        svg += series_of(plot.series[i], x, y, i);
        svg += mark_at(x.to_px + 16.0, row, i, 1.0);
        svg += text_at(x.to_px + 26.0, row + 4.0, "start", plot.series[i].name);
    }
    return svg + "</svg>\n";
}

}  // namespace hw
