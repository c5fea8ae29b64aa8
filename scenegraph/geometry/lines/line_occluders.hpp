#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

#include "hatchway/geometry/lines/image_grid.hpp"
#include "hatchway/geometry/lines/image_space.hpp"
#include "hatchway/geometry/lines/line_gather.hpp"

namespace hw {

/// What a line has to touch to be changed by something: its box in the picture and how near it comes. Rounded outward.
struct ImageBounds {
    float left, right, top, bottom, nearest;

    static ImageBounds of(std::initializer_list<ImagePoint> points)
    {
        ImagePoint low = *points.begin(), high = low;
        for (const ImagePoint& p : points) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        return {below(low.x), above(high.x), below(low.y), above(high.y), above(high.z)};
    }
    /// Whether something with these bounds can be before a part of a line with those of `line`, farthest at `line_z`.
    bool can_change(const ImageBounds& line, float line_z) const
    {
        return nearest >= line_z && left <= line.right && right >= line.left && top <= line.bottom &&
               bottom >= line.top;
    }
    bool has(double x, double y) const { return left <= x && x <= right && top <= y && y <= bottom; }

    static float below(double x) { return std::nextafterf(static_cast<float>(x), -std::numeric_limits<float>::max()); }
    static float above(double x) { return std::nextafterf(static_cast<float>(x), std::numeric_limits<float>::max()); }
};

/// What a line has already met: large things lie in many cells along it.
class SeenItems {
 public:
    void begin_line(std::size_t item_count)
    {
        if (stamps_.size() < item_count) stamps_.resize(item_count, 0);
        ++line_;
    }
    /// True for the first time of each item since begin_line().
    bool is_first(std::uint32_t item) { return std::exchange(stamps_[item], line_) != line_; }

 private:
    std::vector<std::uint32_t> stamps_;
    std::uint32_t line_ = 0;
};

/// The faces of a drawing as what its lines can be hidden by.
///
/// Within a component of an object it is decided exactly for the object's float positions and the eye in its space: a
/// face hides what is strictly behind its plane, so that a face's double, its back and what lies in its plane hide
/// nothing of it. Components and objects are set on each other by numbers that were rounded: there a face hides what
/// lies behind its plane by more than kContactShare of their size, and by over 2e-7 of the eye's distance from it, so
/// that the foot of a wall is not lost by chance in the floor on which it stands. So it is at lines beside needles.
class LineOccluders {
 public:
    /// All must outlive this. What is looked at is spent of `work`.
    LineOccluders(const LineDrawing& drawing, const ImageSpace& space, LineWork& work);

    void fill();

    /// Whether a face that is not one of the line's own lies before a point of the line.
    bool is_hidden(const ImagePoint& point, const DrawnLine& line) const;

    /// The common case of large faces: both ends are behind one face, and so is all between.
    bool is_behind_one_face(const ImagePoint& from, const ImagePoint& to, const DrawnLine& line) const;

    /// Appends where the line goes through faces: shares of its length in the picture. `seen` is of all lines of one
    /// thread.
    void cut(const ImageLine& line, const ImageBounds& bounds, float farthest, SeenItems& seen,
             std::vector<double>& cuts) const;

 private:
    void select_faces();
    bool hides(const ImageTriangle& triangle, const ImagePoint& point, const DrawnLine& line) const;
    bool is_other(const ImageTriangle& triangle, const DrawnLine& line) const;
    bool do_touch(const ImageTriangle& triangle, const ImagePoint& point, const DrawnLine& line) const;
    bool hides_in_doubt(const ImageTriangle& triangle, const DrawnLine& line, double before) const;

    const LineDrawing& drawing_;
    const ImageSpace& space_;
    LineWork& work_;
    double place_error_px_;
    ImageGrid grid_;
    /// Faces that lines pass over in the picture.
    std::vector<ImageTriangle> triangles_;
    std::vector<ImageBounds> bounds_;
};

}  // namespace hw
