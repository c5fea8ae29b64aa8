// Every wanted line is walked in steps of half a pixel. A width is measured as the ink on the cross-section there,
// where an ideal drawing of all wanted lines says that no other line comes near.
#include "measure/lines/line_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

namespace hw {
namespace {

constexpr double kStepPx = 0.5;
constexpr double kFaintestPx = 0.25;  // what is thinner leaves too little ink to be missed
constexpr float kLeastInk = 0.1f;     // less is paper
constexpr double kMissedReachPx = 1.0;
constexpr double kLeakReachPx = 1.0;   // beyond half the width
constexpr double kCrossReachPx = 1.5;  // beyond half the width: what is counted as this line's own ink
constexpr double kAlonePx = 3.5;       // beyond half the width: no other line up to here
constexpr double kCrossStepPx = 0.125;

struct Segment {
    glm::dvec2 from;
    glm::dvec2 to;
};

double distance_to(const Segment& s, const glm::dvec2& p)
{
    const glm::dvec2 along = s.to - s.from;
    const double squared = glm::dot(along, along);
    const double t = squared > 0.0 ? std::clamp(glm::dot(p - s.from, along) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(p, s.from + t * along);
}

/// Calls `use(x, y)` for the pixels whose centre is within `reach` of the box of a segment.
void for_each_pixel(const Segment& s, double reach, const InkImage& image, const std::function<void(int, int)>& use)
{
    const glm::dvec2 low = glm::min(s.from, s.to) - reach, high = glm::max(s.from, s.to) + reach;
    const int x0 = std::max(0, static_cast<int>(std::floor(low.x))),
              y0 = std::max(0, static_cast<int>(std::floor(low.y)));
    const int x1 = std::min(image.width - 1, static_cast<int>(high.x));
    const int y1 = std::min(image.height - 1, static_cast<int>(high.y));
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) use(x, y);
}

/// Long segments are cut, so that their boxes stay near them.
template <typename Use>
void for_each_short_segment(const WantedLine& line, Use&& use)
{
    constexpr double kLongestPx = 16.0;
    for (std::size_t i = 0; i + 1 < line.points_px.size(); ++i) {
        const glm::dvec2 a = line.points_px[i], b = line.points_px[i + 1];
        const int count = 1 + static_cast<int>(glm::distance(a, b) / kLongestPx);
        for (int k = 0; k < count; ++k)
            use(Segment{glm::mix(a, b, static_cast<double>(k) / count), glm::mix(a, b, (k + 1.0) / count)});
    }
}

float bilinear(const InkImage& image, const glm::dvec2& at)
{
    const double x = at.x - 0.5, y = at.y - 0.5;
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    if (x0 < 0 || y0 < 0 || x0 + 1 >= image.width || y0 + 1 >= image.height) return 0.0f;
    const float u = static_cast<float>(x - x0), v = static_cast<float>(y - y0);
    return (1 - v) * ((1 - u) * image.at(x0, y0) + u * image.at(x0 + 1, y0)) +
           v * ((1 - u) * image.at(x0, y0 + 1) + u * image.at(x0 + 1, y0 + 1));
}

bool has_ink_near(const InkImage& drawing, const glm::dvec2& p)
{
    const int x0 = static_cast<int>(std::floor(p.x - kMissedReachPx)), x1 = static_cast<int>(p.x + kMissedReachPx);
    const int y0 = static_cast<int>(std::floor(p.y - kMissedReachPx)), y1 = static_cast<int>(p.y + kMissedReachPx);
    for (int y = std::max(y0, 0); y <= std::min(y1, drawing.height - 1); ++y)
        for (int x = std::max(x0, 0); x <= std::min(x1, drawing.width - 1); ++x)
            if (drawing.at(x, y) >= kLeastInk && glm::distance(p, glm::dvec2(x + 0.5, y + 0.5)) <= kMissedReachPx)
                return true;
    return false;
}

/// What an ideal pen leaves: coverage by distance, the darkest of all lines.
InkImage ideal_drawing(const InkImage& size, std::span<const WantedLine> wanted)
{
    InkImage ideal{size.width, size.height, std::vector<float>(size.ink.size(), 0.0f)};
    for (const WantedLine& line : wanted) {
        const double half = 0.5 * line.width_px;
        for_each_short_segment(line, [&](const Segment& s) {
            for_each_pixel(s, half + 1.0, ideal, [&](int x, int y) {
                const double d = distance_to(s, {x + 0.5, y + 0.5});
                float& ink = ideal.at(x, y);
                ink = std::max(ink, static_cast<float>(std::clamp(half + 0.5 - d, 0.0, 1.0)));
            });
        });
    }
    return ideal;
}

/// Pixels that are within half a width + 1 px of a wanted line.
std::vector<unsigned char> allowed_pixels(const InkImage& size, std::span<const WantedLine> wanted)
{
    std::vector<unsigned char> allowed(size.ink.size(), 0);
    for (const WantedLine& line : wanted) {
        const double reach = 0.5 * line.width_px + kLeakReachPx;
        for_each_short_segment(line, [&](const Segment& s) {
            for_each_pixel(s, reach, size, [&](int x, int y) {
                if (distance_to(s, {x + 0.5, y + 0.5}) <= reach)
                    allowed[static_cast<std::size_t>(y) * size.width + x] = 1;
            });
        });
    }
    return allowed;
}

class Judge {
 public:
    Judge(const InkImage& drawing, std::span<const WantedLine> wanted, std::vector<unsigned char>* shown)
        : drawing_(drawing), wanted_(wanted), ideal_(ideal_drawing(drawing, wanted)), shown_(shown)
    {
        if (shown_ != nullptr) shown_->assign(drawing.ink.size(), 0);
    }

    LineError run()
    {
        const std::vector<unsigned char> allowed = allowed_pixels(drawing_, wanted_);
        for (std::size_t i = 0; i < allowed.size(); ++i) {
            const float ink = drawing_.ink[i];
            error_.ink_px += ink;
            if (allowed[i] != 0) continue;
            error_.leaked_px += ink;
            if (shown_ != nullptr && ink >= kLeastInk) (*shown_)[i] = 1;
        }
        for (const WantedLine& line : wanted_)
            if (line.width_px >= kFaintestPx) walk(line);
        return std::move(error_);
    }

 private:
    void walk(const WantedLine& line)
    {
        bool had_ink = false, is_in_gap = false;
        for (std::size_t i = 0; i + 1 < line.points_px.size(); ++i) {
            const glm::dvec2 a = line.points_px[i], b = line.points_px[i + 1];
            const double length = glm::distance(a, b);
            const int count = std::max(1, static_cast<int>(std::ceil(length / kStepPx)));
            for (int k = 0; k < count; ++k) {
                const glm::dvec2 p = glm::mix(a, b, (k + 0.5) / count);
                if (p.x < 0.0 || p.y < 0.0 || p.x >= drawing_.width || p.y >= drawing_.height) continue;
                const bool is_missed = !has_ink_near(drawing_, p);
                error_.wanted_px += length / count;
                if (is_missed) {
                    error_.missed_px += length / count;
                    show_missed(p);
                }
                if (!is_missed && is_in_gap) ++error_.gaps;
                is_in_gap = is_missed && (had_ink || is_in_gap);
                had_ink = !is_missed;
                if (length > 0.0) measure_width(line, p, (b - a) / length);
            }
        }
    }

    void show_missed(const glm::dvec2& p)
    {
        if (shown_ != nullptr)
            (*shown_)[static_cast<std::size_t>(p.y) * drawing_.width + static_cast<std::size_t>(p.x)] = 2;
    }

    void measure_width(const WantedLine& line, const glm::dvec2& p, const glm::dvec2& along)
    {
        const glm::dvec2 across(-along.y, along.x);
        const double half = 0.5 * line.width_px, own = half + kCrossReachPx;
        const glm::dvec2 size(drawing_.width, drawing_.height);
        for (const double side : {-1.0, 1.0}) {
            const glm::dvec2 end = p + side * (half + kAlonePx) * across;
            if (end.x < 1.0 || end.y < 1.0 || end.x > size.x - 1.0 || end.y > size.y - 1.0) return;
            for (double d = own; d <= half + kAlonePx; d += 0.5)
                if (bilinear(ideal_, p + side * d * across) > 0.0f) return;
        }
        // At an end the cross-section is half a round: the ideal says so.
        double ink = 0.0, whole = 0.0;
        for (double d = -own; d <= own; d += kCrossStepPx) {
            ink += bilinear(drawing_, p + d * across) * kCrossStepPx;
            whole += bilinear(ideal_, p + d * across) * kCrossStepPx;
        }
        if (std::abs(whole - line.width_px) > 0.15 * line.width_px + 0.05) return;
        error_.width_ratios.push_back(static_cast<float>(ink / line.width_px));
    }

    const InkImage& drawing_;
    std::span<const WantedLine> wanted_;
    InkImage ideal_;
    std::vector<unsigned char>* shown_;
    LineError error_;
};

}  // namespace

InkImage ink_of(const Pixels& picture)
{
    std::array<float, 256> linear;
    for (int i = 0; i < 256; ++i) {
        const double c = i / 255.0;
        linear[i] = static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
    }
    InkImage image{picture.width, picture.height, {}};
    image.ink.reserve(static_cast<std::size_t>(picture.width) * picture.height);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const std::uint8_t* rgb = picture.at(x, y);
            image.ink.push_back(1.0f -
                                (0.2126f * linear[rgb[0]] + 0.7152f * linear[rgb[1]] + 0.0722f * linear[rgb[2]]));
        }
    return image;
}

double ink_share(const InkImage& image)
{
    double sum = 0.0;
    for (const float ink : image.ink) sum += ink;
    return image.ink.empty() ? 0.0 : sum / static_cast<double>(image.ink.size());
}

double LineError::width_quantile(double share) const
{
    if (width_ratios.empty()) return measure::kNoValue;
    std::vector<float> sorted = width_ratios;
    const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1) + 0.5);
    std::nth_element(sorted.begin(), at, sorted.end());
    return *at;
}

void LineError::add(const LineError& other)
{
    wanted_px += other.wanted_px;
    missed_px += other.missed_px;
    ink_px += other.ink_px;
    leaked_px += other.leaked_px;
    gaps += other.gaps;
    width_ratios.insert(width_ratios.end(), other.width_ratios.begin(), other.width_ratios.end());
}

LineError line_error(const InkImage& drawing, std::span<const WantedLine> wanted,
                     std::vector<unsigned char>* pixels_to_show)
{
    return Judge(drawing, wanted, pixels_to_show).run();
}

}  // namespace hw
