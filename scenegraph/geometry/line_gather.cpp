#include "geometry/line_gather.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/intersections.hpp"
#include "geometry/line_chains.hpp"

namespace hw {
namespace {

class Gathering {
 public:
    Gathering(const LineCamera& camera, const ImageSpace& space, const VisibleLineOptions& options)
        : camera_(camera), space_(space), options_(options)
    {
    }

    void add(std::uint32_t index, const LineObject& object)
    {
        index_ = index;
        object_ = &object;
        eye_object_ = in_object({camera_.eye_world, false}, object.world_from_object);
        drawing.objects.push_back({object.surface, eye_object_, first_face_});
        place_positions();
        if (object.is_culled) find_facing(*object.surface, eye_object_, FacingPrecision::exact, facing_);
        if (object.hides) {
            add_triangles();
            add_contours();
        }
        if (object.is_drawn) add_lines();
        first_face_ += static_cast<std::uint32_t>(object.surface->faces.size());
    }

    /// Once all objects are there.
    void add_intersections(std::span<const LineObject> objects)
    {
        const glm::dmat3 turn(space_.view_from_world());
        for (const IntersectionLine& cut : options_.intersections) {
            const std::uint32_t owner = cut.objects[shows_intersections(objects[cut.objects[0]]) ? 0 : 1];
            DrawnLine line{owner, VisibleLineClass::intersection, cut.joints};
            for (int side = 0; side < 2; ++side)
                line.faces[side] = drawing.objects[cut.objects[side]].first_face + cut.faces[side];
            line.from_view = turn * (cut.ends_world[0] - camera_.eye_world);
            line.to_view = turn * (cut.ends_world[1] - camera_.eye_world);
            line.is_edge = false;
            drawing.lines.push_back(line);
        }
    }

    LineDrawing drawing;

 private:
    void place_positions()
    {
        const Surface& surface = *object_->surface;
        const glm::dmat4 view_from_object = space_.view_from_world() * object_->world_from_object;
        // From the difference to the eye, so that an object far from the origin loses no digits.
        const glm::dmat3 turn(view_from_object);
        const bool is_flat = !(std::abs(glm::determinant(turn)) > 0.0);
        const glm::dvec3 eye = is_flat ? glm::dvec3(0.0) : eye_object_.eye;
        const glm::dvec3 origin = is_flat ? glm::dvec3(view_from_object[3]) : glm::dvec3(0.0);
        view_.resize(surface.positions.size());
        image_.resize(surface.positions.size());
        for (std::size_t i = 0; i < view_.size(); ++i) {
            view_[i] = origin + turn * (glm::dvec3(surface.positions[i]) - eye);
            if (view_[i].z >= space_.near_m()) image_[i] = space_.project(view_[i]);
        }
    }
    bool is_before(std::uint32_t position) const { return view_[position].z >= space_.near_m(); }

    /// A face that looks away is not there when faces are culled.
    bool is_absent(std::uint32_t face) const { return object_->is_culled && !is_front_facing(facing_, face); }

    void add_triangles()
    {
        const Surface& surface = *object_->surface;
        const glm::dvec2 size = space_.size_px();
        for (std::uint32_t face = 0; face < surface.faces.size(); ++face) {
            if (is_absent(face)) continue;
            const ImageTriangle whole{{}, first_face_ + face, index_};
            const auto& [a, b, c] = surface.faces[face];
            if (!is_before(a) || !is_before(b) || !is_before(c)) {
                append_triangles(space_, {view_[a], view_[b], view_[c]}, whole, drawing.triangles);
                continue;
            }
            const ImagePoint &p = image_[a], &q = image_[b], &r = image_[c];
            if (std::max({p.x, q.x, r.x}) < 0.0 || std::min({p.x, q.x, r.x}) > size.x) continue;
            if (std::max({p.y, q.y, r.y}) < 0.0 || std::min({p.y, q.y, r.y}) > size.y) continue;
            if (side_of(p, q, r.x, r.y) != 0.0) {
                drawing.triangles.push_back({{p, q, r}, whole.face, whole.object});
            }
        }
    }

    void add_contour(std::uint32_t edge)
    {
        const auto [a, b] = object_->surface->edges.vertices[edge];
        const auto part = space_.clipped(view_[a], view_[b]);
        if (part) drawing.contours.push_back({space_.project(part->from), space_.project(part->to)});
    }

    void add_contours()
    {
        const Surface& surface = *object_->surface;
        for (const std::uint32_t edge : all_silhouettes(surface, eye_object_, {}, scratch_)) add_contour(edge);
        const EdgeRange borders = surface.edges.group(EdgeGroup::border);
        for (std::uint32_t edge = borders.begin; edge < borders.end; ++edge) add_contour(edge);
    }

    bool is_left_out(std::uint32_t edge) const
    {
        const Seams* seams = object_->seams;
        return seams && (std::binary_search(seams->hidden.begin(), seams->hidden.end(), edge) ||
                         std::binary_search(seams->partly_hidden.begin(), seams->partly_hidden.end(), edge));
    }

    std::uint32_t unturned(std::uint32_t face) const
    {
        const auto count = static_cast<std::uint32_t>(object_->surface->faces.size());
        return face < count ? face : object_->surface->filter.twins[face - count].face;
    }

    /// Whether all faces beside an edge are absent. Complex edges have more faces than the table names.
    bool is_behind_the_scenes(std::uint32_t edge) const
    {
        const auto [a, b] = object_->surface->edges.faces[edge];
        if (!object_->is_culled || !is_absent(a)) return false;
        if (b == kNoFace) return true;
        return edge >= object_->surface->edges.two_faced().begin && is_absent(unturned(b));
    }

    void add_line(std::uint32_t edge, VisibleLineClass line_class)
    {
        if (is_left_out(edge) || is_behind_the_scenes(edge)) return;
        const EdgeTable& edges = object_->surface->edges;
        const auto [a, b] = edges.vertices[edge];
        DrawnLine line{index_, line_class, {a, b}, {kNoFace, kNoFace}, view_[a], view_[b]};
        for (int side = 0; side < 2; ++side) {
            const std::uint32_t face = edges.faces[edge][side];
            if (face != kNoFace) line.faces[side] = first_face_ + unturned(face);
        }
        drawing.lines.push_back(line);
    }

    void add_lines()
    {
        const Surface& surface = *object_->surface;
        const auto add_range = [&](EdgeRange range, VisibleLineClass line_class) {
            for (std::uint32_t edge = range.begin; edge < range.end; ++edge) add_line(edge, line_class);
        };
        const float crease_rad = options_.with_creases ? object_->crease_rad : kNoCreases;
        for (const std::uint32_t edge : drawn_contours(surface, eye_object_, {.crease_rad = crease_rad}, scratch_)) {
            add_line(edge, VisibleLineClass::silhouette);
        }
        const EdgeClasses classes = classes_at(surface, crease_rad);
        if (options_.with_creases) {
            for (const EdgeRange range : classes.ridges) add_range(range, VisibleLineClass::ridge);
            for (const EdgeRange range : classes.valleys) add_range(range, VisibleLineClass::valley);
        }
        if (options_.with_artist) {
            for (const EdgeRange range : classes.artist) add_range(range, VisibleLineClass::artist);
        } else {
            add_marked_silhouettes(classes.artist);
        }
        add_range(classes.borders, VisibleLineClass::border);
        add_kept_parts();
    }

    /// The artist's edges are drawn anyway and so are no candidates; a drawing of contours alone needs those that are
    /// silhouettes now.
    void add_marked_silhouettes(const std::array<EdgeRange, 2>& artist)
    {
        if (artist[0].size() + artist[1].size() == 0) return;
        find_facing(*object_->surface, eye_object_, FacingPrecision::exact, scratch_);
        for (const EdgeRange range : artist) {
            for (std::uint32_t edge = range.begin; edge < range.end; ++edge) {
                const auto [a, b] = object_->surface->edges.faces[edge];
                if (is_front_facing(scratch_, a) != is_front_facing(scratch_, b)) {
                    add_line(edge, VisibleLineClass::silhouette);
                }
            }
        }
    }

    void add_kept_parts()
    {
        if (!object_->seams) return;
        const glm::dmat4 view_from_object = space_.view_from_world() * object_->world_from_object;
        for (const auto& [from, to] : object_->seams->kept) {
            drawing.lines.push_back({index_,
                                     VisibleLineClass::border,
                                     {kFreeEnd, kFreeEnd},
                                     {kNoFace, kNoFace},
                                     glm::dvec3(view_from_object * glm::dvec4(from, 1.0)),
                                     glm::dvec3(view_from_object * glm::dvec4(to, 1.0)),
                                     false});
        }
    }

    static constexpr float kNoCreases = 3.2f;

    const LineCamera& camera_;
    const ImageSpace& space_;
    const VisibleLineOptions& options_;
    std::uint32_t index_ = 0;
    const LineObject* object_ = nullptr;
    std::uint32_t first_face_ = 0;
    Viewpoint eye_object_;
    std::vector<glm::dvec3> view_;
    std::vector<ImagePoint> image_;
    SilhouetteScratch scratch_;
    SilhouetteScratch facing_;  ///< Of faces that are culled.
};

}  // namespace

LineDrawing gather_lines(std::span<const LineObject> objects, const LineCamera& camera, const ImageSpace& space,
                         const VisibleLineOptions& options)
{
    Gathering gathering(camera, space, options);
    for (std::uint32_t i = 0; i < objects.size(); ++i) gathering.add(i, objects[i]);
    if (!options.intersections.empty()) gathering.add_intersections(objects);
    return std::move(gathering.drawing);
}

}  // namespace hw
