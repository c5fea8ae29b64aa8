#pragma once

#include <cstdint>
#include <span>

#include "hatchway/geometry/silhouettes/silhouettes.hpp"

namespace hw {

// The parts that brute force and hierarchy share. Nobody else needs them.

/// What both methods are asked for: the edges of some ranges whose faces differ.
struct SilhouetteSearch {
    const Surface& surface;
    const Viewpoint& viewpoint;
    std::span<const EdgeRange> ranges;
    bool has_turned_faces;  ///< Twins count as turned over; else as the faces are wound.
};

template <typename Vector>
void make_room(Vector& memory, std::size_t size)
{
    if (memory.size() < size) memory.resize(size);
}

/// Whether a face that the planes leave open looks at the viewer, by doubles, or exactly where they do not suffice;
/// counted.
bool is_open_face_front(const Surface& surface, std::uint32_t face, const Viewpoint& viewpoint,
                        SilhouetteCounters& counters);

/// Whether a face turned over looks at the viewer. A face whose plane contains the eye is back-facing from both sides.
bool is_twin_facing(const Surface& surface, std::uint32_t twin, const Viewpoint& viewpoint,
                    SilhouetteCounters& counters);

}  // namespace hw
