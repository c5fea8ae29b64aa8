#include "hatchway/world/scene_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "hatchway/world/mesh_parts.hpp"

namespace hw {
namespace {

constexpr double kFar = 100.0;       // distances from the middle, by those of what lies together
constexpr double kMainShare = 0.75;  // of all triangles

struct Piece {
    Box bounds_world;
    ObjectId object = 0;
    double triangles = 0.0;
};

std::vector<Piece> pieces_of(const Scene& scene)
{
    std::vector<std::vector<MeshPart>> parts;
    for (const MeshData& mesh : scene.meshes) parts.push_back(mesh_parts(mesh));
    std::vector<Piece> pieces;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const Object& object = scene.objects[id];
        if (object.bounds_world.is_empty()) continue;
        const std::vector<MeshPart>& own = parts[object.mesh];
        for (const MeshPart& part : own)
            pieces.push_back(
                {own.size() == 1 ? object.bounds_world : transformed(part.bounds, scene.world_from_object(id)), id,
                 static_cast<double>(part.triangles)});
    }
    return pieces;
}

double triangle_count(const std::vector<Piece>& pieces)
{
    double count = 0.0;
    for (const Piece& piece : pieces) count += piece.triangles;
    return count;
}

/// Along each axis as many triangles before as after, as if all of a piece were at its middle: no stray moves it far.
glm::dvec3 median(std::vector<Piece> pieces)
{
    const double half = 0.5 * triangle_count(pieces);
    glm::dvec3 result(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        std::ranges::stable_sort(pieces, {}, [&](const Piece& piece) { return piece.bounds_world.centre()[axis]; });
        double before = 0.0;
        for (std::size_t i = 0; i < pieces.size() && before < half; ++i) {
            before += pieces[i].triangles;
            result[axis] = pieces[i].bounds_world.centre()[axis];
        }
    }
    return result;
}

/// How far from the middle the main place reaches.
double main_reach(const std::vector<Piece>& pieces, const std::vector<double>& reach)
{
    const double enough = kMainShare * triangle_count(pieces);
    double end = 0.0;
    for (double inside = 0.0; inside < enough;) {
        end = end_of_group(reach, end, kFar);
        inside = 0.0;
        for (std::size_t i = 0; i < pieces.size(); ++i) inside += reach[i] <= end ? pieces[i].triangles : 0.0;
    }
    return end;
}

/// Not what others stand on, or what surrounds them.
bool is_away(const Box& box, const Box& main_world)
{
    const glm::dvec3 gap = glm::max(box.min - main_world.max, main_world.min - box.max);
    return std::max({gap.x, gap.y, gap.z}) > glm::length(main_world.size());
}

}  // namespace

double end_of_group(std::span<const double> values, double from, double factor)
{
    double end = from;
    for (const double value : values)
        if (value > from && (end == from || value < end)) end = value;
    for (double before = from; end > before;) {
        before = end;
        for (const double value : values)
            if (value <= factor * before) end = std::max(end, value);
    }
    return end;
}

double farthest(const Box& box, const glm::dvec3& point)
{
    return glm::length(glm::max(glm::abs(box.min - point), glm::abs(box.max - point)));
}

ScenePlaces find_places(const Scene& scene)
{
    const std::vector<Piece> pieces = pieces_of(scene);
    const glm::dvec3 middle = median(pieces);
    std::vector<double> reach;
    for (const Piece& piece : pieces) reach.push_back(farthest(piece.bounds_world, middle));
    const double end = main_reach(pieces, reach);
    ScenePlaces places;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        places.boxes_world.push_back(pieces[i].bounds_world);
        if (reach[i] <= end) places.main_world.add(pieces[i].bounds_world);
    }
    if (std::ranges::all_of(reach, [&](double r) { return r <= end; })) places.main_world = scene.bounds_world;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const bool is_stray = reach[i] > end && is_away(pieces[i].bounds_world, places.main_world);
        const bool is_known = !places.strays.empty() && places.strays.back() == pieces[i].object;
        if (is_stray && !is_known) places.strays.push_back(pieces[i].object);
    }
    return places;
}

std::optional<std::string> stray_doubt(const ScenePlaces& places, const Scene& scene)
{
    if (places.strays.empty()) return std::nullopt;
    const std::string& path = scene.nodes[scene.objects[places.strays.front()].node].path;
    const std::size_t others = places.strays.size() - 1;
    return fmt::format(
        "{}: \"{}\"{} far away from all else, which is {:.3g} m wide: pictures of the whole scene show the rest; to "
        "leave it out everywhere, say \"visible\": false of it",
        scene.file, path,
        others == 0   ? " lies, or has a part,"
        : others == 1 ? " and one object more lie"
                      : fmt::format(" and {} objects more lie", others),
        glm::length(places.main_world.size()));
}

}  // namespace hw
