// Facing is decided once per face and edges compare two bits, so that a closed surface gives closed loops whatever the
// rounding. Three stages: planes in 16-bit steps with a proven bound, then doubles with a bound, then exact arithmetic.
#include "geometry/silhouettes.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "geometry/predicates.hpp"
#include "geometry/surface_faces.hpp"

namespace hw {
namespace {

void set_bit(std::vector<std::uint32_t>& bits, std::uint32_t index, bool value)
{
    const std::uint32_t mask = 1u << (index & 31);
    bits[index >> 5] = value ? bits[index >> 5] | mask : bits[index >> 5] & ~mask;
}

int exact_facing(const Surface& surface, std::uint32_t face, const Viewpoint& viewpoint, SilhouetteCounters& counters)
{
    const auto& [a, b, c] = surface.faces[face];
    PredicateStage stage;
    const int sign =
        facing_sign(surface.positions[a], surface.positions[b], surface.positions[c], viewpoint, &stage);
    ++counters.double_stage;
    counters.exact_stage += stage == PredicateStage::exact;
    return sign;
}

/// The facing that one precision alone would give, rounding and all.
template <typename Vector>
bool rounded_facing(const Surface& surface, std::uint32_t face, const Viewpoint& viewpoint)
{
    const auto& corners = surface.faces[face];
    const Vector a(surface.positions[corners[0]]), b(surface.positions[corners[1]]), c(surface.positions[corners[2]]);
    const Vector to_viewer = viewpoint.is_orthographic ? Vector(viewpoint.eye) : Vector(viewpoint.eye) - a;
    return glm::dot(glm::cross(b - a, c - a), to_viewer) > 0;
}

template <typename Vector>
void decide_rounded(const Surface& surface, const Viewpoint& viewpoint, std::vector<std::uint32_t>& bits)
{
    std::fill(bits.begin(), bits.end(), 0u);
    for (std::uint32_t face = 0; face < surface.faces.size(); ++face) {
        bits[face >> 5] |= std::uint32_t{rounded_facing<Vector>(surface, face, viewpoint)} << (face & 31);
    }
}

void decide_exactly(const Surface& surface, const Viewpoint& viewpoint, SilhouetteScratch& scratch)
{
    const std::size_t padded = (surface.faces.size() + 31) / 32 * 32;
    if (scratch.open_faces.size() < padded) scratch.open_faces.resize(padded);
    const std::uint32_t open = surface.filter.decide(viewpoint, scratch.facing_bits, scratch.open_faces);
    for (std::uint32_t i = 0; i < open; ++i) {
        const std::uint32_t face = scratch.open_faces[i];
        if (exact_facing(surface, face, viewpoint, scratch.counters) > 0) set_bit(scratch.facing_bits, face, true);
    }
}

/// The facing of faces turned over; a face whose plane contains the eye is back-facing from both sides.
void decide_twins(const Surface& surface, const Viewpoint& viewpoint, SilhouetteScratch& scratch)
{
    const auto face_count = static_cast<std::uint32_t>(surface.faces.size());
    for (std::uint32_t twin = 0; twin < surface.filter.twins.size(); ++twin) {
        const std::uint32_t plane = plane_face(surface, surface.filter.twins[twin].face);
        const bool is_front = plane != kNoFace && exact_facing(surface, plane, viewpoint, scratch.counters) < 0;
        set_bit(scratch.facing_bits, face_count + twin, is_front);
    }
}

/// Edges of [range.begin, range.end) whose faces differ, appended to scratch.edges from `count` on.
std::uint32_t append_differing(const Surface& surface, EdgeRange range, SilhouetteScratch& scratch, std::uint32_t count)
{
    const std::uint32_t* const bits = scratch.facing_bits.data();
    const std::array<std::uint32_t, 2>* const faces = surface.edges.faces.data();
    std::uint32_t* const found = scratch.edges.data();
    for (std::uint32_t edge = range.begin; edge < range.end; ++edge) {
        const auto [a, b] = faces[edge];
        found[count] = edge;  // written always, kept only when the bits differ: no branch to mispredict
        count += ((bits[a >> 5] >> (a & 31)) ^ (bits[b >> 5] >> (b & 31))) & 1u;
    }
    scratch.counters.edges_tested += range.size();
    return count;
}

void make_room(std::vector<std::uint32_t>& memory, std::size_t size)
{
    if (memory.size() < size) memory.resize(size);
}

}  // namespace

void find_facing(const Surface& surface, const Viewpoint& viewpoint_object, FacingPrecision precision,
                 SilhouetteScratch& scratch)
{
    make_room(scratch.facing_bits, (surface.faces.size() + surface.filter.twins.size() + 31) / 32 + 1);
    switch (precision) {
        case FacingPrecision::exact: decide_exactly(surface, viewpoint_object, scratch); break;
        case FacingPrecision::single_only:
            decide_rounded<glm::vec3>(surface, viewpoint_object, scratch.facing_bits);
            break;
        case FacingPrecision::double_only:
            decide_rounded<glm::dvec3>(surface, viewpoint_object, scratch.facing_bits);
            break;
    }
    for (const auto& entry : surface.filter.inherited) {
        const bool is_front = entry.source != kNoFace && is_front_facing(scratch, entry.source);
        set_bit(scratch.facing_bits, entry.face, is_front);
    }
    decide_twins(surface, viewpoint_object, scratch);
    scratch.counters.faces_tested += surface.faces.size();
}

std::span<const std::uint32_t> all_silhouettes(const Surface& surface, const Viewpoint& viewpoint_object,
                                               const SilhouetteOptions& options, SilhouetteScratch& scratch)
{
    const EdgeRange range = surface.edges.two_faced();
    make_room(scratch.edges, std::size_t{range.size()} + 1);
    find_facing(surface, viewpoint_object, options.precision, scratch);
    // Here the faces count as they are wound, also where the surface cannot be oriented.
    for (std::uint32_t twin = 0; twin < surface.filter.twins.size(); ++twin) {
        const bool is_front = is_front_facing(scratch, surface.filter.twins[twin].face);
        set_bit(scratch.facing_bits, static_cast<std::uint32_t>(surface.faces.size()) + twin, is_front);
    }
    const std::uint32_t count = append_differing(surface, range, scratch, 0);
    scratch.counters.edges_found += count;
    return {scratch.edges.data(), count};
}

std::span<const std::uint32_t> drawn_contours(const Surface& surface, const Viewpoint& viewpoint_object,
                                              const SilhouetteOptions& options, SilhouetteScratch& scratch)
{
    const EdgeClasses classes = classes_at(surface, options.crease_rad);
    if (classes.candidate_count() == 0) {
        ++scratch.counters.objects_without_work;
        return {};
    }
    make_room(scratch.edges, std::size_t{classes.candidate_count()} + 1);
    find_facing(surface, viewpoint_object, options.precision, scratch);
    std::uint32_t count = 0;
    for (const EdgeRange range : classes.candidates) count = append_differing(surface, range, scratch, count);
    scratch.counters.edges_found += count;
    return {scratch.edges.data(), count};
}

}  // namespace hw
