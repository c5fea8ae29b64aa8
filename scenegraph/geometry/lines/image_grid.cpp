#include "hatchway/geometry/lines/image_grid.hpp"

#include <cmath>

namespace hw {
namespace {

constexpr double kSlackPx = 1e-6;
constexpr double kDepthSlack = 2e-6;  // relative: more than rounds of floats and ties of contours

}  // namespace

ImageGrid::ImageGrid(glm::dvec2 size_px, double cell_px)
    : size_px_(size_px),
      cell_px_(cell_px),
      cells_per_px_(1.0 / cell_px),
      columns_(static_cast<std::uint32_t>(std::ceil(size_px.x / cell_px))),
      rows_(static_cast<std::uint32_t>(std::ceil(size_px.y / cell_px))),
      marks_(std::size_t{columns_} * rows_, kNoMark)
{
}

void ImageGrid::mark(const ImagePoint& from, const ImagePoint& to)
{
    const auto farthest = static_cast<float>(std::min(from.z, to.z) * (1.0 - kDepthSlack));
    for_each_cell(from, to, [&](std::uint32_t cell) { marks_[cell] = std::min(marks_[cell], farthest); });
}

void ImageGrid::end_marks()
{
    const std::size_t stride = columns_ + 1;
    mark_sums_.assign(stride * (rows_ + 1), 0);
    for (std::uint32_t r = 0; r < rows_; ++r) {
        std::uint32_t in_row = 0;
        for (std::uint32_t c = 0; c < columns_; ++c) {
            in_row += marks_[std::size_t{r} * columns_ + c] != kNoMark;
            mark_sums_[(r + 1) * stride + c + 1] = mark_sums_[r * stride + c + 1] + in_row;
        }
    }
}

bool ImageGrid::has_marks(const ImageBox& box) const
{
    if (box.bottom < -kSlackPx || box.top > size_px_.y + kSlackPx) return false;
    if (box.right < -kSlackPx || box.left > size_px_.x + kSlackPx) return false;
    const std::size_t stride = columns_ + 1;
    const std::uint32_t* const above = &mark_sums_[row(box.top - kSlackPx) * stride];
    const std::uint32_t* const below = &mark_sums_[(row(box.bottom + kSlackPx) + 1) * stride];
    const std::uint32_t left = column(box.left - kSlackPx), right = column(box.right + kSlackPx) + 1;
    return below[right] - below[left] != above[right] - above[left];
}

ImageGrid::SegmentExtent ImageGrid::extent_of(const ImagePoint& from, const ImagePoint& to)
{
    return {.from = from,
            .box = {std::min(from.x, to.x) - kSlackPx, std::max(from.x, to.x) + kSlackPx,
                    std::min(from.y, to.y) - kSlackPx, std::max(from.y, to.y) + kSlackPx},
            .slope = to.y == from.y ? 0.0 : (to.x - from.x) / (to.y - from.y),
            .is_level = std::abs(to.y - from.y) < kSlackPx};
}

ImageGrid::CellRun ImageGrid::cells_of(const SegmentExtent& extent, std::uint32_t row) const
{
    const auto& [from, box, slope, is_level] = extent;
    double left = box.left, right = box.right;
    if (!is_level) {
        const double top = from.x + slope * (row * cell_px_ - kSlackPx - from.y);
        const double bottom = from.x + slope * ((row + 1) * cell_px_ + kSlackPx - from.y);
        left = std::max(left, std::min(top, bottom) - kSlackPx);
        right = std::min(right, std::max(top, bottom) + kSlackPx);
    }
    if (right < 0.0 || left > size_px_.x || left > right) return {};
    return {column(left), column(right)};
}

ImageBox ImageGrid::box_around(const ImageTriangle& triangle)
{
    const auto& [a, b, c] = triangle.corners;
    return {std::min({a.x, b.x, c.x}) - kSlackPx, std::max({a.x, b.x, c.x}) + kSlackPx,
            std::min({a.y, b.y, c.y}) - kSlackPx, std::max({a.y, b.y, c.y}) + kSlackPx};
}

ImageGrid::CellRun ImageGrid::cells_of(const ImageTriangle& triangle, const ImageBox& box, std::uint32_t row) const
{
    const CellRun whole{column(box.left), column(box.right)};
    if (whole.first == whole.last) return whole;
    double left = box.right, right = box.left;
    const double top = row * cell_px_ - kSlackPx, bottom = (row + 1) * cell_px_ + kSlackPx;
    for (int side = 0; side < 3; ++side) {
        const ImagePoint& p = triangle.corners[side];
        const ImagePoint& q = triangle.corners[(side + 1) % 3];
        if (std::max(p.y, q.y) < top || std::min(p.y, q.y) > bottom) continue;
        const double slope = p.y == q.y ? 0.0 : (q.x - p.x) / (q.y - p.y);
        const double at_top = std::clamp(p.x + slope * (top - p.y), std::min(p.x, q.x), std::max(p.x, q.x));
        const double at_bottom = std::clamp(p.x + slope * (bottom - p.y), std::min(p.x, q.x), std::max(p.x, q.x));
        const bool is_level = std::abs(p.y - q.y) < kSlackPx;
        left = std::min(left, is_level ? std::min(p.x, q.x) : std::min(at_top, at_bottom));
        right = std::max(right, is_level ? std::max(p.x, q.x) : std::max(at_top, at_bottom));
    }
    return {column(left - kSlackPx), column(right + kSlackPx)};
}

}  // namespace hw
