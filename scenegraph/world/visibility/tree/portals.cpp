// A node's portal is its plane within its cell, handed down both subtrees: a piece that arrives in leaf F in front and
// in leaf B behind is all of their contact. Everything up to the cutting away of covered parts is exact; the rounded
// hull of what remains may only be larger.
#include "hatchway/world/visibility/tree/portals.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

constexpr std::size_t kMostPieces = 2000;       // of one contact, that covers cut it into
constexpr std::size_t kMostSteps = 20'000'000;  // covers x pieces, of all contacts

using Pieces = std::vector<PlanePolygon>;
using Opening = std::vector<glm::dvec3>;

/// Hands a polygon down a subtree; calls arrive(piece, leaf).
template <typename Arrive>
void push_down(const BspBuild& build, int child, PlanePolygon polygon, const Arrive& arrive)
{
    while (child >= 0) {
        const BspNode& node = build.tree.nodes[static_cast<std::size_t>(child)];
        const int plane = build.plane_of_node[static_cast<std::size_t>(child)];
        const PolygonSigns signs = polygon_signs(build.planes, polygon, plane);
        HW_ASSERT(signs.has_front || signs.has_back);
        if (signs.has_front && signs.has_back) {
            push_down(build, node.front, clipped(build.planes, polygon, {plane, false}), arrive);
            polygon = clipped(build.planes, polygon, {plane, true});
        }
        child = signs.has_back ? node.back : node.front;
    }
    arrive(std::move(polygon), ~child);
}

bool is_outside(const PlaneSet& planes, const PlanePolygon& polygon, SidePlane side)
{
    const PolygonSigns signs = polygon_signs(planes, polygon, side.plane);
    return side.is_flipped ? !signs.has_back : !signs.has_front;
}

/// Two convex polygons of one plane whose interiors do not meet: a side of one has all of the other outside.
bool are_apart(const PlaneSet& planes, const PlanePolygon& a, const PlanePolygon& b)
{
    const auto parts_them = [&](const PlanePolygon& one, const PlanePolygon& other) {
        return std::any_of(one.sides.begin(), one.sides.end(),
                           [&](SidePlane side) { return is_outside(planes, other, side); });
    };
    return parts_them(a, b) || parts_them(b, a);
}

/// Appends what is left of `piece` beside `cover`.
void subtract(const PlaneSet& planes, PlanePolygon piece, const PlanePolygon& cover, Pieces& left)
{
    if (are_apart(planes, piece, cover)) {
        left.push_back(std::move(piece));
        return;
    }
    for (const SidePlane side : cover.sides) {
        const PolygonSigns signs = polygon_signs(planes, piece, side.plane);
        if (!signs.has_front || !signs.has_back) continue;  // all inside: it is not apart
        left.push_back(clipped(planes, piece, {side.plane, !side.is_flipped}));
        piece = clipped(planes, piece, side);
    }
}

/// Where the steps run out, what is left of the covers covers nothing: more is open, never less.
Pieces uncovered(const BspBuild& build, const PlanePolygon& contact, const std::vector<BlockingPolygon>& covers,
                 bool from_front, std::size_t& steps_left)
{
    Pieces pieces{contact};
    for (const BlockingPolygon& cover : covers) {
        if (!(from_front ? cover.blocks_from_front : cover.blocks_from_back)) continue;
        if (pieces.size() > kMostPieces || steps_left < pieces.size()) {
            steps_left = 0;
            break;
        }
        steps_left -= pieces.size();
        Pieces left;
        for (PlanePolygon& piece : pieces) subtract(build.planes, std::move(piece), cover.polygon, left);
        pieces = std::move(left);
        if (pieces.empty()) break;
    }
    return pieces;
}

/// The least distance between two parallel lines of the plane that hold the polygon between them.
double width_of(const Opening& winding, const glm::dvec3& normal)
{
    double width = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < winding.size(); ++i) {
        const glm::dvec3 side = winding[(i + 1) % winding.size()] - winding[i];
        const double length = glm::length(side);
        if (length <= 0.0) continue;
        const glm::dvec3 across = glm::cross(normal, side / length);
        double least = 0.0;
        double most = 0.0;
        for (const glm::dvec3& corner : winding) {
            const double distance = glm::dot(across, corner - winding[i]);
            least = std::min(least, distance);
            most = std::max(most, distance);
        }
        width = std::min(width, most - least);
    }
    return width;
}

/// The pieces as windings in metres; cracks are left out.
std::vector<Opening> openings(const Pieces& pieces, const ExactPlane& plane, const Grid& grid)
{
    const double crack_width = grid.scaled(kCrackWidth);
    std::vector<Opening> result;
    for (const PlanePolygon& piece : pieces) {
        Opening winding;
        for (const glm::dvec3& corner : piece.corners) winding.push_back(corner * grid.step_m);
        if (width_of(winding, plane.unit_normal) >= crack_width) result.push_back(std::move(winding));
    }
    return result;
}

/// What bounds each leaf, square metres, and which leaves are open to each other both ways.
struct Surroundings {
    std::vector<double> faces;
    std::vector<double> backs;
    std::vector<int> room;

    explicit Surroundings(int leaf_count)
        : faces(static_cast<std::size_t>(leaf_count)), backs(faces.size()), room(faces.size())
    {
        std::iota(room.begin(), room.end(), 0);
    }
    int room_of(int leaf)
    {
        while (room[static_cast<std::size_t>(leaf)] != leaf) {
            int& up = room[static_cast<std::size_t>(leaf)];
            up = room[static_cast<std::size_t>(up)];
            leaf = up;
        }
        return leaf;
    }
    void join(int a, int b)
    {
        a = room_of(a);
        b = room_of(b);
        room[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
    /// The covered areas of a contact, seen from the one leaf and from the other.
    void add(int leaf, double covered_here, double covered_there)
    {
        faces[static_cast<std::size_t>(leaf)] += covered_here;
        backs[static_cast<std::size_t>(leaf)] += std::max(0.0, covered_there - covered_here);
    }
    std::vector<std::uint8_t> solid()
    {
        std::vector<double> room_faces(faces.size());
        std::vector<double> room_backs(faces.size());
        for (std::size_t leaf = 0; leaf < faces.size(); ++leaf) {
            const std::size_t base = static_cast<std::size_t>(room_of(static_cast<int>(leaf)));
            room_faces[base] += faces[leaf];
            room_backs[base] += backs[leaf];
        }
        std::vector<std::uint8_t> result(faces.size());
        for (std::size_t leaf = 0; leaf < faces.size(); ++leaf) {
            const std::size_t base = static_cast<std::size_t>(room_of(static_cast<int>(leaf)));
            result[leaf] = room_faces[base] < room_backs[base] ? 1 : 0;
        }
        return result;
    }
};

double total_area(const Pieces& pieces)
{
    double sum = 0.0;
    for (const PlanePolygon& piece : pieces) sum += area(piece);
    return sum;
}

LeafContact make_contact(const BspBuild& build, std::size_t node, const PlanePolygon& polygon, int front_leaf,
                         int back_leaf, Surroundings& surroundings, std::size_t& steps_left)
{
    const ExactPlane& plane = build.tree.nodes[node].plane;
    const double step_m = build.tree.grid.step_m;
    const std::vector<BlockingPolygon>& covers = build.polygons_of_node[node];
    const Pieces backward = uncovered(build, polygon, covers, true, steps_left);
    const Pieces forward = uncovered(build, polygon, covers, false, steps_left);
    const double whole = area(polygon);
    LeafContact contact{node,
                        front_leaf,
                        back_leaf,
                        whole * step_m * step_m,
                        {},
                        openings(backward, plane, build.tree.grid),
                        openings(forward, plane, build.tree.grid)};
    for (const glm::dvec3& corner : polygon.corners) contact.bounds.add(corner * step_m);
    if (!contact.backward.empty() && !contact.forward.empty()) surroundings.join(front_leaf, back_leaf);

    const double seen_from_front = whole - total_area(backward);
    const double seen_from_back = whole - total_area(forward);
    surroundings.add(front_leaf, seen_from_front, seen_from_back);
    surroundings.add(back_leaf, seen_from_back, seen_from_front);
    return contact;
}

void add_node(BspBuild& build, int child, std::vector<SidePlane>& ancestors, Surroundings& surroundings,
              std::size_t& steps_left, std::vector<LeafContact>& contacts)
{
    if (child < 0) return;
    const std::size_t index = static_cast<std::size_t>(child);
    const int plane = build.plane_of_node[index];
    PlanePolygon polygon = plane_within_box(build.planes, plane, build.box_min, build.box_max);
    for (const SidePlane ancestor : ancestors) {
        const PolygonSigns signs = polygon_signs(build.planes, polygon, ancestor.plane);
        if (signs.has_front && signs.has_back) polygon = clipped(build.planes, polygon, ancestor);
    }
    const BspNode node = build.tree.nodes[index];
    push_down(build, node.front, std::move(polygon), [&](PlanePolygon in_front, int front_leaf) {
        push_down(build, node.back, std::move(in_front), [&](PlanePolygon piece, int back_leaf) {
            contacts.push_back(make_contact(build, index, piece, front_leaf, back_leaf, surroundings, steps_left));
        });
    });
    ancestors.push_back({plane, false});
    add_node(build, node.front, ancestors, surroundings, steps_left, contacts);
    ancestors.back().is_flipped = true;
    add_node(build, node.back, ancestors, surroundings, steps_left, contacts);
    ancestors.pop_back();
}

/// Takes back what a sight line can get into after all: solid is only what nothing open leads to.
void keep_unreachable(const std::vector<LeafContact>& contacts, std::vector<std::uint8_t>& is_solid)
{
    std::vector<std::vector<int>> open_to(is_solid.size());
    for (const LeafContact& contact : contacts) {
        if (!contact.backward.empty())
            open_to[static_cast<std::size_t>(contact.front_leaf)].push_back(contact.back_leaf);
        if (!contact.forward.empty())
            open_to[static_cast<std::size_t>(contact.back_leaf)].push_back(contact.front_leaf);
    }
    std::vector<int> pending;
    for (std::size_t leaf = 0; leaf < is_solid.size(); ++leaf) {
        if (!is_solid[leaf]) pending.push_back(static_cast<int>(leaf));
    }
    while (!pending.empty()) {
        const int leaf = pending.back();
        pending.pop_back();
        for (const int next : open_to[static_cast<std::size_t>(leaf)]) {
            if (!is_solid[static_cast<std::size_t>(next)]) continue;
            is_solid[static_cast<std::size_t>(next)] = 0;
            pending.push_back(next);
        }
    }
}

}  // namespace

std::vector<LeafContact> leaf_contacts(BspBuild& build)
{
    std::vector<SidePlane> ancestors;
    std::vector<LeafContact> contacts;
    Surroundings surroundings(build.tree.leaf_count);
    std::size_t steps_left = kMostSteps;
    if (!build.tree.nodes.empty()) add_node(build, 0, ancestors, surroundings, steps_left, contacts);
    build.are_covers_complete = steps_left > 0;
    build.tree.is_solid = surroundings.solid();
    keep_unreachable(contacts, build.tree.is_solid);
    return contacts;
}

}  // namespace hw
