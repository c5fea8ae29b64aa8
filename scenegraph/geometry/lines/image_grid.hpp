#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <span>
#include <vector>

#include "hatchway/geometry/lines/image_space.hpp"

namespace hw {

/// A box in the picture, pixels.
struct ImageBox {
    double left, right, top, bottom;
};

/// Square cells over the picture, each with the numbers of what may touch it. Only cells that were marked beforehand
/// take anything: a drawing asks where its lines are, and that is a small part of a picture.
class ImageGrid {
 public:
    ImageGrid(glm::dvec2 size_px, double cell_px);

    /// Marks the cells that a segment may touch, and how far away it is there. Before end_marks().
    void mark(const ImagePoint& from, const ImagePoint& to);
    void end_marks();
    /// Whether a box may touch a marked cell, after end_marks().
    bool has_marks(const ImageBox& box) const;

    /// Calls `visit(cell)` for the cells that a segment may touch, row by row; nothing outside of the picture.
    template <typename Visit>
    void for_each_cell(const ImagePoint& from, const ImagePoint& to, Visit&& visit) const;

    /// Puts items into marked cells whose segments are not all nearer: `cells_of(item, visit)` calls
    /// `visit(cell, nearest)` for the cells of each and how near it comes. Twice called for each item.
    template <typename CellsOf>
    void fill(std::uint32_t item_count, CellsOf&& cells_of);

    /// Calls `visit(cell)` for the cells that a triangle may touch.
    template <typename Visit>
    void for_each_cell(const ImageTriangle& triangle, Visit&& visit) const;

    /// The cell of a point of the picture; the closest cell of a point outside.
    std::uint32_t cell_at(double x, double y) const { return row(y) * columns_ + column(x); }
    std::span<const std::uint32_t> items(std::uint32_t cell) const
    {
        return {items_.data() + begin_[cell], items_.data() + begin_[cell + 1]};
    }

 private:
    static constexpr double kSlackPx = 1e-6;
    static constexpr double kDepthSlack = 2e-6;  ///< Relative: more than rounds of floats and ties of contours.

    std::uint32_t column(double x) const { return place(x, columns_); }
    std::uint32_t row(double y) const { return place(y, rows_); }
    /// Whatever is below 0 is in the first cell: conversion to whole numbers rounds toward it.
    std::uint32_t place(double at, std::uint32_t count) const
    {
        return static_cast<std::uint32_t>(std::clamp(at * cells_per_px_, 0.0, static_cast<double>(count - 1)));
    }
    /// Large, and nothing comes so near, where there is no mark.
    static constexpr float kNoMark = std::numeric_limits<float>::infinity();

    glm::dvec2 size_px_;
    double cell_px_;
    double cells_per_px_;
    std::uint32_t columns_;
    std::uint32_t rows_;
    std::vector<float> marks_;              ///< z of the farthest point of a segment, or kNoMark.
    std::vector<std::uint32_t> mark_sums_;  ///< Marked cells above and left of a cell's corner, a row and column more.
    std::vector<std::uint32_t> begin_;
    std::vector<std::uint32_t> items_;
};

inline ImageGrid::ImageGrid(glm::dvec2 size_px, double cell_px)
    : size_px_(size_px),
      cell_px_(cell_px),
      cells_per_px_(1.0 / cell_px),
      columns_(static_cast<std::uint32_t>(std::ceil(size_px.x / cell_px))),
      rows_(static_cast<std::uint32_t>(std::ceil(size_px.y / cell_px))),
      marks_(std::size_t{columns_} * rows_, kNoMark)
{
}

inline void ImageGrid::mark(const ImagePoint& from, const ImagePoint& to)
{
    const auto farthest = static_cast<float>(std::min(from.z, to.z) * (1.0 - kDepthSlack));
    for_each_cell(from, to, [&](std::uint32_t cell) { marks_[cell] = std::min(marks_[cell], farthest); });
}

inline void ImageGrid::end_marks()
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

inline bool ImageGrid::has_marks(const ImageBox& box) const
{
    if (box.bottom < -kSlackPx || box.top > size_px_.y + kSlackPx) return false;
    if (box.right < -kSlackPx || box.left > size_px_.x + kSlackPx) return false;
    const std::size_t stride = columns_ + 1;
    const std::uint32_t* const above = &mark_sums_[row(box.top - kSlackPx) * stride];
    const std::uint32_t* const below = &mark_sums_[(row(box.bottom + kSlackPx) + 1) * stride];
    const std::uint32_t left = column(box.left - kSlackPx), right = column(box.right + kSlackPx) + 1;
    return below[right] - below[left] != above[right] - above[left];
}

template <typename Visit>
void ImageGrid::for_each_cell(const ImagePoint& from, const ImagePoint& to, Visit&& visit) const
{
    const double low = std::min(from.y, to.y) - kSlackPx, high = std::max(from.y, to.y) + kSlackPx;
    const double left = std::min(from.x, to.x) - kSlackPx, right = std::max(from.x, to.x) + kSlackPx;
    if (high < 0.0 || low > size_px_.y || right < 0.0 || left > size_px_.x) return;
    const double slope = to.y == from.y ? 0.0 : (to.x - from.x) / (to.y - from.y);
    const bool is_level = std::abs(to.y - from.y) < kSlackPx;
    for (std::uint32_t r = row(low); r <= row(high); ++r) {
        double row_left = left, row_right = right;
        if (!is_level) {
            const double top = from.x + slope * (r * cell_px_ - kSlackPx - from.y);
            const double bottom = from.x + slope * ((r + 1) * cell_px_ + kSlackPx - from.y);
            row_left = std::max(left, std::min(top, bottom) - kSlackPx);
            row_right = std::min(right, std::max(top, bottom) + kSlackPx);
        }
        if (row_right < 0.0 || row_left > size_px_.x || row_left > row_right) continue;
        for (std::uint32_t c = column(row_left); c <= column(row_right); ++c) visit(r * columns_ + c);
    }
}

template <typename Visit>
void ImageGrid::for_each_cell(const ImageTriangle& triangle, Visit&& visit) const
{
    const auto& [a, b, c] = triangle.corners;
    const double low = std::min({a.y, b.y, c.y}) - kSlackPx, high = std::max({a.y, b.y, c.y}) + kSlackPx;
    const double left = std::min({a.x, b.x, c.x}) - kSlackPx, right = std::max({a.x, b.x, c.x}) + kSlackPx;
    if (high < 0.0 || low > size_px_.y || right < 0.0 || left > size_px_.x) return;
    const std::uint32_t first_row = row(low), last_row = row(high);
    const std::uint32_t first_column = column(left), last_column = column(right);
    for (std::uint32_t r = first_row; r <= last_row; ++r) {
        double row_left = right, row_right = left;
        const double top = r * cell_px_ - kSlackPx, bottom = (r + 1) * cell_px_ + kSlackPx;
        for (int side = 0; side < 3 && first_column < last_column; ++side) {
            const ImagePoint& p = triangle.corners[side];
            const ImagePoint& q = triangle.corners[(side + 1) % 3];
            if (std::max(p.y, q.y) < top || std::min(p.y, q.y) > bottom) continue;
            const double slope = p.y == q.y ? 0.0 : (q.x - p.x) / (q.y - p.y);
            const double at_top = std::clamp(p.x + slope * (top - p.y), std::min(p.x, q.x), std::max(p.x, q.x));
            const double at_bottom = std::clamp(p.x + slope * (bottom - p.y), std::min(p.x, q.x), std::max(p.x, q.x));
            const bool is_level = std::abs(p.y - q.y) < kSlackPx;
            row_left = std::min(row_left, is_level ? std::min(p.x, q.x) : std::min(at_top, at_bottom));
            row_right = std::max(row_right, is_level ? std::max(p.x, q.x) : std::max(at_top, at_bottom));
        }
        const std::uint32_t begin = first_column < last_column ? column(row_left - kSlackPx) : first_column;
        const std::uint32_t end = first_column < last_column ? column(row_right + kSlackPx) : last_column;
        for (std::uint32_t cell = begin; cell <= end; ++cell) visit(r * columns_ + cell);
    }
}

template <typename CellsOf>
void ImageGrid::fill(std::uint32_t item_count, CellsOf&& cells_of)
{
    begin_.assign(std::size_t{columns_} * rows_ + 1, 0);
    for (std::uint32_t item = 0; item < item_count; ++item) {
        cells_of(item, [&](std::uint32_t cell, float nearest) { begin_[cell + 1] += nearest >= marks_[cell]; });
    }
    for (std::size_t cell = 1; cell < begin_.size(); ++cell) begin_[cell] += begin_[cell - 1];
    items_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t item = 0; item < item_count; ++item) {
        cells_of(item, [&](std::uint32_t cell, float nearest) {
            if (nearest >= marks_[cell]) items_[next[cell]++] = item;
        });
    }
}

}  // namespace hw
