#include "measure/frame/scale_level.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <map>
#include <span>
#include <vector>

#include "hatchway/core/files/files.hpp"

namespace hw::measure {
namespace {

// Metres, and multiples of an eighth, so that walls meet exactly.
constexpr double kRoom = 6.0;
constexpr double kHeight = 3.0;
constexpr double kWall = 0.25;
constexpr double kDoorWidth = 1.0;
constexpr double kDoorHeight = 2.125;
constexpr double kDoorAside = 1.75;  // from the middle of the wall, to one side and the other in turn
constexpr int kVessels = 6;
constexpr int kSegments = 37;
constexpr int kBands = 7;  // 37 * (2 * 7 - 2) = 444 triangles

struct PartMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<std::uint32_t> indices;
};

void add_quad(PartMesh& mesh, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const glm::vec3 normal(glm::normalize(glm::cross(b - a, c - a)));
    for (const glm::dvec3& corner : {a, b, c, d}) {
        mesh.positions.emplace_back(corner);
        mesh.normals.push_back(normal);
    }
    for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
}

void add_box(PartMesh& mesh, const glm::dvec3& low, const glm::dvec3& high)
{
    const auto at = [&](int i) {
        return glm::dvec3((i & 1) ? high.x : low.x, (i & 2) ? high.y : low.y, (i & 4) ? high.z : low.z);
    };
    for (const auto& [a, b, c, d] :
         {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
        add_quad(mesh, at(a), at(b), at(c), at(d));
}

/// A wall along x or z from `from` to `to`, at `place` across, with or without a doorway.
struct WallPlan {
    bool is_along_x = false;
    double from = 0.0, to = 0.0, place = 0.0;
    bool has_door = false;
    double door = 0.0;
};

void add_wall(PartMesh& mesh, const WallPlan& plan)
{
    const auto part = [&](double from, double to, double low, double high) {
        if (plan.is_along_x)
            add_box(mesh, {from, low, plan.place}, {to, high, plan.place + kWall});
        else
            add_box(mesh, {plan.place, low, from}, {plan.place + kWall, high, to});
    };
    if (!plan.has_door) return part(plan.from, plan.to, 0.0, kHeight);
    const double left = plan.door - 0.5 * kDoorWidth;
    const double right = plan.door + 0.5 * kDoorWidth;
    part(plan.from, left, 0.0, kHeight);
    part(right, plan.to, 0.0, kHeight);
    part(left, right, kDoorHeight, kHeight);
}

/// What decides how a room's shell looks.
struct ShellKind {
    bool is_first_column = false, is_last_column = false, is_first_row = false, is_last_row = false;
    bool is_odd_column = false, is_odd_row = false;
    auto operator<=>(const ShellKind&) const = default;
};

/// Floor, ceiling, and the walls at low x and low z, those at high x and z only at the level's border.
PartMesh shell(const ShellKind& kind)
{
    PartMesh mesh;
    add_box(mesh, {0, -kWall, 0}, {kRoom + kWall, 0, kRoom + kWall});
    add_box(mesh, {0, kHeight, 0}, {kRoom + kWall, kHeight + kWall, kRoom + kWall});
    const double middle = 0.5 * (kRoom + kWall);
    const double door_z = middle + (kind.is_odd_column ? kDoorAside : -kDoorAside);
    const double door_x = middle + (kind.is_odd_row ? kDoorAside : -kDoorAside);
    add_wall(mesh, {false, 0, kRoom + kWall, 0, !kind.is_first_column, door_z});
    add_wall(mesh, {true, kWall, kRoom, 0, !kind.is_first_row, door_x});
    if (kind.is_last_column) add_wall(mesh, {false, 0, kRoom + kWall, kRoom, false, 0});
    if (kind.is_last_row) add_wall(mesh, {true, kWall, kRoom, kRoom, false, 0});
    return mesh;
}

/// A closed vessel turned about y; its profile depends on `kind`.
PartMesh vessel(int kind)
{
    PartMesh mesh;
    const auto radius = [&](int ring) {
        if (ring == 0 || ring == kBands) return 0.0;
        return 0.25 + 0.1 * std::sin(1.3 * ring + 0.9 * kind);
    };
    std::vector<std::uint32_t> first_of_ring;
    for (int ring = 0; ring <= kBands; ++ring) {
        first_of_ring.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        const int count = ring == 0 || ring == kBands ? 1 : kSegments;
        for (int i = 0; i < count; ++i) {
            const double angle = 2.0 * glm::pi<double>() * i / kSegments;
            const glm::dvec3 outward(std::cos(angle), 0.0, -std::sin(angle));
            const double y = 1.2 * ring / kBands;
            mesh.positions.emplace_back(outward * radius(ring) + glm::dvec3(0, y, 0));
            mesh.normals.emplace_back(ring == 0        ? glm::dvec3(0, -1, 0)
                                      : ring == kBands ? glm::dvec3(0, 1, 0)
                                                       : outward);
        }
    }
    const auto corner = [&](int ring, int i) {
        const bool is_end = ring == 0 || ring == kBands;
        return first_of_ring[static_cast<std::size_t>(ring)] + static_cast<std::uint32_t>(is_end ? 0 : i % kSegments);
    };
    for (int band = 0; band < kBands; ++band) {
        for (int i = 0; i < kSegments; ++i) {
            const std::uint32_t a = corner(band, i), b = corner(band, i + 1);
            const std::uint32_t c = corner(band + 1, i + 1), d = corner(band + 1, i);
            if (a != b) mesh.indices.insert(mesh.indices.end(), {a, b, c});
            if (c != d) mesh.indices.insert(mesh.indices.end(), {a, c, d});
        }
    }
    return mesh;
}

/// A .glb under construction.
class GlbText {
 public:
    int add_mesh(const PartMesh& part, const std::string& name)
    {
        glm::vec3 low = part.positions[0], high = low;
        for (const glm::vec3& p : part.positions) low = glm::min(low, p), high = glm::max(high, p);
        const std::string bounds =
            fmt::format(R"(,"min":[{},{},{}],"max":[{},{},{}])", low.x, low.y, low.z, high.x, high.y, high.z);
        const int position =
            add_accessor(std::as_bytes(std::span(part.positions)), 5126, part.positions.size(), "VEC3", bounds);
        const int normal = add_accessor(std::as_bytes(std::span(part.normals)), 5126, part.normals.size(), "VEC3", "");
        const int index = add_accessor(std::as_bytes(std::span(part.indices)), 5125, part.indices.size(), "SCALAR", "");
        append(meshes_,
               fmt::format(R"({{"name":"{}","primitives":[{{"attributes":{{"POSITION":{},"NORMAL":{}}},"indices":{},)"
                           R"("material":{}}}]}})",
                           name, position, normal, index, mesh_count_ % 2));
        return mesh_count_++;
    }

    void add_node(const std::string& name, int mesh, const glm::dvec3& place)
    {
        append(nodes_, fmt::format(R"({{"name":"{}","mesh":{},"translation":[{},{},{}]}})", name, mesh, place.x,
                                   place.y, place.z));
        append(roots_, std::to_string(node_count_++));
    }

    std::vector<std::byte> bytes() const
    {
        std::string json = fmt::format(
            R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{}],"meshes":[{}],)"
            R"("materials":[{{"pbrMetallicRoughness":{{"baseColorFactor":[0.8,0.78,0.72,1],"metallicFactor":0}}}},)"
            R"({{"pbrMetallicRoughness":{{"baseColorFactor":[0.7,0.4,0.3,1],"metallicFactor":0}}}}],)"
            R"("accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})",
            roots_, nodes_, meshes_, accessors_, views_, binary_.size());
        json.resize((json.size() + 3) / 4 * 4, ' ');
        std::vector<std::byte> result;
        const auto word = [&](std::uint64_t value) {
            for (int i = 0; i < 4; ++i) result.push_back(static_cast<std::byte>(value >> (8 * i)));
        };
        word(0x46546c67), word(2), word(12 + 8 + json.size() + 8 + binary_.size());
        word(json.size()), word(0x4e4f534a);
        const auto text = std::as_bytes(std::span(json));
        result.insert(result.end(), text.begin(), text.end());
        word(binary_.size()), word(0x004e4942);
        result.insert(result.end(), binary_.begin(), binary_.end());
        return result;
    }

 private:
    static void append(std::string& list, const std::string& entry) { list += (list.empty() ? "" : ",") + entry; }

    int add_accessor(std::span<const std::byte> bytes, int type, std::size_t count, const char* shape,
                     const std::string& more)
    {
        append(views_, fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{}}})", binary_.size(), bytes.size()));
        append(accessors_, fmt::format(R"({{"bufferView":{},"componentType":{},"count":{},"type":"{}"{}}})",
                                       accessor_count_, type, count, shape, more));
        binary_.insert(binary_.end(), bytes.begin(), bytes.end());
        return accessor_count_++;
    }

    std::string nodes_, roots_, meshes_, accessors_, views_;
    std::vector<std::byte> binary_;
    int mesh_count_ = 0, node_count_ = 0, accessor_count_ = 0;
};

}  // namespace

ScaleLevel write_scale_level(const std::filesystem::path& file, int rooms)
{
    GlbText glb;
    ScaleLevel level{.rooms = rooms};
    std::vector<int> vessels;
    for (int kind = 0; kind < kVessels; ++kind)
        vessels.push_back(glb.add_mesh(vessel(kind), fmt::format("vessel_{}", kind)));
    const int columns = static_cast<int>(std::ceil(std::sqrt(rooms)));
    std::map<ShellKind, std::pair<int, std::uint64_t>> shells;  // mesh, triangles
    for (int room = 0; room < rooms; ++room) {
        const int column = room % columns, row = room / columns;
        const ShellKind kind{column == 0,     column == columns - 1 || room == rooms - 1,
                             row == 0,        room + columns >= rooms,
                             column % 2 == 1, row % 2 == 1};
        auto found = shells.find(kind);
        if (found == shells.end()) {
            const PartMesh mesh = shell(kind);
            const int number = glb.add_mesh(mesh, fmt::format("shell_{}", shells.size()));
            found = shells.emplace(kind, std::pair(number, mesh.indices.size() / 3)).first;
        }
        const glm::dvec3 corner(column * kRoom, 0.0, row * kRoom);
        glb.add_node(fmt::format("Room_{}", room), found->second.first, corner);
        level.triangles += found->second.second;
        for (int i = 0; i < kObjectsOfRoom - 1; ++i) {
            const glm::dvec3 place = corner + glm::dvec3(1.5 + 1.625 * (i % 3), 0.0, 1.5 + 1.625 * (i / 3));
            glb.add_node(fmt::format("Vessel_{}_{}", room, i), vessels[static_cast<std::size_t>((room + i) % kVessels)],
                         place);
            level.triangles += kSegments * (2 * kBands - 2);
        }
    }
    level.objects = static_cast<std::uint64_t>(rooms) * kObjectsOfRoom;
    level.eye_world = {0.75, 1.7, 0.75};
    level.target_world = {kRoom, 1.2, kRoom};
    write_file_atomically(file, std::span<const std::byte>(glb.bytes()));
    return level;
}

}  // namespace hw::measure
