// Facing is decided once per face and edges compare two bits, so that a closed surface gives closed loops whatever the
// rounding. Three stages: planes in 16-bit steps with a proven bound, then doubles with a bound, then exact arithmetic.
#include "hatchway/geometry/silhouettes/silhouettes.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <glm/geometric.hpp>

#include "hatchway/geometry/exact/predicates.hpp"
#include "hatchway/geometry/silhouettes/silhouette_hierarchy.hpp"
#include "hatchway/geometry/silhouettes/silhouettes_private.hpp"
#include "hatchway/geometry/surface/surface_faces.hpp"

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
void decide_rounded(const Surface& surface, const Viewpoint& viewpoint, std::span<std::uint8_t> facing)
{
    for (std::uint32_t face = 0; face < surface.faces.size(); ++face) {
        facing[face] = rounded_facing<Vector>(surface, face, viewpoint);
    }
    for (const auto& entry : surface.filter.inherited) {
        facing[entry.face] = entry.source != kNoFace && facing[entry.source] != 0;
    }
}

/// For each byte its eight bits as bytes of 0 or 1, the lowest first.
constexpr std::array<std::array<std::uint8_t, 8>, 256> kBytesOfBits = [] {
    std::array<std::array<std::uint8_t, 8>, 256> table{};
    for (unsigned byte = 0; byte < 256; ++byte) {
        for (unsigned bit = 0; bit < 8; ++bit) table[byte][bit] = byte >> bit & 1;
    }
    return table;
}();

void decide_exactly(const Surface& surface, const Viewpoint& viewpoint, SilhouetteScratch& scratch)
{
    const FacingFilter& filter = surface.filter;
    const std::uint32_t words = (filter.face_count() + 31) / 32;
    make_room(scratch.front, words);
    make_room(scratch.open, words);
    decide_planes(filter.planes().block(0), filter.face_count(), filter.eye_steps(viewpoint),
                  {scratch.front, scratch.open});
    for (std::uint32_t word = 0; word < words; ++word) {
        std::uint8_t* const facing = scratch.facing.data() + std::size_t{32} * word;
        for (unsigned byte = 0; byte < 4; ++byte) {
            std::memcpy(facing + 8 * byte, kBytesOfBits[scratch.front[word] >> 8 * byte & 255].data(), 8);
        }
        for (std::uint32_t open = scratch.open[word]; open != 0; open &= open - 1) {
            const auto bit = static_cast<std::uint32_t>(std::countr_zero(open));
            facing[bit] = is_open_face_front(surface, 32 * word + bit, viewpoint, scratch.counters);
        }
    }
}

/// Edges of [range.begin, range.end) whose faces differ, appended to scratch.edges from `count` on. Four at a time:
/// where none differs, the most common case by far, nothing is written.
std::uint32_t append_differing(const Surface& surface, EdgeRange range, SilhouetteScratch& scratch, std::uint32_t count)
{
    const std::uint8_t* const facing = scratch.facing.data();
    const Edge* const edges = surface.edges.edges.data();
    const auto differs = [=](std::uint32_t edge) -> std::uint32_t {
        return facing[edges[edge].face_a()] ^ facing[edges[edge].face_b];
    };
    std::uint32_t* const found = scratch.edges.data();
    std::uint32_t edge = range.begin;
    for (; edge + 4 <= range.end; edge += 4) {
        const std::uint32_t a = differs(edge);
        const std::uint32_t b = differs(edge + 1);
        const std::uint32_t c = differs(edge + 2);
        const std::uint32_t d = differs(edge + 3);
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
        count += differs(edge);
    }
    scratch.counters.edges_tested += range.size();
    return count;
}

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
    std::size_t most = 1;  // one is written past the last
    for (const EdgeRange range : search.ranges) most += range.size();
    make_room(scratch.edges, most);
    const std::uint32_t count = takes_hierarchy(search.surface, options)
                                    ? search_clusters(search, scratch)
                                    : search_all(search, options.precision, scratch);
    scratch.counters.edges_found += count;
    return {scratch.edges.data(), count};
}

}  // namespace

bool is_open_face_front(const Surface& surface, std::uint32_t face, const Viewpoint& viewpoint,
                        SilhouetteCounters& counters)
{
    const std::uint32_t plane = plane_face(surface, face);
    return plane != kNoFace && counted_facing_sign(surface, plane, viewpoint, counters) > 0;
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
    const std::size_t whole_words = (surface.faces.size() + 31) / 32 * 32;
    make_room(scratch.facing, whole_words + filter.twins.size());
    switch (precision) {
        case FacingPrecision::exact:
            decide_exactly(surface, viewpoint_object, scratch);
            break;
        case FacingPrecision::single_only:
            decide_rounded<glm::vec3>(surface, viewpoint_object, scratch.facing);
            break;
        case FacingPrecision::double_only:
            decide_rounded<glm::dvec3>(surface, viewpoint_object, scratch.facing);
            break;
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
