#include "hatchway/geometry/lines/line_gather.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>
#include <utility>

#include "hatchway/core/box.hpp"
#include "hatchway/geometry/exact/predicates.hpp"
#include "hatchway/geometry/lines/intersections.hpp"
#include "hatchway/geometry/lines/line_chains.hpp"
#include "hatchway/geometry/surface/complex_edges.hpp"
#include "hatchway/geometry/surface/surface_faces.hpp"

namespace hw {
namespace {

constexpr std::size_t kPositionsPerTask = 4096;

constexpr unsigned kBehind = 1;  // the near plane

/// On which sides of the picture a point lies, a bit for each. Each side is a half-space, also behind the eye: points
/// that have a bit in common span nothing that is in the picture.
unsigned sides_outside(const glm::dvec3& view, const ImageSpace& space)
{
    const glm::dvec2 half = space.half_m(view.z);
    return (view.z < space.near_m() ? kBehind : 0u) | (view.x < -half.x ? 2u : 0u) | (view.x > half.x ? 4u : 0u) |
           (view.y < -half.y ? 8u : 0u) | (view.y > half.y ? 16u : 0u);
}

/// Fills view and image, and tells whether the object can be in the picture.
void place_positions(DrawnObject& drawn, const LineObject& object, const ImageSpace& space)
{
    const Surface& surface = *object.surface;
    const glm::dmat4 view_from_object = space.view_from_world() * object.world_from_object;
    // From the difference to the eye, so that an object far from the origin loses no digits.
    const glm::dmat3 turn(view_from_object);
    const bool is_flat = !(std::abs(glm::determinant(turn)) > 0.0);
    const glm::dvec3 eye =
        is_flat ? glm::dvec3(0.0) : in_object({space.origin_world(), false}, object.world_from_object).eye;
    const glm::dvec3 origin = is_flat ? glm::dvec3(view_from_object[3]) : glm::dvec3(0.0);
    const std::size_t tasks = (drawn.view.size() + kPositionsPerTask - 1) / kPositionsPerTask;
    std::vector<unsigned> outside(tasks, ~0u), outside_some(tasks, 0u);
    std::vector<Box> boxes(tasks);
    tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
        const std::size_t end = std::min((task + 1) * kPositionsPerTask, drawn.view.size());
        for (std::size_t i = task * kPositionsPerTask; i < end; ++i) {
            drawn.view[i] = origin + turn * (glm::dvec3(surface.positions[i]) - eye);
            if (drawn.view[i].z >= space.near_m()) drawn.image[i] = space.project(drawn.view[i]);
            const unsigned sides = sides_outside(drawn.view[i], space);
            outside[task] &= sides;
            outside_some[task] |= sides;
            boxes[task].add(surface.positions[i]);
        }
    });
    Box box;
    for (const Box& some : boxes) box.add(some);
    if (!box.is_empty())
        drawn.contact_m = kContactShare * glm::length(transformed(box, object.world_from_object).size());
    unsigned all = ~0u;
    for (const unsigned sides : outside) all &= sides;
    drawn.is_in_picture = !outside.empty() && all == 0;
    drawn.is_cut = std::any_of(outside_some.begin(), outside_some.end(), [](unsigned some) { return some & kBehind; });
}

/// What is found by one thread, object after object, and the memory that it needs for that.
struct Gathered {
    std::vector<ContourLine> contours;
    std::vector<DrawnLine> lines;
    SilhouetteScratch scratch;
};

/// What an object adds to a drawing: a part of what a thread gathered.
struct ObjectPart {
    const Gathered* from = nullptr;
    std::array<std::size_t, 2> contours{};
    std::array<std::size_t, 2> lines{};
};

/// A face that looks away is not there when faces are culled. One that is seen edge-on, such as the ground in an
/// elevation, hides nothing, but its lines are there.
bool is_absent(const LineObject& object, const DrawnObject& drawn, std::uint32_t face)
{
    if (!object.is_culled || drawn.is_there[face] != 0) return false;
    const Surface& surface = *object.surface;
    const std::uint32_t plane = plane_face(surface, face);
    if (plane == kNoFace) return true;
    const auto& [a, b, c] = surface.faces[plane];
    return facing_sign(surface.positions[a], surface.positions[b], surface.positions[c], drawn.eye_object) < 0;
}

class ObjectGathering {
 public:
    ObjectGathering(std::uint32_t index, const LineObject& object, DrawnObject& drawn, const ImageSpace& space,
                    const VisibleLineOptions& options, Gathered& found)
        : index_(index),
          object_(object),
          drawn_(drawn),
          space_(space),
          options_(options),
          found_(found),
          scratch_(found.scratch)
    {
    }

    ObjectPart run()
    {
        // First of all: while its loop waits, this thread may take up another object.
        place_positions(drawn_, object_, space_);
        if (!drawn_.is_in_picture) return {};
        ObjectPart part{&found_, {found_.contours.size(), 0}, {found_.lines.size(), 0}};
        if (object_.is_culled) {
            find_facing(*object_.surface, drawn_.eye_object, FacingPrecision::exact, scratch_);
            std::copy_n(scratch_.facing.begin(), drawn_.is_there.size(), drawn_.is_there.begin());
            const std::vector<bool>& two_sided = object_.surface->two_sided_faces;
            for (std::size_t face = 0; face < two_sided.size(); ++face)
                if (two_sided[face]) drawn_.is_there[face] = 1;
        }
        if (object_.hides) add_contours();
        for (set_ = 0; object_.is_drawn && set_ <= object_.more_crease_rad.size(); ++set_) add_lines();
        part.contours[1] = found_.contours.size();
        part.lines[1] = found_.lines.size();
        return part;
    }

 private:
    void add_contour(std::uint32_t edge)
    {
        const auto [a, b] = edge_vertices(*object_.surface, edge);
        const auto part = part_in_picture(space_, drawn_.view[a], drawn_.view[b]);
        if (part) found_.contours.push_back({part->from, part->to});
    }

    void add_contours()
    {
        const Surface& surface = *object_.surface;
        for (const std::uint32_t edge : all_silhouettes(surface, drawn_.eye_object, {}, scratch_)) add_contour(edge);
        const EdgeRange borders = surface.edges.group(EdgeGroup::border);
        for (std::uint32_t edge = borders.begin; edge < borders.end; ++edge) add_contour(edge);
        if (drawn_.is_cut) add_near_cuts();
    }

    /// What is cut open hides up to the cut.
    void add_near_cuts()
    {
        for (const auto& [a, b, c] : object_.surface->faces) {
            const auto cut = near_cut(space_, {drawn_.view[a], drawn_.view[b], drawn_.view[c]});
            const auto part = cut ? part_in_picture(space_, (*cut)[0], (*cut)[1]) : std::nullopt;
            if (part) found_.contours.push_back({part->from, part->to});
        }
    }

    bool is_left_out(std::uint32_t edge) const
    {
        const Seams* seams = object_.seams;
        return seams && (std::binary_search(seams->hidden.begin(), seams->hidden.end(), edge) ||
                         std::binary_search(seams->partly_hidden.begin(), seams->partly_hidden.end(), edge));
    }

    std::uint32_t unturned(std::uint32_t face) const
    {
        const auto count = static_cast<std::uint32_t>(object_.surface->faces.size());
        return face < count ? face : object_.surface->filter.twins[face - count].face;
    }

    bool is_absent(std::uint32_t face) const { return hw::is_absent(object_, drawn_, face); }

    /// Whether all faces beside an edge are absent, or what is left of them runs straight on across it.
    bool is_behind_the_scenes(std::uint32_t edge) const
    {
        const Surface& surface = *object_.surface;
        const auto [a, b] = surface.edges[edge].faces();
        if (!object_.is_culled) return false;
        if (b != kNoFace && edge < surface.edges.two_faced().begin)
            return std::ranges::all_of(faces_that_show(surface, edge), [&](auto face) { return is_absent(face); });
        return is_absent(a) && (b == kNoFace || is_absent(unturned(b)));
    }

    void add_line(std::uint32_t edge, LineClass line_class)
    {
        if (is_behind_the_scenes(edge)) return;
        const auto [a, b] = edge_vertices(*object_.surface, edge);
        const std::array<std::uint32_t, 2> faces = object_.surface->edges[edge].faces();
        const auto part = part_in_picture(space_, drawn_.view[a], drawn_.view[b]);
        if (!part || is_left_out(edge)) return;
        DrawnLine line{.object = index_,
                       .set = set_,
                       .line_class = line_class,
                       .vertices = {a, b},
                       .faces = {kNoFace, kNoFace},
                       .image = *part,
                       .source = {LineSource::Kind::edge, edge}};
        for (int side = 0; side < 2; ++side) {
            const std::uint32_t face = faces[side];
            if (face == kNoFace) continue;
            line.faces[side] = drawn_.first_face + unturned(face);
            line.is_rounded |= plane_face(*object_.surface, unturned(face)) != unturned(face);
        }
        found_.lines.push_back(line);
    }

    void add_lines()
    {
        const Surface& surface = *object_.surface;
        const auto add_folded = [&](EdgeRange range, LineClass line_class) {
            for (std::uint32_t edge = range.begin; edge < range.end; ++edge)
                add_line(edge, is_silhouette(edge) ? LineClass::silhouette : line_class);
        };
        const float own_rad = set_ == 0 ? object_.crease_rad : object_.more_crease_rad[set_ - 1];
        const float crease_rad = options_.with_creases ? own_rad : kNoCreases;
        for (const std::uint32_t edge :
             drawn_contours(surface, drawn_.eye_object, {.crease_rad = crease_rad}, scratch_)) {
            add_line(edge, LineClass::silhouette);
        }
        const EdgeClasses classes = classes_at(surface, crease_rad);
        if (options_.with_creases) {
            for (const EdgeRange range : classes.ridges) add_folded(range, LineClass::ridge);
            for (const EdgeRange range : classes.valleys) add_folded(range, LineClass::valley);
        }
        for (const EdgeRange range : classes.artist) {
            for (std::uint32_t edge = range.begin; edge < range.end; ++edge) {
                const bool is_contour = is_silhouette(edge);
                if (is_contour || options_.with_artist)
                    add_line(edge, is_contour ? LineClass::silhouette : LineClass::artist);
            }
        }
        for (std::uint32_t edge = classes.borders.begin; edge < classes.borders.end; ++edge)
            add_line(edge, LineClass::border);
        add_kept_parts();
    }

    /// Strictly; a twin does where its face looks away.
    bool looks_here(std::uint32_t face) const
    {
        const Surface& surface = *object_.surface;
        const std::uint32_t plane = plane_face(surface, face);
        if (plane == kNoFace) return false;
        const auto& [a, b, c] = surface.faces[plane];
        const int sign =
            facing_sign(surface.positions[a], surface.positions[b], surface.positions[c], drawn_.eye_object);
        return face < surface.faces.size() ? sign > 0 : sign < 0;
    }

    /// What is drawn from everywhere is a silhouette where its faces disagree about the eye, however folded.
    bool is_silhouette(std::uint32_t edge) const
    {
        const auto [a, b] = object_.surface->edges[edge].faces();
        return looks_here(a) != looks_here(b);
    }

    void add_kept_parts()
    {
        if (!object_.seams) return;
        const glm::dmat4 view_from_object = space_.view_from_world() * object_.world_from_object;
        const auto in_view = [&](const glm::vec3& p) { return glm::dvec3(view_from_object * glm::dvec4(p, 1.0)); };
        for (std::uint32_t i = 0; i < object_.seams->kept.size(); ++i) {
            const auto& [ends, edge] = object_.seams->kept[i];
            if (is_behind_the_scenes(edge)) continue;
            const auto part = part_in_picture(space_, in_view(ends[0]), in_view(ends[1]));
            if (!part) continue;
            found_.lines.push_back({.object = index_,
                                    .set = set_,
                                    .line_class = LineClass::border,
                                    .vertices = {kFreeEnd, kFreeEnd},
                                    .faces = {kNoFace, kNoFace},
                                    .image = *part,
                                    .source = {LineSource::Kind::kept, i}});
        }
    }

    static constexpr float kNoCreases = 3.2f;

    std::uint32_t index_;
    std::uint8_t set_ = 0;
    const LineObject& object_;
    DrawnObject& drawn_;
    const ImageSpace& space_;
    const VisibleLineOptions& options_;
    Gathered& found_;
    SilhouetteScratch& scratch_;
};

/// What makes two lines one for whoever draws them: the same picture, class and set, of whatever object.
struct SightOfLine {
    explicit SightOfLine(const DrawnLine& line) : class_and_set(static_cast<unsigned>(line.line_class) << 8 | line.set)
    {
        const auto& [a, b] = std::pair(line.image.from, line.image.to);
        const bool is_in_order = std::tie(a.x, a.y, a.z) <= std::tie(b.x, b.y, b.z);
        ends = is_in_order ? std::array{a, b} : std::array{b, a};
    }
    auto operator<=>(const SightOfLine& other) const
    {
        const auto& [a, b] = ends;
        const auto& [c, d] = other.ends;
        return std::tie(a.x, a.y, a.z, b.x, b.y, b.z, class_and_set) <=>
               std::tie(c.x, c.y, c.z, d.x, d.y, d.z, other.class_and_set);
    }
    bool operator==(const SightOfLine&) const = default;

    std::array<ImagePoint, 2> ends;
    unsigned class_and_set;
};

/// Shells that lie on each other, such as a front and a back of two materials, have each line of the same edge once:
/// the first keeps it.
void remove_repeats(std::vector<DrawnLine>& lines)
{
    std::vector<std::pair<SightOfLine, std::uint32_t>> seen;
    for (std::uint32_t i = 0; i < lines.size(); ++i) seen.emplace_back(SightOfLine(lines[i]), i);
    tbb::parallel_sort(seen.begin(), seen.end());
    std::vector<std::uint8_t> is_repeat(lines.size(), 0);
    for (std::size_t i = 1; i < seen.size(); ++i) is_repeat[seen[i].second] = seen[i].first == seen[i - 1].first;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (is_repeat[i] == 0) lines[kept++] = lines[i];
    lines.resize(kept);
}

/// A meeting needs both faces: along a wall that is not there the other just goes on.
void add_intersections(LineDrawing& drawing, std::span<const LineObject> objects, const ImageSpace& space,
                       std::span<const IntersectionLine> intersections)
{
    const glm::dmat3 turn(space.view_from_world());
    for (std::uint32_t i = 0; i < intersections.size(); ++i) {
        const IntersectionLine& cut = intersections[i];
        const auto part = part_in_picture(space, turn * (cut.ends_world[0] - space.origin_world()),
                                          turn * (cut.ends_world[1] - space.origin_world()));
        const auto is_gone = [&](int side) {
            const std::uint32_t object = cut.objects[side];
            return is_absent(objects[object], drawing.objects[object], cut.faces[side]);
        };
        if (!part || is_gone(0) || is_gone(1)) continue;
        const std::uint32_t owner = owner_of(cut, objects);
        DrawnLine line{.object = owner,
                       .line_class = LineClass::intersection,
                       .vertices = cut.joints,
                       .image = *part,
                       .source = {LineSource::Kind::intersection, i}};
        for (int side = 0; side < 2; ++side)
            line.faces[side] = drawing.objects[cut.objects[side]].first_face + cut.faces[side];
        for (line.set = 0; line.set <= objects[owner].more_crease_rad.size(); ++line.set) drawing.lines.push_back(line);
    }
}

/// The objects, none of them placed yet. What is large is allocated once for all.
LineDrawing unplaced(std::span<const LineObject> objects, const ImageSpace& space)
{
    LineDrawing drawing;
    std::size_t positions = 0, faces = 0;
    for (const LineObject& object : objects) {
        positions += object.surface->positions.size();
        faces += object.surface->faces.size();
    }
    drawing.view.resize(positions);
    drawing.image.resize(positions);
    drawing.is_there.resize(faces);
    std::size_t first_position = 0, first_face = 0;
    for (const LineObject& object : objects) {
        const std::size_t count = object.surface->positions.size(), face_count = object.surface->faces.size();
        drawing.objects.push_back(
            {.surface = object.surface,
             .eye_object = in_object(space.viewpoint(), object.world_from_object),
             .first_face = static_cast<std::uint32_t>(first_face),
             .hides = object.hides,
             .view = std::span(drawing.view).subspan(first_position, count),
             .image = std::span(drawing.image).subspan(first_position, count),
             .is_there = std::span(drawing.is_there).subspan(first_face, object.is_culled ? face_count : 0)});
        first_position += count;
        first_face += face_count;
    }
    return drawing;
}

}  // namespace

LineDrawing gather_lines(std::span<const LineObject> objects, const ImageSpace& space,
                         const VisibleLineOptions& options)
{
    LineDrawing drawing = unplaced(objects, space);
    std::vector<ObjectPart> parts(objects.size());
    tbb::enumerable_thread_specific<Gathered> gathered;
    tbb::parallel_for(std::size_t{0}, objects.size(), [&](std::size_t i) {
        ObjectGathering gathering(static_cast<std::uint32_t>(i), objects[i], drawing.objects[i], space, options,
                                  gathered.local());
        parts[i] = gathering.run();
    });
    std::size_t contours = 0, lines = 0;
    for (const Gathered& some : gathered) {
        contours += some.contours.size();
        lines += some.lines.size();
    }
    drawing.contours.reserve(contours);
    drawing.lines.reserve(lines + options.intersections.size());
    const auto append = [](auto& to, const auto& from, const std::array<std::size_t, 2>& range) {
        to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(range[0]),
                  from.begin() + static_cast<std::ptrdiff_t>(range[1]));
    };
    for (const ObjectPart& part : parts) {
        if (part.from == nullptr) continue;
        append(drawing.contours, part.from->contours, part.contours);
        append(drawing.lines, part.from->lines, part.lines);
    }
    remove_repeats(drawing.lines);
    add_intersections(drawing, objects, space, options.intersections);
    return drawing;
}

}  // namespace hw
