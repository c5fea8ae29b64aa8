#include "hatchway/geometry/topology/weld.hpp"

#include <bit>

namespace hw {
namespace {

constexpr std::uint32_t kEmpty = 0xffffffffu;

/// Open addressing over exact bits; grows never, made for a known number of vertices.
class PositionTable {
 public:
    explicit PositionTable(std::size_t vertex_count)
        : mask_(std::bit_ceil(2 * vertex_count + 2) - 1), slots_(mask_ + 1, kEmpty)
    {
    }

    std::uint32_t find_or_add(const glm::vec3& stated, std::vector<glm::vec3>& positions)
    {
        const glm::vec3 position = stated + 0.0f;  // turns -0 into 0
        for (std::size_t slot = hash(position) & mask_;; slot = (slot + 1) & mask_) {
            if (slots_[slot] == kEmpty) {
                slots_[slot] = static_cast<std::uint32_t>(positions.size());
                positions.push_back(position);
                return slots_[slot];
            }
            if (positions[slots_[slot]] == position) return slots_[slot];
        }
    }

 private:
    static std::size_t hash(const glm::vec3& p)
    {
        std::uint64_t h = std::bit_cast<std::uint32_t>(p.x) * 0x9e3779b97f4a7c15ull;
        h = (std::rotl(h, 23) ^ std::bit_cast<std::uint32_t>(p.y)) * 0xbf58476d1ce4e5b9ull;
        h = (std::rotl(h, 23) ^ std::bit_cast<std::uint32_t>(p.z)) * 0x94d049bb133111ebull;
        return h ^ (h >> 31);
    }

    std::size_t mask_;
    std::vector<std::uint32_t> slots_;
};

}  // namespace

WeldedMesh weld(const MeshData& mesh)
{
    WeldedMesh welded;
    welded.vertex_position.assign(mesh.positions.size(), 0);
    std::vector<bool> is_known(mesh.positions.size(), false);
    PositionTable table(mesh.positions.size());
    const auto position_of = [&](std::uint32_t vertex) {
        if (!is_known[vertex]) {
            welded.vertex_position[vertex] = table.find_or_add(mesh.positions[vertex], welded.positions);
            is_known[vertex] = true;
        }
        return welded.vertex_position[vertex];
    };
    welded.faces.reserve(mesh.triangle_count());
    welded.face_triangle.reserve(mesh.triangle_count());
    for (std::uint32_t triangle = 0; triangle < mesh.triangle_count(); ++triangle) {
        const std::uint32_t* corner = &mesh.indices[3 * std::size_t{triangle}];
        const std::uint32_t a = position_of(corner[0]), b = position_of(corner[1]), c = position_of(corner[2]);
        if (a == b || b == c || c == a) continue;
        welded.faces.push_back({a, b, c});
        welded.face_triangle.push_back(triangle);
    }
    return welded;
}

}  // namespace hw
