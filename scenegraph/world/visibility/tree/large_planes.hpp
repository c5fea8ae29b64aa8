#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "hatchway/world/visibility/tree/coplanar.hpp"

namespace hw {

/// Chooses of many triangles those in the planes with most area, without holding any: they are shown three times, in
/// the same order. Which triangles share a plane is estimated, by cells of direction and offset: merge_coplanar() is
/// exact, but slow for millions of facets that are too small to block anything. Deterministic.
class LargePlanes {
 public:
    explicit LargePlanes(double step_m) : step_m_(step_m) {}

    void add_area(const GridTriangle& triangle);  ///< The first time.
    void rank(const GridTriangle& triangle);      ///< The second time.
    /// Before the third time: about `most` are kept, and those of named nodes.
    void choose(std::size_t most);
    bool keeps(const GridTriangle& triangle) const;

 private:
    struct Facet {
        glm::dvec3 normal{0.0};  ///< Unit, its largest component positive: a plane has two sides.
        double offset_m = 0.0;
        double area = 0.0;
    };
    /// Facets by cells; two sets, half a cell apart, since mates may lie on either side of a border. Of fixed size:
    /// cells that fall together are seldom large both.
    using AreaOfCells = std::vector<double>;

    Facet facet_of(const GridTriangle& triangle) const;
    static std::size_t place(const Facet& facet, double shift);
    double area_of(const GridTriangle& triangle) const;

    double step_m_;
    std::array<AreaOfCells, 2> areas_;
    std::vector<double> ranked_;
    double least_area_ = 0.0;
};

}  // namespace hw
