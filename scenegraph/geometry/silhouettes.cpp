// Facing is decided once per face and edges compare two bits, so that a closed surface gives closed loops whatever the
// rounding. Three stages: planes in 16-bit steps with a proven bound, then doubles with a bound, then exact arithmetic.
#include "geometry/silhouettes.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "geometry/predicates.hpp"
#include "geometry/silhouette_stages.hpp"
#include "geometry/surface_faces.hpp"

namespace hw {
namespace {

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
void decide_rounded(const Surface& surface, const Viewpoint& viewpoint, std::vector<std::uint8_t>& facing)
{
    for (std::uint32_t face = 0; face < surface.faces.size(); ++face) {
        facing[face] = rounded_facing<Vector>(surface, face, viewpoint);
    }
}

/// Edges of [range.begin, range.end) whose faces differ, appended to scratch.edges from `count` on. Four at a time:
/// where none differs, the most common case by far, nothing is written.
std::uint32_t append_differing(const Surface& surface, EdgeRange range, SilhouetteScratch& scratch, std::uint32_t count)
{
    const std::uint8_t* const facing = scratch.facing.data();
    const std::array<std::uint32_t, 2>* const faces = surface.edges.faces.data();
    std::uint32_t* const found = scratch.edges.data();
    std::uint32_t edge = range.begin;
    for (; edge + 4 <= range.end; edge += 4) {
        const std::uint32_t a = facing[faces[edge][0]] ^ facing[faces[edge][1]];
        const std::uint32_t b = facing[faces[edge + 1][0]] ^ facing[faces[edge + 1][1]];
        const std::uint32_t c = facing[faces[edge + 2][0]] ^ facing[faces[edge + 2][1]];
        const std::uint32_t d = facing[faces[edge + 3][0]] ^ facing[faces[edge + 3][1]];
        if ((a | b | c | d) == 0) continue;
        // Each is kept only when it differs: no branch to mispredict.
        found[count] = edge;
        count += a;
        found[count] = edge + 1;
        count += b;
        found[count] = edge + 2;
        count += c;
        found[count] = edge + 3;
        count += d;
    }
    for (; edge < range.end; ++edge) {
        found[count] = edge;
        count += facing[faces[edge][0]] ^ facing[faces[edge][1]];
    }
    scratch.counters.edges_tested += range.size();
    return count;
}

bool takes_hierarchy(const Surface& surface, const SilhouetteOptions& options)
{
    return options.method != SilhouetteMethod::brute && options.precision == FacingPrecision::exact &&
           !surface.clusters.is_empty();
}

std::uint32_t search_all(const SilhouetteSearch& search, FacingPrecision precision, SilhouetteScratch& scratch)
{
    const Surface& surface = search.surface;
    find_facing(surface, search.viewpoint, precision, scratch);
    if (!search.has_turned_faces) {
        for (std::size_t twin = 0; twin < surface.filter.twins.size(); ++twin) {
            scratch.facing[surface.faces.size() + twin] = scratch.facing[surface.filter.twins[twin].face];
        }
    }
    std::uint32_t count = 0;
    for (const EdgeRange range : search.ranges) count = append_differing(surface, range, scratch, count);
    return count;
}

std::span<const std::uint32_t> search(const SilhouetteSearch& search, const SilhouetteOptions& options,
                                      SilhouetteScratch& scratch)
{
    std::size_t most = 1;  // brute force writes one past the last
    for (const EdgeRange range : search.ranges) most += range.size();
    make_room(scratch.edges, most);
    const std::uint32_t count = takes_hierarchy(search.surface, options)
                                    ? search_clusters(search, scratch)
                                    : search_all(search, options.precision, scratch);
    scratch.counters.edges_found += count;
    return {scratch.edges.data(), count};
}

}  // namespace

int counted_facing_sign(const Surface& surface, std::uint32_t face, const Viewpoint& viewpoint,
                        SilhouetteCounters& counters)
{
    const auto& [a, b, c] = surface.faces[face];
    PredicateStage stage;
    const int sign = facing_sign(surface.positions[a], surface.positions[b], surface.positions[c], viewpoint, &stage);
    ++counters.double_stage;
    counters.exact_stage += stage == PredicateStage::exact;
    return sign;
}

void decide_blocks(const Surface& surface, const Viewpoint& viewpoint, const FacingFilter::Query& query,
                   std::uint32_t first_block, std::uint32_t block_count, SilhouetteScratch& scratch)
{
    const std::uint32_t open =
        surface.filter.decide(query, first_block, block_count, scratch.facing, scratch.open_faces, 0);
    for (std::uint32_t i = 0; i < open; ++i) {
        const std::uint32_t face = scratch.open_faces[i];
        scratch.facing[face] = counted_facing_sign(surface, face, viewpoint, scratch.counters) > 0;
    }
}

bool is_twin_facing(const Surface& surface, std::uint32_t twin, const Viewpoint& viewpoint,
                    SilhouetteCounters& counters)
{
    const std::uint32_t plane = plane_face(surface, surface.filter.twins[twin].face);
    return plane != kNoFace && counted_facing_sign(surface, plane, viewpoint, counters) < 0;
}

void find_facing(const Surface& surface, const Viewpoint& viewpoint_object, FacingPrecision precision,
                 SilhouetteScratch& scratch)
{
    const FacingFilter& filter = surface.filter;
    const std::size_t padded = std::size_t{filter.block_count()} * FacingFilter::kBlock;
    make_room(scratch.facing, padded + filter.twins.size());
    make_room(scratch.open_faces, padded);
    switch (precision) {
        case FacingPrecision::exact:
            decide_blocks(surface, viewpoint_object, filter.query(viewpoint_object), 0, filter.block_count(), scratch);
            break;
        case FacingPrecision::single_only:
            decide_rounded<glm::vec3>(surface, viewpoint_object, scratch.facing);
            break;
        case FacingPrecision::double_only:
            decide_rounded<glm::dvec3>(surface, viewpoint_object, scratch.facing);
            break;
    }
    for (const auto& entry : filter.inherited) {
        scratch.facing[entry.face] = entry.source != kNoFace && is_front_facing(scratch, entry.source);
    }
    for (std::uint32_t twin = 0; twin < filter.twins.size(); ++twin) {
        scratch.facing[surface.faces.size() + twin] = is_twin_facing(surface, twin, viewpoint_object, scratch.counters);
    }
    scratch.counters.faces_tested += surface.faces.size();
}

std::span<const std::uint32_t> all_silhouettes(const Surface& surface, const Viewpoint& viewpoint_object,
                                               const SilhouetteOptions& options, SilhouetteScratch& scratch)
{
    const std::array<EdgeRange, 1> ranges{surface.edges.two_faced()};
    return search({surface, viewpoint_object, ranges, false}, options, scratch);
}

std::span<const std::uint32_t> drawn_contours(const Surface& surface, const Viewpoint& viewpoint_object,
                                              const SilhouetteOptions& options, SilhouetteScratch& scratch)
{
    const EdgeClasses classes = classes_at(surface, options.crease_rad);
    if (classes.candidate_count() == 0) {
        ++scratch.counters.objects_without_work;
        return {};
    }
    return search({surface, viewpoint_object, classes.candidates, true}, options, scratch);
}

}  // namespace hw
