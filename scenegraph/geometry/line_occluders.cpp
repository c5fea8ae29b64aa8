// The filter. A point of the view is known to a few units in the last place of its distance from the eye, since it is
// formed from the difference to the eye; its picture therefore to `place_error_px_` (with 40 units of reserve), which
// over a face of height h moves the depth found there by (depth range) * error / h. What is farther apart than twice
// that is decided; the rest goes to the exact predicates, on the positions as the object has them.
#include "geometry/line_occluders.hpp"

#include "geometry/predicates.hpp"

namespace hw {
namespace {

constexpr double kContactTolerance = 2e-7;  // relative to the distance: objects closer than this are in contact
constexpr double kEndSlack = 1e-7;          // a face that is met this close to an end of a line cuts off nothing
constexpr double kPlaceError = 1e-14;       // relative: 90 units in the last place
constexpr double kDepthError = 1e-14;

/// Where a point of the picture lies in a triangle: twice the areas opposite to c, a and b.
struct Sides {
    double ab, bc, ca;

    Sides(const ImageTriangle& triangle, double x, double y)
        : ab(side_of(triangle.corners[0], triangle.corners[1], x, y)),
          bc(side_of(triangle.corners[1], triangle.corners[2], x, y)),
          ca(side_of(triangle.corners[2], triangle.corners[0], x, y))
    {
    }
    /// With its sides: neighbours leave no gap.
    bool are_inside() const { return (ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0); }
};

/// How far before the triangle's plane a point is, in 1 / depth times twice the triangle's area.
double before(const ImageTriangle& triangle, const ImagePoint& p)
{
    const auto& [a, b, c] = triangle.corners;
    const Sides sides(triangle, p.x, p.y);
    return sides.ab * (p.z - c.z) + sides.bc * (p.z - a.z) + sides.ca * (p.z - b.z);
}

bool is_own(const DrawnLine& line, const ImageTriangle& triangle)
{
    return triangle.face == line.faces[0] || triangle.face == line.faces[1];
}

/// Longest side, as the sum of its two extents.
double reach_of(const ImageTriangle& triangle)
{
    const auto& [a, b, c] = triangle.corners;
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    return (right - left) + (bottom - top);
}

}  // namespace

LineOccluders::LineOccluders(const LineDrawing& drawing, const ImageSpace& space)
    : drawing_(drawing),
      // About one triangle a cell where triangles are small, never finer than the lists are worth.
      cell_px_(std::clamp(std::sqrt(2.0 * space.size_px().x * space.size_px().y /
                                    std::max<double>(1.0, static_cast<double>(drawing.triangles.size()))),
                          4.0, 32.0)),
      place_error_px_(kPlaceError * (space.focal_px() + space.size_px().x + space.size_px().y)),
      grid_(space.size_px(), cell_px_)
{
}

void LineOccluders::fill()
{
    bounds_.reserve(drawing_.triangles.size());
    for (const ImageTriangle& t : drawing_.triangles) {
        bounds_.push_back(ImageBounds::of({t.corners[0], t.corners[1], t.corners[2]}));
    }
    grid_.fill(static_cast<std::uint32_t>(drawing_.triangles.size()),
               [&](std::uint32_t i, auto&& visit) { grid_.for_each_cell(drawing_.triangles[i], visit); });
}

void LineOccluders::cut(const ImagePoint& from, const ImagePoint& to, const ImageBounds& bounds, float farthest,
                        std::vector<double>& cuts) const
{
    grid_.for_each_cell(from, to, [&](std::uint32_t cell) {
        for (const std::uint32_t item : grid_.items(cell)) {
            if (!bounds_[item].can_change(bounds, farthest)) continue;
            const ImageTriangle& triangle = drawing_.triangles[item];
            const double a = before(triangle, from), b = before(triangle, to);
            const double t = a / (a - b);
            if (!(t > kEndSlack && t < 1.0 - kEndSlack)) continue;
            const ImagePoint at = glm::mix(from, to, t);
            if (Sides(triangle, at.x, at.y).are_inside()) cuts.push_back(t);
        }
    });
}

bool LineOccluders::hides(const ImageTriangle& triangle, const ImagePoint& point, const DrawnLine& line) const
{
    const auto& [a, b, c] = triangle.corners;
    const Sides sides(triangle, point.x, point.y);
    if (!sides.are_inside()) return false;
    const double area = sides.ab + sides.bc + sides.ca;
    const double before = (sides.ab * c.z + sides.bc * a.z + sides.ca * b.z) / area - point.z;
    const auto [far, near] = std::minmax({a.z, b.z, c.z});
    const double doubt =
        2.0 * ((near - far) * place_error_px_ * reach_of(triangle) / std::abs(area) + kDepthError * near);
    const bool is_other = triangle.object != line.object || !line.is_edge;
    if (is_other) return before > point.z * kContactTolerance + doubt;
    return std::abs(before) > doubt ? before > 0.0 : hides_in_doubt(triangle, line, before);
}

bool LineOccluders::hides_in_doubt(const ImageTriangle& triangle, const DrawnLine& line, double before) const
{
    const DrawnObject& object = drawing_.objects[triangle.object];
    const Surface& surface = *object.surface;
    const auto& [a, b, c] = surface.faces[triangle.face - object.first_face];
    const glm::vec3 &p = surface.positions[a], &q = surface.positions[b], &r = surface.positions[c];
    const int eye_side = facing_sign(p, q, r, object.eye_object);
    if (eye_side == 0) return false;
    const auto side = [&](std::uint32_t vertex) {
        return eye_side * orient3d_sign(p, q, r, glm::dvec3(surface.positions[vertex]));
    };
    const int from = side(line.vertices[0]), to = side(line.vertices[1]);
    if (from >= 0 && to >= 0) return false;
    if (from <= 0 && to <= 0) return true;
    return before > 0.0;  // the line goes through the plane: so close to it either answer shows as nothing
}

bool LineOccluders::is_hidden(const ImagePoint& point, const DrawnLine& line) const
{
    // Floats rounded upward: what is not nearer than the point by its own rounding cannot be before it.
    for (const std::uint32_t item : grid_.items(grid_.cell_at(point.x, point.y))) {
        if (bounds_[item].nearest < point.z || !bounds_[item].has(point.x, point.y)) continue;
        const ImageTriangle& triangle = drawing_.triangles[item];
        if (!is_own(line, triangle) && hides(triangle, point, line)) return true;
    }
    return false;
}

bool LineOccluders::is_behind_one_face(const ImagePoint& from, const ImagePoint& to, const DrawnLine& line) const
{
    const double farthest = std::min(from.z, to.z);
    for (const std::uint32_t item : grid_.items(grid_.cell_at(from.x, from.y))) {
        const ImageBounds& bounds = bounds_[item];
        if (bounds.nearest < farthest || !bounds.has(from.x, from.y) || !bounds.has(to.x, to.y)) continue;
        const ImageTriangle& triangle = drawing_.triangles[item];
        if (!is_own(line, triangle) && hides(triangle, from, line) && hides(triangle, to, line)) return true;
    }
    return false;
}

}  // namespace hw
