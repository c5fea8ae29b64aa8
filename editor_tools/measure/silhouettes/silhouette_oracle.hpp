#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace hw {

/// An edge by its positions, the smaller id first.
using OracleEdge = std::array<std::uint32_t, 2>;

/// What a list of silhouette edges has wrong.
struct SilhouetteErrors {
    std::size_t false_positives = 0;
    std::size_t false_negatives = 0;
    std::size_t odd_vertices = 0;  ///< Closed vertices at which an odd number of the listed edges meets.
};

/// A face that has the facing of another, or of none where `source` is no face.
struct OraclePlane {
    std::uint32_t face;
    std::uint32_t source;
};

/// Silhouettes by rational arithmetic from nothing but positions and oriented faces. Shares no code with the engine.
/// The spans must outlive it.
class SilhouetteOracle {
 public:
    enum class Arithmetic : unsigned char { filtered, rational_only };
    /// What the order of a face's corners says: its front, or nothing.
    enum class Winding : unsigned char { says_front, says_nothing };

    /// `filtered` computes with GMP only those signs that long doubles leave open. `given`: faces that have no plane of
    /// their own by definition (needles, caps), which is not for arithmetic to decide.
    SilhouetteOracle(std::span<const glm::vec3> positions, std::span<const std::array<std::uint32_t, 3>> faces,
                     Arithmetic arithmetic = Arithmetic::filtered, std::span<const OraclePlane> given = {},
                     Winding winding = Winding::says_front);

    /// Edges of exactly two faces that differ in facing, sorted. Where winding says nothing, of two faces that go along
    /// their edge in the same direction one is turned over first: a silhouette is an edge whose faces lie on the same
    /// side of it in the picture. `w` is 1 for an eye, 0 for a direction to the viewer.
    /// A face whose plane contains the eye is back-facing; a collinear face has the facing of the neighbour across its
    /// longest edge, if that edge has exactly two faces, else it is back-facing. Where winding says nothing, back is no
    /// side, and such faces leave their edges open: those are edge_on_in_world() and not among the silhouettes.
    std::vector<OracleEdge> silhouettes(const glm::dvec3& eye, double w = 1.0) const;

    /// The same for an eye in world space and faces that a matrix places there, whose determinant is not 0: nothing is
    /// rounded on the way to the object.
    std::vector<OracleEdge> silhouettes_in_world(const glm::dvec3& eye_world, const glm::dmat4& world_from_object,
                                                 double w = 1.0) const;

    /// Edges of exactly two faces of which one is a line in the picture: its plane contains the eye, or it has none.
    std::vector<OracleEdge> edge_on_in_world(const glm::dvec3& eye_world, const glm::dmat4& world_from_object,
                                             double w = 1.0) const;

    /// Judges a sorted list against `expected`, the oracle's own for the same eye.
    SilhouetteErrors judge(std::span<const OracleEdge> found, std::span<const OracleEdge> expected) const;

    std::size_t edge_count() const { return edge_count_; }

 private:
    struct Pair {
        OracleEdge edge;
        std::uint32_t face_a;
        std::uint32_t face_b;
        bool is_turned = false;  ///< B counts as turned over.
    };

    struct Eye;
    static Eye eye_in_object(const glm::dvec3& eye_world, const glm::dmat4& world_from_object, double w);
    std::vector<signed char> sides_from(const Eye& eye) const;
    std::vector<OracleEdge> silhouettes_from(const Eye& eye) const;
    int sign(std::uint32_t face, const Eye& eye) const;
    bool is_collinear(std::uint32_t face) const;
    int longest_side(std::uint32_t face) const;

    std::span<const glm::vec3> positions_;
    std::span<const std::array<std::uint32_t, 3>> faces_;
    Arithmetic arithmetic_;
    Winding winding_;
    std::size_t edge_count_ = 0;
    std::vector<Pair> pairs_;
    std::vector<std::array<std::uint32_t, 2>> inherits_;  // face, the face whose facing it has
    std::vector<bool> is_closed_;                         // positions all of whose edges have exactly two faces
};

}  // namespace hw
