#include "hatchway/walk/world_lines.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <numeric>

#include "hatchway/world/visibility/tree/convex_cell.hpp"

namespace hw {
namespace {

constexpr double kLeavesWithin_m = 4.0;
constexpr std::size_t kMostLeaves = 500;
constexpr double kNear = 1e-4;  // of w: what is nearer is cut off

constexpr glm::vec4 kOwnColour{0.95f, 0.25f, 0.1f, 0.95f};
constexpr glm::vec4 kLeafColour{0.1f, 0.35f, 0.9f, 0.55f};
constexpr glm::vec4 kPortalColour{0.05f, 0.6f, 0.25f, 0.6f};
constexpr glm::vec4 kSeenColour{0.05f, 0.6f, 0.25f, 0.85f};
constexpr glm::vec4 kHiddenColour{0.85f, 0.15f, 0.15f, 0.45f};
constexpr glm::vec4 kWireColour{0.1f, 0.1f, 0.4f, 0.5f};
constexpr glm::vec4 kLeakColour{0.9f, 0.0f, 0.15f, 1.0f};

using Lines = std::vector<WorldLine>;

void add_polygon(Lines& lines, std::span<const glm::dvec3> corners, const glm::dvec3& origin, const glm::vec4& colour,
                 float width_px)
{
    for (std::size_t i = 0; i < corners.size(); ++i)
        lines.push_back({origin + corners[i], origin + corners[(i + 1) % corners.size()], colour, width_px});
}

/// Planes that bound a leaf, its side of each in front; metres from the grid's origin.
std::vector<FlowPlane> planes_around(const BspTree& tree, const std::vector<int>& parent_of_node,
                                     const std::vector<int>& parent_of_leaf, int leaf)
{
    std::vector<FlowPlane> planes;
    int child = ~leaf;
    for (int node = parent_of_leaf[static_cast<std::size_t>(leaf)]; node >= 0;) {
        const BspNode& here = tree.nodes[static_cast<std::size_t>(node)];
        const double sign = here.front == child ? 1.0 : -1.0;
        planes.push_back({sign * here.plane.unit_normal, sign * here.plane.unit_offset * tree.grid.step_m});
        child = node;
        node = parent_of_node[static_cast<std::size_t>(node)];
    }
    return planes;
}

void add_leaves(const BspTree& tree, const glm::dvec3& eye_world, Lines& lines)
{
    std::vector<int> parent_of_node(tree.nodes.size(), -1);
    std::vector<int> parent_of_leaf(static_cast<std::size_t>(tree.leaf_count), -1);
    for (std::size_t node = 0; node < tree.nodes.size(); ++node)
        for (const int child : {tree.nodes[node].front, tree.nodes[node].back})
            (child < 0 ? parent_of_leaf[static_cast<std::size_t>(~child)]
                       : parent_of_node[static_cast<std::size_t>(child)]) = static_cast<int>(node);
    const int own_leaf = leaf_at(tree, eye_world);
    std::vector<int> leaves;
    if (own_leaf < 0) {  // from outside all are looked at
        leaves.resize(static_cast<std::size_t>(tree.leaf_count));
        std::iota(leaves.begin(), leaves.end(), 0);
    }
    for (double reach = kLeavesWithin_m; leaves.empty() && reach > 0.01; reach *= 0.5)
        leaves = leaves_near(tree, eye_world, reach);
    std::erase_if(leaves, [&](int leaf) { return tree.is_solid[static_cast<std::size_t>(leaf)] != 0; });
    if (leaves.size() > kMostLeaves) leaves.resize(kMostLeaves);
    if (own_leaf >= 0 && std::find(leaves.begin(), leaves.end(), own_leaf) == leaves.end()) leaves.push_back(own_leaf);
    const int own = own_leaf < 0 ? kNone : tree.cluster_of_leaf[static_cast<std::size_t>(own_leaf)];
    const glm::dvec3 origin = tree.grid.origin_world;
    for (const int leaf : leaves) {
        ConvexCell cell(Box{tree.bounds_world.min - origin, tree.bounds_world.max - origin});
        for (const FlowPlane& plane : planes_around(tree, parent_of_node, parent_of_leaf, leaf))
            cell = cell.in_front_of(plane);
        const bool is_own = tree.cluster_of_leaf[static_cast<std::size_t>(leaf)] == own;
        for (const auto& face : cell.faces())
            add_polygon(lines, face, origin, is_own ? kOwnColour : kLeafColour, leaf == own_leaf ? 2.5f : 1.0f);
    }
}

/// Whether the eye lies within a hand of the portal's box: its place is then one of the portal's two.
bool is_at(const DirectedPortal& portal, const glm::dvec3& eye_world, const glm::dvec3& origin, double reach_m)
{
    Box box;
    for (const glm::dvec3& corner : portal.winding) box.add(origin + corner);
    return box.overlaps({eye_world - reach_m, eye_world + reach_m});
}

void add_portals(const Visibility& visibility, const glm::dvec3& eye_world, Lines& lines)
{
    constexpr double kOwnReach_m = 1.0;
    const glm::dvec3 origin = visibility.tree.grid.origin_world;
    for (const DirectedPortal& portal : visibility.portals.portals) {
        const bool is_own = is_at(portal, eye_world, origin, kOwnReach_m);
        add_polygon(lines, portal.winding, origin, is_own ? kOwnColour : kPortalColour, is_own ? 2.0f : 1.0f);
    }
}

void add_box(Lines& lines, const Box& box, const glm::dmat4& world_from_object, const glm::vec4& colour)
{
    std::array<glm::dvec3, 8> corners;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner((i & 1) ? box.max.x : box.min.x, (i & 2) ? box.max.y : box.min.y,
                                (i & 4) ? box.max.z : box.min.z);
        corners[static_cast<std::size_t>(i)] = glm::dvec3(world_from_object * glm::dvec4(corner, 1.0));
    }
    for (int i = 0; i < 8; ++i)
        for (const int axis : {1, 2, 4})
            if ((i & axis) == 0)
                lines.push_back(
                    {corners[static_cast<std::size_t>(i)], corners[static_cast<std::size_t>(i | axis)], colour, 1.0f});
}

void add_wire(Lines& lines, const MeshData& mesh, const MeshChunk& chunk, const glm::dmat4& world_from_object)
{
    for (std::uint32_t i = 0; i < chunk.index_count; ++i) {
        const std::uint32_t next = i % 3 == 2 ? i - 2 : i + 1;
        const auto corner = [&](std::uint32_t index) {
            const glm::dvec3 position(mesh.positions[mesh.indices[chunk.first_index + index]]);
            return glm::dvec3(world_from_object * glm::dvec4(position, 1.0));
        };
        lines.push_back({corner(i), corner(next), kWireColour, 1.0f});
    }
}

void add_chunks(const LevelWorld& world, const Visibility& visibility, const WorldLineKinds& kinds,
                const glm::dvec3& eye_world, Lines& lines)
{
    std::vector<std::uint8_t> is_seen;
    visible_chunks(visibility, eye_world, 0.0, is_seen);
    const Scene& scene = world.scene;
    for (std::size_t i = 0; i < is_seen.size(); ++i) {
        const ChunkSlot& slot = visibility.slots[i];
        const std::size_t mesh = static_cast<std::size_t>(scene.objects[slot.object].mesh);
        const MeshChunk& chunk = world.chunks[mesh][slot.chunk];
        const glm::dmat4& world_from_object = scene.world_from_object(slot.object);
        if (kinds.has_pvs)
            add_box(lines, chunk.bounds_object, world_from_object, is_seen[i] ? kSeenColour : kHiddenColour);
        if (kinds.has_wire && is_seen[i]) add_wire(lines, scene.meshes[mesh], chunk, world_from_object);
    }
}

}  // namespace

std::vector<WorldLine> visibility_lines(const LevelWorld& world, const Visibility& visibility,
                                        const WorldLineKinds& kinds, const View& view)
{
    Lines lines;
    if (kinds.has_pvs || kinds.has_wire) add_chunks(world, visibility, kinds, view.eye_world, lines);
    if (kinds.has_portals) add_portals(visibility, view.eye_world, lines);
    if (kinds.has_leaves) add_leaves(visibility.tree, view.eye_world, lines);
    return lines;
}

std::vector<WorldLine> leak_lines(std::span<const Leak> leaks)
{
    constexpr double kArm_m = 0.25;
    Lines lines;
    for (const Leak& leak : leaks) {
        for (std::size_t i = 0; i + 1 < leak.points_world.size(); ++i)
            lines.push_back({leak.points_world[i], leak.points_world[i + 1], kLeakColour, 3.0f});
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 arm(0.0);
            arm[axis] = kArm_m;
            lines.push_back({leak.opening_world - arm, leak.opening_world + arm, kLeakColour, 2.0f});
        }
    }
    return lines;
}

std::vector<OverlayLine> projected(std::span<const WorldLine> lines, const View& view, const glm::vec2& size_px)
{
    const glm::dmat4 clip_from_relative =
        glm::dmat4(view.clip_from_view) * glm::dmat4(glm::dmat3(glm::dmat4(view.view_from_world)));
    std::vector<OverlayLine> result;
    for (const WorldLine& line : lines) {
        glm::dvec4 a = clip_from_relative * glm::dvec4(line.from_world - view.eye_world, 1.0);
        glm::dvec4 b = clip_from_relative * glm::dvec4(line.to_world - view.eye_world, 1.0);
        if (a.w < kNear && b.w < kNear) continue;
        if (a.w < kNear) a += (b - a) * ((kNear - a.w) / (b.w - a.w));
        if (b.w < kNear) b += (a - b) * ((kNear - b.w) / (a.w - b.w));
        const auto in_picture = [&](const glm::dvec4& p) {
            // Far outside lies far outside: floats and rasterisers have their limits.
            const glm::dvec2 place = glm::clamp(glm::dvec2(p) / p.w, -100.0, 100.0);
            return glm::vec2(0.5 * (place.x + 1.0), 0.5 * (1.0 - place.y)) * size_px;
        };
        result.push_back({in_picture(a), in_picture(b), line.colour, line.width_px});
    }
    return result;
}

}  // namespace hw
