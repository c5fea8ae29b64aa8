// The filter. A point of the view is known to a few units in the last place of its distance from the eye, since it is
// formed from the difference to the eye; its picture therefore to `place_error_px_` (with 40 units of reserve), which
// over a face of height h moves the depth found there by (depth range) * error / h. What is farther apart than twice
// that is decided; the rest goes to the exact predicates, on the positions as the object has them.
#include "hatchway/geometry/lines/line_occluders.hpp"

#include <tbb/parallel_for.h>

#include "hatchway/geometry/exact/predicates.hpp"

namespace hw {
namespace {

constexpr double kPlacingError = 2e-7;  // relative to the distance: matrices place objects no better
constexpr double kEndSlack = 1e-7;      // a face that is met this close to an end of a line cuts off nothing
constexpr double kPlaceError = 1e-14;   // relative: 90 units in the last place
constexpr double kDepthError = 1e-14;
constexpr std::uint64_t kStepsOfCut = 8;
constexpr std::uint32_t kFacesPerTask = 2048;

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

/// Cells about as large as triangles where those are small, never finer than the lists are worth.
double cell_px(const LineDrawing& drawing, const ImageSpace& space)
{
    double faces = 1.0;
    for (const DrawnObject& object : drawing.objects)
        if (object.is_in_picture && object.hides) faces += static_cast<double>(object.surface->faces.size());
    return std::clamp(std::sqrt(0.5 * space.size_px().x * space.size_px().y / faces), 3.0, 16.0);
}

/// Faces of one object that are looked at in one task.
struct FaceRun {
    std::uint32_t object = 0;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
};

std::vector<FaceRun> face_runs(const LineDrawing& drawing)
{
    std::vector<FaceRun> runs;
    for (std::uint32_t i = 0; i < drawing.objects.size(); ++i) {
        const DrawnObject& object = drawing.objects[i];
        if (!object.is_in_picture || !object.hides) continue;
        const auto count = static_cast<std::uint32_t>(object.surface->faces.size());
        for (std::uint32_t begin = 0; begin < count; begin += kFacesPerTask)
            runs.push_back({i, begin, std::min(begin + kFacesPerTask, count)});
    }
    return runs;
}

ImageBox box_of(const ImagePoint& p, const ImagePoint& q, const ImagePoint& r)
{
    return {std::min({p.x, q.x, r.x}), std::max({p.x, q.x, r.x}), std::min({p.y, q.y, r.y}), std::max({p.y, q.y, r.y})};
}

/// What is selected from a run.
struct RunSelection {
    std::uint32_t count = 0;             ///< Whole faces.
    std::vector<ImageTriangle> at_near;  ///< What is left of faces that the near plane cuts: few.
    std::size_t first = 0;               ///< Its place among all.
};

/// Finds the faces of a run that touch marked cells and writes the numbers of the whole ones into `whole`.
RunSelection select_run(const FaceRun& run, const DrawnObject& object, const ImageSpace& space, const ImageGrid& grid,
                        std::uint32_t* whole)
{
    RunSelection selected;
    const auto is_before = [&](std::uint32_t position) { return object.view[position].z >= space.near_m(); };
    for (std::uint32_t face = run.begin; face < run.end; ++face) {
        if (!object.is_there.empty() && object.is_there[face] == 0) continue;
        if (object.surface->face_triangle[face] == kNoFace) continue;
        const auto& [a, b, c] = object.surface->faces[face];
        if (!is_before(a) || !is_before(b) || !is_before(c)) {
            append_triangles(space, {object.view[a], object.view[b], object.view[c]},
                             {{}, object.first_face + face, run.object}, selected.at_near);
            continue;
        }
        const ImagePoint &p = object.image[a], &q = object.image[b], &r = object.image[c];
        if (!grid.has_marks(box_of(p, q, r)) || side_of(p, q, r.x, r.y) == 0.0) continue;
        whole[selected.count++] = face;
    }
    return selected;
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

LineOccluders::LineOccluders(const LineDrawing& drawing, const ImageSpace& space, LineWork& work)
    : drawing_(drawing),
      space_(space),
      work_(work),
      place_error_px_(kPlaceError * space.reach_px()),
      grid_(space.size_px(), cell_px(drawing, space))
{
}

void LineOccluders::fill()
{
    for (const DrawnLine& line : drawing_.lines) grid_.mark(line.image.from, line.image.to);
    grid_.end_marks();
    select_faces();
    grid_.fill(static_cast<std::uint32_t>(triangles_.size()), work_, [&](std::uint32_t i, auto&& visit) {
        grid_.for_each_cell(triangles_[i], [&](std::uint32_t cell) { visit(cell, bounds_[i].nearest); });
    });
}

// In two steps, so that what is large is allocated once, in its size.
void LineOccluders::select_faces()
{
    const std::vector<FaceRun> runs = face_runs(drawing_);
    std::vector<RunSelection> selected(runs.size());
    std::vector<std::uint32_t> faces(runs.size() * kFacesPerTask);
    tbb::parallel_for(std::size_t{0}, runs.size(), [&](std::size_t i) {
        selected[i] = select_run(runs[i], drawing_.objects[runs[i].object], space_, grid_, &faces[i * kFacesPerTask]);
    });
    std::size_t count = 0;
    for (RunSelection& run : selected) {
        run.first = count;
        count += run.count + run.at_near.size();
    }
    triangles_.resize(count);
    bounds_.resize(count);
    tbb::parallel_for(std::size_t{0}, runs.size(), [&](std::size_t i) {
        const DrawnObject& object = drawing_.objects[runs[i].object];
        std::size_t to = selected[i].first;
        const auto put = [&](const ImageTriangle& triangle) {
            const auto& [a, b, c] = triangle.corners;
            bounds_[to] = ImageBounds::of({a, b, c});
            triangles_[to++] = triangle;
        };
        for (std::uint32_t k = 0; k < selected[i].count; ++k) {
            const std::uint32_t face = faces[i * kFacesPerTask + k];
            const auto& [a, b, c] = object.surface->faces[face];
            put({{object.image[a], object.image[b], object.image[c]}, object.first_face + face, runs[i].object});
        }
        for (const ImageTriangle& triangle : selected[i].at_near) put(triangle);
    });
}

void LineOccluders::cut(const ImageLine& line, const ImageBounds& bounds, float farthest, SeenItems& seen,
                        std::vector<double>& cuts) const
{
    seen.begin_line(triangles_.size());
    std::uint64_t looked_at = 0;
    grid_.for_each_cell(line.from, line.to, [&](std::uint32_t cell) {
        looked_at += 1 + grid_.items(cell).size();
        for (const std::uint32_t item : grid_.items(cell)) {
            if (!bounds_[item].can_change(bounds, farthest) || !seen.is_first(item)) continue;
            const ImageTriangle& triangle = triangles_[item];
            const double a = before(triangle, line.from), b = before(triangle, line.to);
            const double t = a / (a - b);
            if (!(t > kEndSlack && t < 1.0 - kEndSlack)) continue;
            const ImagePoint at = glm::mix(line.from, line.to, t);
            if (Sides(triangle, at.x, at.y).are_inside()) cuts.push_back(t);
        }
    });
    work_.spend(looked_at + kStepsOfCut * cuts.size());
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
    if (is_other(triangle, line)) return before > point.z * kPlacingError + doubt && !do_touch(triangle, point, line);
    return std::abs(before) > doubt ? before > 0.0 : hides_in_doubt(triangle, line, before);
}

/// Whether only numbers that somebody rounded tell how the triangle lies to the line.
bool LineOccluders::is_other(const ImageTriangle& triangle, const DrawnLine& line) const
{
    if (triangle.object != line.object || !line.source.is_edge() || line.is_rounded) return true;
    const DrawnObject& object = drawing_.objects[line.object];
    const std::vector<std::uint32_t>& component = object.surface->face_component;
    return component[triangle.face - object.first_face] != component[line.faces[0] - object.first_face];
}

bool LineOccluders::do_touch(const ImageTriangle& triangle, const ImagePoint& point, const DrawnLine& line) const
{
    const DrawnObject& object = drawing_.objects[triangle.object];
    const auto& [a, b, c] = object.surface->faces[triangle.face - object.first_face];
    const glm::dvec3 corner = object.view[a];
    const glm::dvec3 normal = glm::cross(object.view[b] - corner, object.view[c] - corner);
    const double contact_m = std::max(object.contact_m, drawing_.objects[line.object].contact_m);
    return std::abs(glm::dot(normal, space_.view_of(point) - corner)) <= contact_m * glm::length(normal);
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
    work_.spend(1 + grid_.items(grid_.cell_at(point.x, point.y)).size());
    // Floats rounded upward: what is not nearer than the point by its own rounding cannot be before it.
    for (const std::uint32_t item : grid_.items(grid_.cell_at(point.x, point.y))) {
        if (bounds_[item].nearest < point.z || !bounds_[item].has(point.x, point.y)) continue;
        const ImageTriangle& triangle = triangles_[item];
        if (!is_own(line, triangle) && hides(triangle, point, line)) return true;
    }
    return false;
}

bool LineOccluders::is_behind_one_face(const ImagePoint& from, const ImagePoint& to, const DrawnLine& line) const
{
    const double farthest = std::min(from.z, to.z);
    work_.spend(1 + grid_.items(grid_.cell_at(from.x, from.y)).size());
    for (const std::uint32_t item : grid_.items(grid_.cell_at(from.x, from.y))) {
        const ImageBounds& bounds = bounds_[item];
        if (bounds.nearest < farthest || !bounds.has(from.x, from.y) || !bounds.has(to.x, to.y)) continue;
        const ImageTriangle& triangle = triangles_[item];
        if (!is_own(line, triangle) && hides(triangle, from, line) && hides(triangle, to, line)) return true;
    }
    return false;
}

}  // namespace hw
