#include "hatchway/world/scene_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "hatchway/world/mesh_pieces.hpp"

namespace hw {
namespace {

constexpr double kFar = 100.0;  // distances from the middle, by those of what lies together
constexpr double kApart = 30.0;
constexpr double kMainShare = 0.75;  // of all triangles
constexpr double kPlaceShare = 0.02;

struct Piece {
    Box bounds_world;
    ObjectId object = 0;
    double triangles = 0.0;
};

std::vector<Piece> pieces_of(const Scene& scene)
{
    std::vector<std::vector<MeshPiece>> parts;
    for (const MeshData& mesh : scene.meshes) parts.push_back(mesh_pieces(mesh));
    std::vector<Piece> pieces;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const Object& object = scene.objects[id];
        if (object.bounds_world.is_empty()) continue;
        const std::vector<MeshPiece>& own = parts[object.mesh];
        for (const MeshPiece& part : own)
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

std::vector<double> reach_of(const std::vector<Box>& boxes, const glm::dvec3& middle)
{
    std::vector<double> reach;
    for (const Box& box : boxes) reach.push_back(farthest(box, middle));
    return reach;
}

/// Of what reaches no farther; the scene's own bounds, to the last bit, where that is all.
Box box_within(const ScenePlaces& places, const std::vector<double>& reach, double end)
{
    if (std::ranges::all_of(reach, [&](double r) { return r <= end; })) return places.bounds_world;
    Box box;
    for (std::size_t i = 0; i < reach.size(); ++i)
        if (reach[i] <= end) box.add(places.boxes_world[i]);
    return box;
}

double triangles_within(const ScenePlaces& places, const std::vector<double>& reach, double end)
{
    double count = 0.0;
    for (std::size_t i = 0; i < reach.size(); ++i) count += reach[i] <= end ? places.triangles[i] : 0.0;
    return count;
}

bool is_away(const Box& box, const Box& from)
{
    const glm::dvec3 gap = glm::max(box.min - from.max, from.min - box.max);
    return std::max({gap.x, gap.y, gap.z}) > glm::length(from.size());
}

/// Flat, and so large that what stands there is a trifle.
bool is_endless_ground(const Box& box, const Box& under)
{
    const glm::dvec3 size = box.size();
    const double width = glm::length(size);
    return width > 100.0 * glm::length(under.size()) && std::min({size.x, size.y, size.z}) < 0.01 * width;
}

/// How far from the middle what lies together there reaches: with this share of all triangles or more, up to a gap of
/// that factor beyond which all is far away, or a ground without end. A room belongs to what is in it.
double reach_of_place(const ScenePlaces& places, const std::vector<double>& reach, double share, double factor)
{
    const double enough = share * std::accumulate(places.triangles.begin(), places.triangles.end(), 0.0);
    double end = end_of_group(reach, 0.0, factor);
    for (double next = end;; end = next) {
        const Box box = box_within(places, reach, end);
        bool is_whole = triangles_within(places, reach, end) >= enough;
        for (std::size_t i = 0; i < reach.size() && is_whole; ++i) {
            const Box& other = places.boxes_world[i];
            is_whole = reach[i] <= end || is_away(other, box) || is_endless_ground(other, box);
        }
        next = end_of_group(reach, end, factor);
        if (is_whole || next == end) return end;
    }
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
    ScenePlaces places;
    places.bounds_world = scene.bounds_world;
    for (const Piece& piece : pieces) {
        places.boxes_world.push_back(piece.bounds_world);
        places.triangles.push_back(piece.triangles);
    }
    const std::vector<double> reach = reach_of(places.boxes_world, median(pieces));
    const double end = reach_of_place(places, reach, kMainShare, kFar);
    places.main_world = box_within(places, reach, end);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const bool is_stray = reach[i] > end && is_away(pieces[i].bounds_world, places.main_world);
        const bool is_known = !places.strays.empty() && places.strays.back() == pieces[i].object;
        if (is_stray && !is_known) places.strays.push_back(pieces[i].object);
    }
    return places;
}

Box place_around(const ScenePlaces& places, const glm::dvec3& eye_world)
{
    const std::vector<double> from_eye = reach_of(places.boxes_world, eye_world);
    if (from_eye.empty()) return places.bounds_world;
    const auto nearest = static_cast<std::size_t>(std::ranges::min_element(from_eye) - from_eye.begin());
    const std::vector<double> reach = reach_of(places.boxes_world, places.boxes_world[nearest].centre());
    return box_within(places, reach, reach_of_place(places, reach, kPlaceShare, kApart));
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
