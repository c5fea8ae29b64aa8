#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <span>
#include <vector>

#include "hatchway/geometry/lines/image_space.hpp"
#include "hatchway/geometry/lines/line_work.hpp"

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
    void for_each_cell(const ImagePoint& from, const ImagePoint& to, Visit&& visit) const
    {
        const SegmentExtent extent = extent_of(from, to);
        visit_rows(
            extent.box, [&](std::uint32_t row) { return cells_of(extent, row); }, visit);
    }

    /// The same for the cells that a triangle may touch.
    template <typename Visit>
    void for_each_cell(const ImageTriangle& triangle, Visit&& visit) const
    {
        const ImageBox box = box_around(triangle);
        visit_rows(
            box, [&](std::uint32_t row) { return cells_of(triangle, box, row); }, visit);
    }

    /// Puts items into marked cells whose segments are not all nearer: `cells_of(item, visit)` calls
    /// `visit(cell, nearest)` for the cells of each and how near it comes. Twice called for each item.
    template <typename CellsOf>
    void fill(std::uint32_t item_count, LineWork& work, CellsOf&& cells_of)
    {
        constexpr std::uint64_t kStepsOfPlace = 8;  // an item in a cell takes memory, too
        begin_.assign(std::size_t{columns_} * rows_ + 1, 0);
        for (std::uint32_t item = 0; item < item_count; ++item) {
            std::uint64_t looked_at = 0, placed = 0;
            cells_of(item, [&](std::uint32_t cell, float nearest) {
                const bool is_placed = nearest >= marks_[cell];
                begin_[cell + 1] += is_placed;
                placed += is_placed;
                ++looked_at;
            });
            work.spend(looked_at + kStepsOfPlace * placed);
        }
        for (std::size_t cell = 1; cell < begin_.size(); ++cell) begin_[cell] += begin_[cell - 1];
        items_.resize(begin_.back());
        std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
        for (std::uint32_t item = 0; item < item_count; ++item)
            cells_of(item, [&](std::uint32_t cell, float nearest) {
                if (nearest >= marks_[cell]) items_[next[cell]++] = item;
            });
    }

    /// The cell of a point of the picture; the closest cell of a point outside.
    std::uint32_t cell_at(double x, double y) const { return row(y) * columns_ + column(x); }
    std::span<const std::uint32_t> items(std::uint32_t cell) const
    {
        return {items_.data() + begin_[cell], items_.data() + begin_[cell + 1]};
    }

 private:
    /// Columns of one row, the last one included; none when `first` is past `last`.
    struct CellRun {
        std::uint32_t first = 1;
        std::uint32_t last = 0;
    };
    struct SegmentExtent {
        ImagePoint from;
        ImageBox box;
        double slope;  ///< Of x over y; 0 for a level segment.
        bool is_level;
    };
    static SegmentExtent extent_of(const ImagePoint& from, const ImagePoint& to);
    static ImageBox box_around(const ImageTriangle& triangle);
    CellRun cells_of(const SegmentExtent& extent, std::uint32_t row) const;
    CellRun cells_of(const ImageTriangle& triangle, const ImageBox& box, std::uint32_t row) const;

    template <typename RunOfRow, typename Visit>
    void visit_rows(const ImageBox& box, RunOfRow&& run_of, Visit&& visit) const
    {
        if (box.bottom < 0.0 || box.top > size_px_.y || box.right < 0.0 || box.left > size_px_.x) return;
        const std::uint32_t last_row = row(box.bottom);
        for (std::uint32_t r = row(box.top); r <= last_row; ++r) {
            const CellRun run = run_of(r);
            for (std::uint32_t c = run.first; c <= run.last; ++c) visit(r * columns_ + c);
        }
    }

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

}  // namespace hw
