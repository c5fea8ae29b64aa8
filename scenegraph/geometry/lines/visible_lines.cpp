// Appel's invisibility changes only where a line passes behind a contour; the number itself is not carried along, since
// at vertices it is a matter of many cases: the middle of every piece is looked at anew. That is exact for the piece,
// whatever happened before it. Cuts are found in doubles with slack: a cut too many does no harm, since both sides are
// looked at, and only what is behind is decided exactly (line_occluders.cpp).
#include "hatchway/geometry/lines/visible_lines.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>

#include "hatchway/geometry/lines/image_grid.hpp"
#include "hatchway/geometry/lines/image_space.hpp"
#include "hatchway/geometry/lines/line_chains.hpp"
#include "hatchway/geometry/lines/line_gather.hpp"
#include "hatchway/geometry/lines/line_occluders.hpp"

namespace hw {
namespace {

constexpr double kShortestPx = 1e-4;    // two cuts closer than this are one
constexpr double kContourSlack = 1e-6;  // a contour this little behind a line still cuts it
constexpr double kEndSlack = 1e-7;      // a contour that ends this close to a line still cuts it
constexpr double kContourCellPx = 12.0;
constexpr std::size_t kLinesPerTask = 32;

/// Memory of one thread.
struct CutScratch {
    std::vector<double> cuts;
    SeenItems triangles;
    SeenItems contours;
};

/// A part of a line that is visible, or hidden, as a whole.
struct LinePart {
    std::uint32_t line;
    bool is_visible;
    LinePiece piece;
};

class HiddenLines {
 public:
    HiddenLines(LineDrawing drawing, const ImageSpace& space)
        : drawing_(std::move(drawing)),
          occluders_(drawing_, space, work_),
          contour_grid_(space.size_px(), kContourCellPx)
    {
        tbb::parallel_invoke([&] { occluders_.fill(); }, [&] { fill_contours(); });
    }

    std::vector<LinePart> run() const
    {
        const std::size_t tasks = (drawing_.lines.size() + kLinesPerTask - 1) / kLinesPerTask;
        std::vector<std::vector<LinePart>> parts(tasks);
        tbb::enumerable_thread_specific<CutScratch> scratch;
        tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
            CutScratch& own = scratch.local();
            const std::size_t end = std::min((task + 1) * kLinesPerTask, drawing_.lines.size());
            for (std::size_t line = task * kLinesPerTask; line < end; ++line) {
                look_at(static_cast<std::uint32_t>(line), own, parts[task]);
            }
        });
        std::vector<LinePart> all;
        all.reserve(2 * drawing_.lines.size());
        for (const auto& some : parts) all.insert(all.end(), some.begin(), some.end());
        return all;
    }
    const DrawnLine& line(std::uint32_t index) const { return drawing_.lines[index]; }

 private:
    void fill_contours()
    {
        for (const DrawnLine& line : drawing_.lines) contour_grid_.mark(line.image.from, line.image.to);
        contour_grid_.end_marks();
        contour_bounds_.reserve(drawing_.contours.size());
        for (const ContourLine& c : drawing_.contours) contour_bounds_.push_back(ImageBounds::of({c.from, c.to}));
        contour_grid_.fill(
            static_cast<std::uint32_t>(drawing_.contours.size()), work_, [&](std::uint32_t i, auto&& visit) {
                contour_grid_.for_each_cell(drawing_.contours[i].from, drawing_.contours[i].to,
                                            [&](std::uint32_t cell) { visit(cell, contour_bounds_[i].nearest); });
            });
    }

    void look_at(std::uint32_t index, CutScratch& scratch, std::vector<LinePart>& parts) const
    {
        std::vector<double>& cuts = scratch.cuts;
        const DrawnLine& drawn = drawing_.lines[index];
        const ImageLine& seen = drawn.image;
        const double length = glm::distance(glm::dvec2(seen.from), glm::dvec2(seen.to));
        cuts.assign({0.0, 1.0});
        if (occluders_.is_behind_one_face(seen.from, seen.to, drawn)) {
            parts.push_back({index, false, piece_between(seen.from, seen.to, drawn.source)});
            set_vertices(drawn, parts.back().piece, parts.back().piece);
            return;
        }
        const ImageBounds bounds = ImageBounds::of({seen.from, seen.to});
        const float farthest = ImageBounds::below(std::min(seen.from.z, seen.to.z) * (1.0 - kContourSlack));
        cut_by_contours(seen, bounds, farthest, scratch);
        occluders_.cut(seen, bounds, farthest, scratch.triangles, cuts);
        std::sort(cuts.begin(), cuts.end());
        const double shortest = kShortestPx / length;
        std::size_t kept = 1;
        for (std::size_t i = 1; i + 1 < cuts.size(); ++i) {
            if (cuts[i] - cuts[kept - 1] > shortest && 1.0 - cuts[i] > shortest) cuts[kept++] = cuts[i];
        }
        cuts[kept++] = 1.0;
        cuts.resize(kept);
        add_parts(index, cuts, parts);
    }

    void add_parts(std::uint32_t index, const std::vector<double>& cuts, std::vector<LinePart>& parts) const
    {
        const DrawnLine& drawn = drawing_.lines[index];
        const ImageLine& seen = drawn.image;
        const auto at = [&](double t) { return t == 1.0 ? seen.to : glm::mix(seen.from, seen.to, t); };
        const std::size_t first = parts.size();
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            const bool is_visible = !occluders_.is_hidden(at(0.5 * (cuts[i] + cuts[i + 1])), drawn);
            if (parts.size() > first && parts.back().is_visible == is_visible) {
                set_end(parts.back().piece, at(cuts[i + 1]));
                continue;
            }
            parts.push_back({index, is_visible, piece_between(at(cuts[i]), at(cuts[i + 1]), drawn.source)});
        }
        set_vertices(drawn, parts[first].piece, parts.back().piece);
    }

    /// Ends at which the line goes on are those of its vertices.
    static void set_vertices(const DrawnLine& drawn, LinePiece& first, LinePiece& last)
    {
        if (drawn.image.is_from_whole) first.from_vertex = drawn.vertices[0];
        if (drawn.image.is_to_whole) last.to_vertex = drawn.vertices[1];
    }
    static LinePiece piece_between(const ImagePoint& from, const ImagePoint& to, LineSource source)
    {
        return {glm::dvec2(from), glm::dvec2(to), kFreeEnd, kFreeEnd, from.z, to.z, source};
    }
    static void set_end(LinePiece& piece, const ImagePoint& to)
    {
        piece.to = glm::dvec2(to);
        piece.to_depth = to.z;
    }

    void cut_by_contours(const ImageLine& line, const ImageBounds& bounds, float farthest, CutScratch& scratch) const
    {
        scratch.contours.begin_line(drawing_.contours.size());
        std::uint64_t looked_at = 0;
        contour_grid_.for_each_cell(line.from, line.to, [&](std::uint32_t cell) {
            looked_at += 1 + contour_grid_.items(cell).size();
            for (const std::uint32_t item : contour_grid_.items(cell)) {
                if (!contour_bounds_[item].can_change(bounds, farthest) || !scratch.contours.is_first(item)) continue;
                const ContourLine& contour = drawing_.contours[item];
                const double a = side_of(contour.from, contour.to, line.from.x, line.from.y);
                const double b = side_of(contour.from, contour.to, line.to.x, line.to.y);
                const double t = a / (a - b);
                if (!(t > 0.0 && t < 1.0)) continue;
                const double c = side_of(line.from, line.to, contour.from.x, contour.from.y);
                const double d = side_of(line.from, line.to, contour.to.x, contour.to.y);
                const double s = c / (c - d);
                if (!(s > -kEndSlack && s < 1.0 + kEndSlack)) continue;
                const double contour_z = glm::mix(contour.from.z, contour.to.z, s);
                if (contour_z > glm::mix(line.from.z, line.to.z, t) * (1.0 - kContourSlack)) scratch.cuts.push_back(t);
            }
        });
        work_.spend(looked_at);
    }

    LineDrawing drawing_;
    mutable LineWork work_;
    LineOccluders occluders_;
    ImageGrid contour_grid_;
    std::vector<ImageBounds> contour_bounds_;
};

/// Joins the parts of each object, class and visibility.
std::vector<VisibleLine> joined_lines(std::vector<LinePart> parts, const HiddenLines& hidden, bool with_hidden)
{
    if (!with_hidden) std::erase_if(parts, [](const LinePart& part) { return !part.is_visible; });
    const auto key = [&](const LinePart& part) {
        const DrawnLine& line = hidden.line(part.line);
        return std::uint64_t{line.object} << 16 | std::uint64_t{line.set} << 8 |
               static_cast<std::uint64_t>(line.line_class) << 1 | (part.is_visible ? 0u : 1u);
    };
    std::stable_sort(parts.begin(), parts.end(), [&](const LinePart& a, const LinePart& b) { return key(a) < key(b); });
    std::vector<VisibleLine> lines;
    std::vector<LinePiece> pieces;
    for (std::size_t begin = 0; begin < parts.size();) {
        std::size_t end = begin;
        pieces.clear();
        while (end < parts.size() && key(parts[end]) == key(parts[begin])) pieces.push_back(parts[end++].piece);
        const DrawnLine& first = hidden.line(parts[begin].line);
        for (LineChain& chain : join_pieces(pieces)) {
            lines.push_back({.object = first.object,
                             .set = first.set,
                             .line_class = first.line_class,
                             .is_visible = parts[begin].is_visible,
                             .is_closed = chain.is_closed,
                             .points_px = std::move(chain.points),
                             .inverse_depths = std::move(chain.depths),
                             .sources = std::move(chain.sources)});
        }
        begin = end;
    }
    return lines;
}

}  // namespace

void require_line_room(std::uint64_t positions, std::uint64_t faces)
{
    constexpr std::uint64_t kBytesOfPosition = 48, kBytesOfFace = 120;
    Budget().require(Cost::line_bytes, kBytesOfPosition * positions + kBytesOfFace * faces, "", "");
}

std::vector<VisibleLine> find_visible_lines(std::span<const LineObject> objects, const LineCamera& camera,
                                            const VisibleLineOptions& options)
{
    std::uint64_t positions = 0, faces = 0;
    for (const LineObject& object : objects) {
        positions += object.surface->positions.size();
        faces += object.surface->faces.size();
    }
    require_line_room(positions, faces);
    const ImageSpace space(camera);
    const HiddenLines hidden(gather_lines(objects, space, options), space);
    return joined_lines(hidden.run(), hidden, options.with_hidden);
}

}  // namespace hw
