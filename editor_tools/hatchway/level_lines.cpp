#include "hatchway/level_lines.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>

#include "hatchway/scene_surfaces.hpp"

namespace hw {
namespace {

constexpr float kPaperCreaseRad = 0.6981317f;  // 40 degrees
constexpr double kHiddenWidth = 0.6;           // of a hidden line, and its opacity: it stays behind what is seen
constexpr double kHiddenOpacity = 0.5;
constexpr double kThinnestPx = 0.05;  // what is thinner is gone

/// Mean length of the lines that an object draws from every viewpoint, object space.
double mean_line_length(const LineObject& object)
{
    const Surface& surface = *object.surface;
    const EdgeClasses classes = classes_at(surface, object.crease_rad);
    double sum = 0.0;
    std::uint64_t count = 0;
    const auto add = [&](EdgeRange range) {
        for (std::uint32_t edge = range.begin; edge < range.end; ++edge) {
            const auto [a, b] = edge_vertices(surface, edge);
            sum += glm::distance(surface.positions[a], surface.positions[b]);
            ++count;
        }
    };
    add(classes.borders);
    for (const EdgeRange range : classes.artist) add(range);
    for (const EdgeRange range : classes.ridges) add(range);
    for (const EdgeRange range : classes.valleys) add(range);
    return sum / static_cast<double>(std::max<std::uint64_t>(count, 1));
}

double smooth_step(double from, double to, double x)
{
    const double t = std::clamp((x - from) / std::max(to - from, 1e-12), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

LineLook paper_look(float crease_rad)
{
    LineLook look;
    look.crease_rad = crease_rad;
    look.far.is_on = false;
    return look;
}

}  // namespace

const char* line_type_name(VisibleLineClass line_class)
{
    constexpr std::array<const char*, kLineClassCount> kNames{"silhouette", "ridge",  "valley",
                                                              "border",     "artist", "intersection"};
    return kNames[static_cast<std::size_t>(line_class)];
}

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

LevelLines::LevelLines(const Scene& scene, std::vector<ObjectInk> inks, std::optional<float> crease_rad)
    : scene_(scene), surfaces_(scene_surfaces(scene)), pens_(scene.objects.size())
{
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const Material& material = scene.materials[scene.objects[id].material];
        objects_.push_back({.surface = &surfaces_[scene.objects[id].mesh],
                            .world_from_object = scene.world_from_object(id),
                            .hides = material.alpha_mode != AlphaMode::blend,
                            .is_culled = !inks.empty() && !material.is_double_sided});
    }
    if (inks.empty()) {
        for (ObjectId id = 0; id < scene.objects.size(); ++id) {
            objects_[id].hides = true;
            objects_[id].crease_rad = crease_rad.value_or(kPaperCreaseRad);
            pens_[id] = {{paper_look(objects_[id].crease_rad), 1.0}};
        }
    } else {
        take_inks(inks, crease_rad);
        find_object_seams(inks);
    }
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const double scale = std::cbrt(std::abs(glm::determinant(glm::dmat3(scene.world_from_object(id)))));
        mean_length_m_.push_back(static_cast<float>(scale * mean_line_length(objects_[id])));
    }
}

void LevelLines::take_inks(const std::vector<ObjectInk>& inks, std::optional<float> crease_rad)
{
    for (ObjectId id = 0; id < objects_.size(); ++id) {
        LineObject& object = objects_[id];
        pens_[id] = inks[id].looks;
        object.is_drawn = !pens_[id].empty();
        object.with_intersections = inks[id].has_intersections;
        if (!object.is_drawn) continue;
        // Styles of one object that want different creases share the finer one: their lines lie on each other.
        object.crease_rad = pens_[id][0].look.crease_rad;
        for (const ObjectLineLook& pen : pens_[id])
            object.crease_rad = std::min(object.crease_rad, pen.look.crease_rad);
        if (crease_rad) object.crease_rad = *crease_rad;
    }
}

void LevelLines::find_object_seams(const std::vector<ObjectInk>& inks)
{
    std::vector<SeamObject> together;
    std::vector<ObjectId> ids;
    float crease_rad = 3.2f;
    for (ObjectId id = 0; id < objects_.size(); ++id) {
        if (!inks[id].is_used) continue;
        together.push_back({objects_[id].surface, objects_[id].world_from_object, inks[id].style_group});
        ids.push_back(id);
        crease_rad = std::min({crease_rad, inks[id].crease_rad, objects_[id].crease_rad});
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

double LevelLines::width_at(const VisibleLine& line, const ObjectLineLook& pen, const LineCamera& camera) const
{
    const auto index = static_cast<std::size_t>(line.line_class);
    if (!pen.look.is_drawn[index]) return 0.0;
    double width = pen.presence * pen.look.width_px[index];
    const double focal_px = 0.5 * camera.size_px.y / std::tan(0.5 * camera.fov_rad);
    double distance_m = 0.0;  // of the line's points, on the average
    for (std::size_t i = 0; i < line.points_px.size(); ++i) {
        const glm::dvec2 aside = (line.points_px[i] - 0.5 * glm::dvec2(camera.size_px)) / focal_px;
        distance_m += std::sqrt(1.0 + glm::dot(aside, aside)) / line.inverse_depths[i];
    }
    distance_m /= static_cast<double>(line.points_px.size());
    if (pen.look.depth_taper > 0.0f && distance_m > pen.look.taper_from_m)
        width *= glm::mix(1.0, pen.look.taper_from_m / distance_m, static_cast<double>(pen.look.depth_taper));
    if (pen.look.far.is_on && line.line_class != VisibleLineClass::silhouette) {
        const double spacing_px = mean_length_m_[line.object] * focal_px / distance_m;
        width *= smooth_step(pen.look.far.none_spacing_px, pen.look.far.full_spacing_px, spacing_px);
    }
    return width;
}

void LevelLines::append_groups(VectorObject& object, const std::vector<VisibleLine>& lines, std::size_t begin,
                               std::size_t end, const LineCamera& camera) const
{
    const auto index = static_cast<std::size_t>(lines[begin].line_class);
    for (const ObjectLineLook& pen : pens_[lines[begin].object]) {
        VectorGroup group{.line_type = line_type_name(lines[begin].line_class),
                          .is_hidden = !lines[begin].is_visible,
                          .width_px = pen.look.width_px[index] * (lines[begin].is_visible ? 1.0 : kHiddenWidth),
                          .opacity = lines[begin].is_visible ? 1.0 : kHiddenOpacity,
                          .colour_srgb = pen.look.colour[index]};
        for (std::size_t i = begin; i < end; ++i) {
            const double width = width_at(lines[i], pen, camera) * (lines[i].is_visible ? 1.0 : kHiddenWidth);
            if (width >= kThinnestPx) group.lines.push_back({lines[i].points_px, lines[i].is_closed, width});
        }
        if (!group.lines.empty()) object.groups.push_back(std::move(group));
    }
}

VectorDrawing LevelLines::drawing(const std::vector<VisibleLine>& lines, const LineCamera& camera) const
{
    VectorDrawing drawing{.size_px = camera.size_px};
    for (std::size_t begin = 0; begin < lines.size();) {
        const VisibleLine& first = lines[begin];
        std::size_t end = begin;
        while (end < lines.size() && lines[end].object == first.object && lines[end].line_class == first.line_class &&
               lines[end].is_visible == first.is_visible)
            ++end;
        if (begin == 0 || lines[begin - 1].object != first.object) drawing.objects.push_back({name(first.object), {}});
        append_groups(drawing.objects.back(), lines, begin, end, camera);
        begin = end;
    }
    // What is hidden lies under what is seen.
    for (VectorObject& object : drawing.objects)
        std::stable_partition(object.groups.begin(), object.groups.end(),
                              [](const VectorGroup& group) { return group.is_hidden; });
    return drawing;
}

}  // namespace hw
