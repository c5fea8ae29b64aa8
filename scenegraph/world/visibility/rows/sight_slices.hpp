#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "hatchway/core/box.hpp"
#include "hatchway/world/visibility/rows/sight_slice.hpp"
#include "hatchway/world/visibility/tree/bsp.hpp"
#include "hatchway/world/visibility/tree/portals.hpp"

namespace hw {

/// How slices are chosen.
struct SliceOptions {
    int most_faces = 300;  ///< Planes of blocking polygons, those with the largest area.
    int most_solids = 32;  ///< Along each axis, through the inside of walls where most is solid.
    int texels = 640;      ///< Along the longer side of a bitmap.
    int threads = 0;       ///< 0: as many as the machine has.
};

/// Planes that cut sight: those of large blocking polygons, and planes inside of walls. What lies on a plane is closed
/// where a polygon blocks or where one of the leaves that meet there is solid; so one slice joins all that stands in
/// its plane, whatever it is made of.
class SightSlices {
 public:
    /// `contacts` are leaf_contacts() of `build`, which has set BspTree::is_solid.
    /// `leaf_boxes`: metres from the grid's origin.
    SightSlices(const BspBuild& build, std::span<const LeafContact> contacts, std::span<const Box> leaf_boxes,
                const SliceOptions& options);

    /// Whether the sight lines from `eyes` to `target` (metres from the grid's origin) all meet what blocks.
    /// Conservative: one slice between the two must be closed wherever a line between them crosses it. `last` is the
    /// number of the slice that hid something last, or -1: it is tried first.
    bool hides(const Box& eyes, const Box& target, int& last) const;

    /// A slice that cuts the line from one point to the other; -1: none. `last` is one that may be likely, or -1.
    int cut(const glm::dvec3& from, const glm::dvec3& to, int last = -1) const;

    std::span<const SightSlice> slices() const { return slices_; }

 private:
    static constexpr std::size_t kMostSlices = 1024;

    /// The slices that part two boxes; one more place in `found` than there are slices.
    std::size_t between(const Box& eyes, const Box& target, std::span<int> found) const;
    bool parts(std::size_t slice, const Box& eyes, const Box& target) const;
    /// Of a slice that parts the two.
    bool hides(std::size_t slice, const Box& eyes, const Box& target) const;
    bool cuts(std::size_t slice, const glm::dvec3& from, const glm::dvec3& to) const;

    std::vector<SightSlice> slices_;
    std::array<std::vector<double>, 3> normals_;  ///< Of all slices, by axis: a quick search for those between.
    std::vector<double> offsets_;
    double behind_m_ = 0.0;  ///< A target must be so far behind a plane to be hidden by it.
};

}  // namespace hw
