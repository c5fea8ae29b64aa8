#include "hatchway/world/mesh_pieces.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <utility>

#include "hatchway/world/scene_places.hpp"

namespace hw {
namespace {

constexpr double kApart = 30.0;  // sizes of triangles, and of a part in the whole
constexpr std::size_t kBins = 64;
constexpr std::size_t kFewBins = kBins / 4;  // triangles that fill more of them along an axis have no wide gaps there
constexpr int kMostDepth = 16;

using Triangles = std::vector<std::uint32_t>;

Box box_of(const MeshData& mesh, std::uint32_t triangle)
{
    Box box;
    for (std::size_t corner = 0; corner < 3; ++corner)
        box.add(glm::dvec3(mesh.positions[mesh.indices[3 * triangle + corner]]));
    return box;
}

double width(const Box& box)
{
    return glm::length(box.size());
}

Box around(const MeshData& mesh, const Triangles& triangles)
{
    Box bounds;
    for (const std::uint32_t triangle : triangles) bounds.add(box_of(mesh, triangle));
    return bounds;
}

/// Equal shares of an axis of `bounds`, from 0 on.
std::size_t bin_of(double x, const Box& bounds, int axis)
{
    const double share = (x - bounds.min[axis]) / bounds.size()[axis];
    return std::min(kBins - 1, static_cast<std::size_t>(share * static_cast<double>(kBins)));
}

/// For each bin along an axis the number of its run of full bins; all 0 where there are no wide gaps.
std::array<std::size_t, kBins> runs_along(const MeshData& mesh, const Triangles& triangles, const Box& bounds, int axis)
{
    std::array<bool, kBins> is_full{};
    std::size_t full = 0;
    for (const std::uint32_t triangle : triangles) {
        const Box box = box_of(mesh, triangle);
        for (std::size_t i = bin_of(box.min[axis], bounds, axis); i <= bin_of(box.max[axis], bounds, axis); ++i)
            full += std::exchange(is_full[i], true) ? 0 : 1;
        if (full > kFewBins) return {};
    }
    std::array<std::size_t, kBins> runs{};
    for (std::size_t i = 1; i < kBins; ++i) runs[i] = runs[i - 1] + (is_full[i] && !is_full[i - 1] ? 1 : 0);
    return runs;
}

/// Cuts triangles at wide gaps between them, along one axis after the other, until there is none.
void cut_at_gaps(const MeshData& mesh, const Triangles& triangles, int depth, std::vector<MeshPiece>& parts)
{
    const Box bounds = around(mesh, triangles);
    for (int axis = 0; axis < 3 && depth < kMostDepth; ++axis) {
        if (!(bounds.size()[axis] > 0.0)) continue;
        const std::array<std::size_t, kBins> runs = runs_along(mesh, triangles, bounds, axis);
        if (runs.back() == 0) continue;
        std::vector<Triangles> cut(runs.back() + 1);
        for (const std::uint32_t triangle : triangles)
            cut[runs[bin_of(box_of(mesh, triangle).min[axis], bounds, axis)]].push_back(triangle);
        for (const Triangles& part : cut) cut_at_gaps(mesh, part, depth + 1, parts);
        return;
    }
    parts.push_back({bounds, triangles.size()});
}

/// Triangles by size, each group far larger than the one before; none of those without extent.
std::vector<Triangles> by_size(const MeshData& mesh)
{
    std::vector<double> widths;
    for (std::uint32_t i = 0; i < mesh.triangle_count(); ++i) widths.push_back(width(box_of(mesh, i)));
    std::vector<Triangles> groups;
    for (double from = 0.0, end = 0.0;; from = end) {
        end = end_of_group(widths, from, kApart);
        if (end == from) return groups;
        Triangles& group = groups.emplace_back();
        for (std::uint32_t i = 0; i < widths.size(); ++i)
            if (widths[i] > from && widths[i] <= end) group.push_back(i);
    }
}

}  // namespace

std::vector<MeshPiece> mesh_pieces(const MeshData& mesh)
{
    MeshPiece whole{{}, mesh.triangle_count()};
    for (std::uint32_t i = 0; i < mesh.triangle_count(); ++i) whole.bounds.add(box_of(mesh, i));
    if (whole.bounds.is_empty()) return {};
    std::vector<MeshPiece> parts;
    for (const Triangles& group : by_size(mesh)) cut_at_gaps(mesh, group, 0, parts);
    const auto is_small = [&](const MeshPiece& part) { return kApart * width(part.bounds) < width(whole.bounds); };
    return std::ranges::any_of(parts, is_small) ? parts : std::vector{whole};
}

}  // namespace hw
