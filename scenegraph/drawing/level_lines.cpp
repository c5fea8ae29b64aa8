#include "hatchway/drawing/level_lines.hpp"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

namespace hw {
namespace {

constexpr std::size_t kMostMadeBytes = 512u << 20;  // kept of all objects, to be drawn again
constexpr double kHiddenWidth = 0.6;                // of a hidden line, and its opacity: it stays behind what is seen
constexpr double kHiddenOpacity = 0.5;

std::vector<ObjectPens> with_crease(std::vector<ObjectPens> pens, std::optional<float> crease_rad)
{
    if (!crease_rad) return pens;
    for (ObjectPens& object : pens) {
        if (object.edges.is_any()) object.edges.crease_rad.assign(1, *crease_rad);
        for (ObjectLineLook& look : object.looks) look.crease_rad = *crease_rad;
    }
    return pens;
}

std::vector<ObjectPens> paper_pens(std::size_t count, const LevelLines::OnePen& pen)
{
    ObjectPens paper;
    paper.edges.crease_rad.push_back(pen.crease_rad);
    paper.edges.has_intersections = pen.has_intersections;
    paper.looks.push_back({.crease_rad = pen.crease_rad});
    paper.looks[0].look.far.is_on = false;
    return std::vector<ObjectPens>(count, paper);
}

std::vector<EdgeDemand> demands_of(const std::vector<ObjectPens>& pens)
{
    std::vector<EdgeDemand> demands;
    for (const ObjectPens& object : pens) demands.push_back(object.edges);
    return demands;
}

/// Seams and intersections are looked for in all instances: first of all is asked whether they fit.
const Scene& with_room(const Scene& scene)
{
    std::uint64_t positions = 0, faces = 0;
    for (const Object& object : scene.objects) {
        const MeshData& mesh = scene.meshes[static_cast<std::size_t>(object.mesh)];
        positions += mesh.positions.size();
        faces += mesh.indices.size() / 3;
    }
    require_line_room(positions, faces);
    return scene;
}

}  // namespace

LevelLines::LevelLines(const Scene& scene, std::vector<ObjectPens> pens, std::optional<float> crease_rad)
    : scene_(with_room(scene)),
      surfaces_(scene),
      pens_(with_crease(std::move(pens), crease_rad)),
      extras_(find_line_extras(scene, demands_of(pens_), surfaces_))
{
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const Material& material = scene.materials[scene.objects[id].material];
        add_object(id, material.alpha_mode != AlphaMode::blend, surfaces_.is_culled(id));
        objects_[id].seams = &extras_.objects[id].seams;
    }
}

LevelLines::LevelLines(const Scene& scene, const OnePen& pen)
    : scene_(with_room(scene)),
      surfaces_(scene),
      pens_(paper_pens(scene.objects.size(), pen)),
      extras_(find_intersection_extras(scene, demands_of(pens_), surfaces_))
{
    for (ObjectId id = 0; id < scene.objects.size(); ++id) add_object(id, true, false);
}

void LevelLines::add_object(ObjectId id, bool hides, bool is_culled)
{
    const EdgeDemand& edges = pens_[id].edges;
    LineObject object{.surface = &surfaces_.of(id),
                      .world_from_object = scene_.world_from_object(id),
                      .is_drawn = !pens_[id].looks.empty(),
                      .hides = hides,
                      .with_intersections = edges.has_intersections,
                      .is_culled = is_culled};
    if (edges.is_any()) {
        object.crease_rad = edges.crease_rad.front();
        object.more_crease_rad = std::span(edges.crease_rad).subspan(1);
    }
    objects_.push_back(object);
}

const std::string& LevelLines::name(std::uint32_t object) const
{
    return scene_.nodes[scene_.objects[object].node].path;
}

const LevelLines::Made& LevelLines::made_of(ObjectId id, float crease_rad)
{
    const ObjectExtras& extras = extras_.objects[id];
    const bool is_crowded = std::any_of(pens_[id].looks.begin(), pens_[id].looks.end(), [&](const ObjectLineLook& pen) {
        return pen.crease_rad == crease_rad && pen.look.far.is_on;
    });
    Key key{surfaces_.key_of(id), crease_rad, objects_[id].is_culled, is_crowded, {}};
    if (!extras.is_empty()) key.owner = id;
    if (made_bytes_ > kMostMadeBytes && !made_.contains(key)) {
        made_.clear();
        made_bytes_ = 0;
    }
    const auto [at, is_new] = made_.try_emplace(key);
    if (!is_new) return at->second;
    const ObjectEdges edges{*objects_[id].surface, crease_rad, extras, objects_[id].is_culled};
    Made& made = at->second;
    made.lines = object_lines(edges);
    if (is_crowded) {
        made.crowding.emplace(crowding_of(edges));
        set_crowding(made.lines, *made.crowding);
    }
    made_bytes_ += made.lines.lines.size() * sizeof(made.lines.lines[0]) + (made.crowding ? made.crowding->bytes() : 0);
    return made;
}

void LevelLines::append_groups(VectorObject& object, std::span<const VisibleLine> lines, const LinePieces& pieces)
{
    const VisibleLine& first = lines.front();
    const double share = first.is_visible ? 1.0 : kHiddenWidth;
    const float crease_rad = pens_[first.object].edges.crease_rad[first.set];
    const Made& made = made_of(first.object, crease_rad);
    const glm::dmat4& world = objects_[first.object].world_from_object;
    const PennedObject penned{.lines = made.lines,
                              .crowding = made.crowding ? &*made.crowding : nullptr,
                              .object_from_world = glm::inverse(world),
                              .metres_per_unit = std::cbrt(std::abs(glm::determinant(glm::dmat3(world))))};
    for (const ObjectLineLook& pen : pens_[first.object].looks) {
        if (pen.crease_rad != crease_rad) continue;
        VectorGroup group{.line_type = line_class_name(first.line_class),
                          .is_hidden = !first.is_visible,
                          .width_px = pen.look[first.line_class].width_px * share,
                          .opacity = first.is_visible ? 1.0 : kHiddenOpacity,
                          .colour_srgb = pen.look[first.line_class].colour};
        for (const VisibleLine& line : lines) {
            for (VectorLine& piece : pieces.of(line, pen, penned)) {
                piece.width_px *= share;
                group.lines.push_back(std::move(piece));
            }
        }
        if (!group.lines.empty()) object.groups.push_back(std::move(group));
    }
}

VectorDrawing LevelLines::drawing(const std::vector<VisibleLine>& lines, const LineCamera& camera)
{
    const LinePieces pieces(camera);
    VectorDrawing drawing{.size_px = camera.size_px};
    const auto is_alike = [](const VisibleLine& a, const VisibleLine& b) {
        return a.object == b.object && a.set == b.set && a.line_class == b.line_class && a.is_visible == b.is_visible;
    };
    for (std::size_t begin = 0; begin < lines.size();) {
        const VisibleLine& first = lines[begin];
        std::size_t end = begin;
        while (end < lines.size() && is_alike(lines[end], first)) ++end;
        if (begin == 0 || lines[begin - 1].object != first.object) drawing.objects.push_back({name(first.object), {}});
        append_groups(drawing.objects.back(), std::span(lines).subspan(begin, end - begin), pieces);
        begin = end;
    }
    // What is hidden lies under what is seen.
    for (VectorObject& object : drawing.objects)
        std::stable_partition(object.groups.begin(), object.groups.end(),
                              [](const VectorGroup& group) { return group.is_hidden; });
    return drawing;
}

}  // namespace hw
