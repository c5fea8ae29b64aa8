#include "hatchway/drawing/level_lines.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>

#include "hatchway/drawing/scene_surfaces.hpp"

namespace hw {
namespace {

constexpr float kPaperCreaseRad = 0.6981317f;  // 40 degrees
constexpr double kHiddenWidth = 0.6;           // of a hidden line, and its opacity: it stays behind what is seen
constexpr double kHiddenOpacity = 0.5;

ObjectLineLook paper_look(float crease_rad)
{
    ObjectLineLook paper{.crease_rad = crease_rad};
    paper.look.far.is_on = false;
    return paper;
}

}  // namespace

std::vector<VisibleLine> timed_visible_lines(std::span<const LineObject> objects, const LineCamera& camera,
                                             const VisibleLineOptions& options, int runs, double& seconds)
{
    std::vector<VisibleLine> lines;
    std::vector<double> times_s;
    for (int run = 0; run < std::max(runs, 1); ++run) {
        const auto start = std::chrono::steady_clock::now();
        lines = find_visible_lines(objects, camera, options);
        times_s.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    const auto middle = times_s.begin() + static_cast<std::ptrdiff_t>(times_s.size() / 2);
    std::nth_element(times_s.begin(), middle, times_s.end());
    seconds = *middle;
    return lines;
}

LevelLines::LevelLines(const Scene& scene, std::vector<ObjectPens> pens, std::optional<float> crease_rad)
    : scene_(scene), surfaces_(scene_surfaces(scene)), pens_(scene.objects.size())
{
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const Material& material = scene.materials[scene.objects[id].material];
        objects_.push_back({.surface = &surfaces_[scene.objects[id].mesh],
                            .world_from_object = scene.world_from_object(id),
                            .hides = material.alpha_mode != AlphaMode::blend,
                            .is_culled = !pens.empty() && !material.is_double_sided});
    }
    if (pens.empty()) {
        for (ObjectId id = 0; id < scene.objects.size(); ++id) {
            objects_[id].hides = true;
            objects_[id].crease_rad = crease_rad.value_or(kPaperCreaseRad);
            pens_[id] = {paper_look(objects_[id].crease_rad)};
        }
    } else {
        take_pens(pens, crease_rad);
        find_object_seams(pens);
    }
}

void LevelLines::take_pens(const std::vector<ObjectPens>& pens, std::optional<float> crease_rad)
{
    for (ObjectId id = 0; id < objects_.size(); ++id) {
        LineObject& object = objects_[id];
        pens_[id] = pens[id].looks;
        object.is_drawn = !pens_[id].empty();
        object.with_intersections = pens[id].edges.has_intersections;
        if (!object.is_drawn) continue;
        // Styles of one object that want different creases share the finer one: their lines lie on each other.
        object.crease_rad = pens_[id][0].crease_rad;
        for (const ObjectLineLook& pen : pens_[id]) object.crease_rad = std::min(object.crease_rad, pen.crease_rad);
        if (crease_rad) object.crease_rad = *crease_rad;
    }
}

void LevelLines::find_object_seams(const std::vector<ObjectPens>& pens)
{
    std::vector<SeamObject> together;
    std::vector<ObjectId> ids;
    float crease_rad = 3.2f;
    for (ObjectId id = 0; id < objects_.size(); ++id) {
        if (!pens[id].edges.is_any()) continue;
        together.push_back({objects_[id].surface, objects_[id].world_from_object, pens[id].edges.style_group});
        ids.push_back(id);
        crease_rad = std::min({crease_rad, pens[id].edges.crease_rad[0], objects_[id].crease_rad});
    }
    seams_ = find_seams(together, {.crease_rad = crease_rad});
    for (std::size_t i = 0; i < ids.size(); ++i) objects_[ids[i]].seams = &seams_[i];
}

const std::vector<IntersectionLine>& LevelLines::intersections()
{
    if (!intersections_) intersections_ = find_intersections(objects_);
    return *intersections_;
}

const std::string& LevelLines::name(std::uint32_t object) const
{
    return scene_.nodes[scene_.objects[object].node].path;
}

void LevelLines::find_crowding()
{
    for (const LineObject& object : objects_) inked_.push_back(inked_object(object));
    std::vector<std::vector<std::array<glm::vec3, 2>>> pieces(objects_.size());
    if (std::any_of(objects_.begin(), objects_.end(), shows_intersections)) {
        for (const IntersectionLine& line : intersections()) {
            const std::uint32_t owner = line.objects[shows_intersections(objects_[line.objects[0]]) ? 0 : 1];
            const auto in_object = [&](const glm::dvec3& p) {
                return glm::vec3(glm::dvec3(inked_[owner].object_from_world * glm::dvec4(p, 1.0)));
            };
            pieces[owner].push_back({in_object(line.ends_world[0]), in_object(line.ends_world[1])});
        }
    }
    for (ObjectId id = 0; id < objects_.size(); ++id) {
        const LineObject& object = objects_[id];
        const bool is_needed = std::any_of(pens_[id].begin(), pens_[id].end(),
                                           [](const ObjectLineLook& pen) { return pen.look.far.is_on; });
        if (!is_needed) continue;
        inked_[id].crowding.emplace(crowding_lines(*object.surface, object.crease_rad, object.seams, pieces[id]));
    }
}

void LevelLines::append_groups(VectorObject& object, std::span<const VisibleLine> lines, const LineWidths& widths) const
{
    const VisibleLine& first = lines.front();
    const auto index = static_cast<std::size_t>(first.line_class);
    const double share = first.is_visible ? 1.0 : kHiddenWidth;
    for (const ObjectLineLook& pen : pens_[first.object]) {
        VectorGroup group{.line_type = line_class_name(first.line_class),
                          .is_hidden = !first.is_visible,
                          .width_px = pen.look.pens[index].width_px * share,
                          .opacity = first.is_visible ? 1.0 : kHiddenOpacity,
                          .colour_srgb = pen.look.pens[index].colour};
        for (const VisibleLine& line : lines) {
            for (VectorLine& piece : widths.pieces(line, pen, inked_[first.object])) {
                piece.width_px *= share;
                group.lines.push_back(std::move(piece));
            }
        }
        if (!group.lines.empty()) object.groups.push_back(std::move(group));
    }
}

VectorDrawing LevelLines::drawing(const std::vector<VisibleLine>& lines, const LineCamera& camera)
{
    if (inked_.empty()) find_crowding();
    const LineWidths widths(camera);
    VectorDrawing drawing{.size_px = camera.size_px};
    for (std::size_t begin = 0; begin < lines.size();) {
        const VisibleLine& first = lines[begin];
        std::size_t end = begin;
        while (end < lines.size() && lines[end].object == first.object && lines[end].line_class == first.line_class &&
               lines[end].is_visible == first.is_visible)
            ++end;
        if (begin == 0 || lines[begin - 1].object != first.object) drawing.objects.push_back({name(first.object), {}});
        append_groups(drawing.objects.back(), std::span(lines).subspan(begin, end - begin), widths);
        begin = end;
    }
    // What is hidden lies under what is seen.
    for (VectorObject& object : drawing.objects)
        std::stable_partition(object.groups.begin(), object.groups.end(),
                              [](const VectorGroup& group) { return group.is_hidden; });
    return drawing;
}

}  // namespace hw
