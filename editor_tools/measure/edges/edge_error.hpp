#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "hatchway/core/pixels.hpp"
#include "measure/edges/wanted_edges.hpp"
#include "measure/no_value.hpp"

namespace hw {

/// Error of edge maps, counted so that those of several views can be added.
struct EdgeError {
    using PerKind = std::array<double, kEdgeKindCount>;

    PerKind wanted_px{};  ///< Length of the lines of a kind.
    PerKind
        found_px{};  ///< ... of that with a mark within a pixel: of a profile edge for profiles, of any for the rest.
    double profiles = 0.0;         ///< Pixels marked as profile edges.
    double profiles_right = 0.0;   ///< ... of those whose middle is within a pixel of a profile line, flush or not.
    double inners = 0.0;           ///< Pixels marked as inner edges and not as profile edges.
    double inners_right = 0.0;     ///< ... of those whose middle is within a pixel of any line.
    double distance_sum_px = 0.0;  ///< From marks of profiles to profile lines and back, kFarthestPx at most.
    double distances = 0.0;
    double false_pixels = 0.0;  ///< Marked at all, and farther than 2 pixels from any line.
    double pixels = 0.0;

    static constexpr double kFarthestPx = 12.0;

    double recall(EdgeKind kind) const;
    double profile_precision() const { return measure::share_of(profiles_right, profiles); }
    double inner_precision() const { return measure::share_of(inners_right, inners); }
    double chamfer_px() const { return measure::share_of(distance_sum_px, distances); }
    double false_share() const { return measure::share_of(false_pixels, pixels); }

    void add(const EdgeError& other);
};

/// What a pixel of a judged edge map shows.
enum class EdgeVerdict : std::uint8_t { paper, right_profile, right_inner, wrong, missed };

/// Judges edge maps of one view by the lines that are wanted there.
class EdgeJudge {
 public:
    /// `objects`: black where nothing is; edges there are not looked at, since no object shows them.
    EdgeJudge(const Pixels& objects, std::vector<WantedEdge> wanted);

    /// `map`: R is 1 - inner edge, G 1 - profile edge. Marked is what is an edge by `threshold` or more. `to_show`,
    /// when not null, receives an EdgeVerdict for every pixel.
    EdgeError judge(const Pixels& map, double threshold, std::vector<EdgeVerdict>* to_show = nullptr) const;

    /// Drawn width / `width_px` of profile edges where no other line comes near: all ink of G across the line.
    std::vector<float> width_ratios(const Pixels& map, double width_px) const;

 private:
    using Field = std::vector<float>;  // distance of each pixel's middle to the nearest line, up to the farthest
    void add_to(Field& field, const glm::dvec2& at_px) const;
    void judge_mark(EdgeError& error, std::size_t pixel, bool is_profile_mark, EdgeVerdict& verdict) const;
    /// Whether it is found.
    bool judge_line(EdgeError& error, const WantedEdge& edge, const Pixels& map, double threshold) const;
    std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * size_px_.x + x; }
    bool stands_alone(const WantedEdge& edge, double reach_px) const;

    glm::ivec2 size_px_;
    std::vector<bool> is_covered_;
    std::vector<WantedEdge> wanted_;
    Field to_any_, to_profile_;
};

}  // namespace hw
