#include "hatchway/world/visibility/rows/sight_slice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace hw {
namespace {

/// The columns that a convex polygon touches in each row.
class RowSpans {
 public:
    RowSpans(int rows, double first_v, double texel_m) : first_v_(first_v), texel_m_(texel_m)
    {
        least_.assign(static_cast<std::size_t>(rows), std::numeric_limits<double>::infinity());
        most_.assign(static_cast<std::size_t>(rows), -std::numeric_limits<double>::infinity());
    }

    /// A side of the polygon, grown by `margin_m`.
    void add(double u0, double v0, double u1, double v1, double margin_m)
    {
        if (v0 > v1) std::swap(u0, u1), std::swap(v0, v1);
        const int rows = static_cast<int>(least_.size());
        const int from = std::max(0, static_cast<int>(std::floor((v0 - margin_m - first_v_) / texel_m_)));
        const int to = std::min(rows - 1, static_cast<int>(std::floor((v1 + margin_m - first_v_) / texel_m_)));
        const double slope = v1 - v0 > 1e-12 ? (u1 - u0) / (v1 - v0) : 0.0;
        for (int row = from; row <= to; ++row) {
            const double low = std::clamp(first_v_ + row * texel_m_ - margin_m, v0, v1);
            const double high = std::clamp(first_v_ + (row + 1) * texel_m_ + margin_m, v0, v1);
            double a = u0 + slope * (low - v0), b = u0 + slope * (high - v0);
            if (v1 - v0 <= 1e-12) a = u0, b = u1;
            double& least = least_[static_cast<std::size_t>(row)];
            double& most = most_[static_cast<std::size_t>(row)];
            least = std::min({least, a - margin_m, b - margin_m});
            most = std::max({most, a + margin_m, b + margin_m});
        }
    }
    double least(int row) const { return least_[static_cast<std::size_t>(row)]; }
    double most(int row) const { return most_[static_cast<std::size_t>(row)]; }

 private:
    double first_v_;
    double texel_m_;
    std::vector<double> least_, most_;
};

int column_of(const SightSlice& slice, double u)
{
    return static_cast<int>(std::floor((u - slice.first_u) / slice.texel_m));
}

int row_of(const SightSlice& slice, double v)
{
    return static_cast<int>(std::floor((v - slice.first_v) / slice.texel_m));
}

/// Sets the bits of columns [from, to] of a row.
void set_columns(std::vector<std::uint64_t>& bits, const SightSlice& slice, int row, int from, int to)
{
    for (int column = std::max(from, 0); column <= std::min(to, slice.columns - 1); ++column) {
        const std::size_t word = static_cast<std::size_t>(row * slice.words + column / 64);
        bits[word] |= std::uint64_t{1} << (column % 64);
    }
}

/// Whether any of the columns [from, to] of a row is open.
bool any_open(const std::vector<std::uint64_t>& bits, const SightSlice& slice, int row, int from, int to)
{
    const int first_word = from / 64, last_word = to / 64;
    for (int word = first_word; word <= last_word; ++word) {
        std::uint64_t mask = ~std::uint64_t{0};
        if (word == first_word) mask &= ~std::uint64_t{0} << (from % 64);
        if (word == last_word) mask &= ~std::uint64_t{0} >> (63 - to % 64);
        if (bits[static_cast<std::size_t>(row * slice.words + word)] & mask) return true;
    }
    return false;
}

std::array<glm::dvec3, 8> corners_of(const Box& box)
{
    std::array<glm::dvec3, 8> result;
    for (std::size_t i = 0; i < 8; ++i) {
        result[i] = {(i & 1) ? box.max.x : box.min.x, (i & 2) ? box.max.y : box.min.y, (i & 4) ? box.max.z : box.min.z};
    }
    return result;
}

struct FlatPoint {
    double u, v;
};

/// The convex hull, in place; returns its size. Andrew's monotone chain.
std::size_t make_hull(std::array<FlatPoint, 64>& points, std::array<FlatPoint, 130>& hull)
{
    std::sort(points.begin(), points.end(),
              [](const FlatPoint& a, const FlatPoint& b) { return a.u != b.u ? a.u < b.u : a.v < b.v; });
    const auto turns_right = [](const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) {
        return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u) <= 0.0;
    };
    std::size_t count = 0;
    for (const FlatPoint& point : points) {
        while (count >= 2 && turns_right(hull[count - 2], hull[count - 1], point)) --count;
        hull[count++] = point;
    }
    const std::size_t lower = count + 1;
    for (std::size_t i = points.size() - 1; i-- > 0;) {
        while (count >= lower && turns_right(hull[count - 2], hull[count - 1], points[i])) --count;
        hull[count++] = points[i];
    }
    return count;
}

bool is_open_at(const SightSlice& slice, const std::vector<std::uint64_t>& open, double u, double v)
{
    const int column = column_of(slice, u), row = row_of(slice, v);
    if (column < 0 || row < 0 || column >= slice.columns || row >= slice.rows) return true;
    return (open[static_cast<std::size_t>(row * slice.words + column / 64)] >> (column % 64) & 1) != 0;
}

}  // namespace

void open_polygon(SightSlice& slice, std::span<const glm::dvec3> corners, bool forward, bool backward)
{
    RowSpans spans(slice.rows, slice.first_v, slice.texel_m);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        spans.add(glm::dot(a, slice.u), glm::dot(a, slice.v), glm::dot(b, slice.u), glm::dot(b, slice.v), 1e-9);
    }
    for (int row = 0; row < slice.rows; ++row) {
        if (spans.least(row) > spans.most(row)) continue;
        const int from = column_of(slice, spans.least(row)), to = column_of(slice, spans.most(row));
        if (forward) set_columns(slice.open_forward, slice, row, from, to);
        if (backward) set_columns(slice.open_backward, slice, row, from, to);
    }
}

bool is_open_at(const SightSlice& slice, double side, const glm::dvec3& point)
{
    const std::vector<std::uint64_t>& open = side > 0.0 ? slice.open_backward : slice.open_forward;
    return is_open_at(slice, open, glm::dot(point, slice.u), glm::dot(point, slice.v));
}

bool is_closed(const SightSlice& slice, double side, const Box& eyes, const Box& target)
{
    const std::vector<std::uint64_t>& open = side > 0.0 ? slice.open_backward : slice.open_forward;
    const auto from = corners_of(eyes), to = corners_of(target);
    std::array<FlatPoint, 64> points;
    std::array<double, 8> to_distance, to_u, to_v;
    for (std::size_t k = 0; k < 8; ++k) {
        to_distance[k] = std::abs(slice.plane.distance(to[k]));
        to_u[k] = glm::dot(to[k], slice.u);
        to_v[k] = glm::dot(to[k], slice.v);
    }
    double least_u = std::numeric_limits<double>::infinity(), least_v = least_u, most_u = -least_u, most_v = -least_u;
    for (std::size_t i = 0; i < 8; ++i) {
        // Eyes a hair behind the plane count as in it.
        const double distance = std::max(0.0, std::copysign(1.0, side) * slice.plane.distance(from[i]));
        const double u = glm::dot(from[i], slice.u), v = glm::dot(from[i], slice.v);
        for (std::size_t k = 0; k < 8; ++k) {
            const double share = distance / (distance + to_distance[k]);
            const FlatPoint p{u + share * (to_u[k] - u), v + share * (to_v[k] - v)};
            if (is_open_at(slice, open, p.u, p.v)) return false;
            points[8 * i + k] = p;
            least_u = std::min(least_u, p.u);
            most_u = std::max(most_u, p.u);
            least_v = std::min(least_v, p.v);
            most_v = std::max(most_v, p.v);
        }
    }
    const int from_row = row_of(slice, least_v - slice.margin_m), to_row = row_of(slice, most_v + slice.margin_m);
    const int from_column = column_of(slice, least_u - slice.margin_m),
              to_column = column_of(slice, most_u + slice.margin_m);
    if (from_row < 0 || to_row >= slice.rows || from_column < 0 || to_column >= slice.columns) return false;
    bool is_rectangle_closed = true;
    for (int row = from_row; row <= to_row && is_rectangle_closed; ++row)
        is_rectangle_closed = !any_open(open, slice, row, from_column, to_column);
    if (is_rectangle_closed) return true;
    std::array<FlatPoint, 130> hull;
    const std::size_t count = make_hull(points, hull);
    RowSpans spans(to_row - from_row + 1, slice.first_v + from_row * slice.texel_m, slice.texel_m);
    for (std::size_t i = 0; i < count; ++i) {
        const FlatPoint &a = hull[i], &b = hull[(i + 1) % count];
        spans.add(a.u, a.v, b.u, b.v, slice.margin_m);
    }
    for (int row = from_row; row <= to_row; ++row) {
        const double least = spans.least(row - from_row), most = spans.most(row - from_row);
        if (least > most) continue;
        if (any_open(open, slice, row, column_of(slice, least), column_of(slice, most))) return false;
    }
    return true;
}

}  // namespace hw
