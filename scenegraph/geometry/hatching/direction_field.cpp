// Directions are crosses while they are smoothed: four directions at right angles, as one complex number of four times
// the angle. The direction of strongest curvature turns by 90 degrees where a surface changes from convex to saddle; a
// cross does not, so strokes run on there. Which of the four is meant is decided for a whole piece, by what its faces
// prefer.
#include "hatchway/geometry/hatching/direction_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <deque>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <numeric>

namespace hw {
namespace {

using Complex = std::complex<float>;

constexpr float kQuarter = 0.5f * std::numbers::pi_v<float>;
constexpr float kSmoothingShare = 0.05f;  // of the mesh's diagonal: what is smaller does not turn strokes
constexpr float kFormShare = 0.25f;       // of the diagonal: the radius from which on a curve counts in full
constexpr float kLevelWeight = 0.02f;     // of levelness, where nothing else speaks
constexpr int kSweeps = 150;

std::uint32_t next_corner(std::uint32_t corner)
{
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

std::uint32_t previous_corner(std::uint32_t corner)
{
    return corner % 3 == 0 ? corner + 2 : corner - 1;
}

glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& otherwise)
{
    const float length = glm::length(v);
    return length > 0.0f ? v / length : otherwise;
}

/// To the right for someone who stands upright before the face.
glm::vec3 level_direction(const glm::vec3& normal)
{
    const glm::vec3 right = glm::cross(glm::vec3(0.0f, 1.0f, 0.0f), normal);
    if (glm::length(right) > 0.05f) return glm::normalize(right);
    return unit_or(glm::vec3(1.0f, 0.0f, 0.0f) - normal * normal.x, glm::vec3(0.0f));
}

/// One face's axes in its plane, and what its curvature says.
struct FaceForm {
    glm::vec3 right{0.0f};
    glm::vec3 up{0.0f};
    Complex wanted{0.0f};     ///< Unit, of twice the angle of strongest curvature; 0 where there is none.
    float confidence = 0.0f;  ///< 0 to 1
    float angle_of(const glm::vec3& v) const { return std::atan2(glm::dot(v, up), glm::dot(v, right)); }
    glm::vec3 direction(float angle) const { return right * std::cos(angle) + up * std::sin(angle); }
};

class FieldMaker {
 public:
    FieldMaker(const WeldedMesh& mesh, const SmoothSides& sides) : mesh_(mesh), sides_(sides)
    {
        glm::vec3 low(0.0f);
        glm::vec3 high(0.0f);
        if (!mesh.positions.empty()) low = high = mesh.positions[0];
        for (const glm::vec3& p : mesh.positions) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        diagonal_ = std::max(glm::length(high - low), 1e-30f);
    }

    DirectionField make()
    {
        measure_forms();
        find_rotations();
        smooth();
        comb();
        cut_to_discs();
        turn_to_strongest();
        return std::move(field_);
    }

 private:
    std::uint32_t face_count() const { return static_cast<std::uint32_t>(mesh_.faces.size()); }
    const glm::vec3& position(std::uint32_t corner) const
    {
        return mesh_.positions[mesh_.faces[corner / 3][corner % 3]];
    }

    std::vector<glm::vec3> corner_normals() const
    {
        std::vector<bool> joined(sides_.twin.size());
        for (std::uint32_t side = 0; side < joined.size(); ++side) joined[side] = sides_.is_smooth(side);
        const CornerGroups groups = join_corners(sides_, joined);
        std::vector<glm::vec3> sums(groups.count, glm::vec3(0.0f));
        for (std::uint32_t corner = 0; corner < joined.size(); ++corner) {
            sums[groups.group[corner]] += sides_.normals[corner / 3] * angle_at(corner);
        }
        std::vector<glm::vec3> normals;
        for (std::uint32_t corner = 0; corner < joined.size(); ++corner)
            normals.push_back(unit_or(sums[groups.group[corner]], sides_.normals[corner / 3]));
        return normals;
    }

    /// The change of the normal along a face's sides, as a symmetric 2 x 2 form by least squares.
    void measure_form(std::uint32_t face, const std::vector<glm::vec3>& normals)
    {
        FaceForm& form = forms_[face];
        form.right = level_direction(sides_.normals[face]);
        form.up = glm::cross(sides_.normals[face], form.right);
        glm::dmat3 system(0.0);
        glm::dvec3 right_side(0.0);
        for (std::uint32_t corner = face * 3; corner < face * 3 + 3; ++corner) {
            const glm::vec3 along = position(next_corner(corner)) - position(corner);
            const glm::vec3 change = normals[next_corner(corner)] - normals[corner];
            const double x = glm::dot(along, form.right) / diagonal_;
            const double y = glm::dot(along, form.up) / diagonal_;
            const double dx = glm::dot(change, form.right);
            const double dy = glm::dot(change, form.up);
            system += glm::dmat3(x * x, x * y, 0.0, x * y, x * x + y * y, x * y, 0.0, x * y, y * y);
            right_side += glm::dvec3(x * dx, y * dx + x * dy, y * dy);
        }
        const double determinant = glm::determinant(system);
        if (!(std::abs(determinant) > 1e-30)) return;
        const glm::dvec3 solved = glm::inverse(system) * right_side;  // times the diagonal
        const Complex spread(static_cast<float>(0.5 * (solved.x - solved.z)), static_cast<float>(solved.y));
        const float size = std::abs(spread);
        if (!(size > 1e-6f) || !std::isfinite(size)) return;
        form.wanted = solved.x + solved.z < 0.0 ? -spread / size : spread / size;
        form.confidence = std::min(size * kFormShare, 1.0f);
    }

    void measure_forms()
    {
        forms_.resize(face_count());
        const std::vector<glm::vec3> normals = corner_normals();
        for (std::uint32_t face = 0; face < face_count(); ++face)
            if (sides_.areas[face] > 0.0f) measure_form(face, normals);
    }

    /// How much an angle grows from the twin's face into a side's own face.
    void find_rotations()
    {
        rotation_.assign(sides_.twin.size(), 0.0f);
        for (std::uint32_t side = 0; side < rotation_.size(); ++side) {
            if (!sides_.is_smooth(side)) continue;
            const glm::vec3 along = position(next_corner(side)) - position(side);
            rotation_[side] = forms_[side / 3].angle_of(along) - forms_[sides_.twin[side] / 3].angle_of(along);
        }
    }

    void smooth()
    {
        const float length = kSmoothingShare * diagonal_;
        std::vector<Complex> wanted(face_count());
        std::vector<float> weight(face_count());
        for (std::uint32_t face = 0; face < face_count(); ++face) {
            const float area = sides_.areas[face] / (length * length);
            const FaceForm& form = forms_[face];
            // Level is angle 0 of each face's own axes.
            wanted[face] = area * (form.confidence * form.wanted * form.wanted + Complex(kLevelWeight));
            weight[face] = area * (form.confidence + kLevelWeight);
        }
        std::vector<Complex> turn(rotation_.size());
        for (std::size_t side = 0; side < turn.size(); ++side) turn[side] = std::polar(1.0f, 4.0f * rotation_[side]);
        std::vector<Complex> cross(wanted);
        const auto relax = [&](std::uint32_t face) {
            Complex sum = wanted[face];
            float total = weight[face];
            for (std::uint32_t side = face * 3; side < face * 3 + 3; ++side) {
                if (!sides_.is_smooth(side)) continue;
                sum += turn[side] * cross[sides_.twin[side] / 3];
                total += 1.0f;
            }
            if (total > 0.0f) cross[face] = sum / total;
        };
        for (int sweep = 0; sweep < kSweeps; ++sweep)
            for (std::uint32_t i = 0; i < face_count(); ++i) relax(sweep % 2 == 0 ? i : face_count() - 1 - i);
        for (const Complex& c : cross) angle_.push_back(std::abs(c) > 0.0f ? 0.25f * std::arg(c) : 0.0f);
    }

    /// Quarter turns by which the twin's direction differs from a side's own, rounded.
    int quarters(std::uint32_t side) const { return static_cast<int>(std::lround(difference(side) / kQuarter)); }
    float difference(std::uint32_t side) const
    {
        return angle_[sides_.twin[side] / 3] + rotation_[side] - angle_[side / 3];
    }

    float angle_at(std::uint32_t corner) const
    {
        const glm::vec3 a = unit_or(position(next_corner(corner)) - position(corner), glm::vec3(0.0f));
        const glm::vec3 b = unit_or(position(previous_corner(corner)) - position(corner), glm::vec3(0.0f));
        return std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f));
    }

    /// Whether the cross turns on its way round a vertex, beside what the surface's own curvature turns it (Poincare
    /// and Hopf: these turns add up to two on a sphere).
    bool is_singular(std::uint32_t corner) const
    {
        float turned = 4.0f * kQuarter;
        std::uint32_t at = corner;
        do {
            const std::uint32_t side = previous_corner(at);
            if (!sides_.is_smooth(side)) return false;
            turned += difference(side) - kQuarter * static_cast<float>(quarters(side)) - angle_at(at);
            at = sides_.twin[side];
        } while (at != corner);
        return std::lround(turned / kQuarter) != 0;
    }

    void find_singular_vertices()
    {
        is_singular_.assign(mesh_.positions.size(), false);
        std::vector<bool> is_seen(mesh_.positions.size(), false);
        for (std::uint32_t corner = 0; corner < sides_.twin.size(); ++corner) {
            const std::uint32_t vertex = mesh_.faces[corner / 3][corner % 3];
            if (is_seen[vertex]) continue;
            is_seen[vertex] = true;
            is_singular_[vertex] = is_singular(corner);
            if (is_singular_[vertex]) ++field_.singularities;
        }
    }

    /// Turns every face's direction to fit the face before it, from a first face that looks to the front, so that cuts
    /// come to lie behind.
    void comb()
    {
        find_singular_vertices();
        std::vector<std::uint32_t> order(face_count());
        std::iota(order.begin(), order.end(), 0u);
        const glm::vec3 front(0.3f, 0.5f, 0.8f);
        std::ranges::stable_sort(order, std::ranges::greater(),
                                 [&](std::uint32_t face) { return glm::dot(sides_.normals[face], front); });
        field_.is_cut.assign(sides_.twin.size(), true);
        field_.piece.assign(face_count(), kNoSide);
        for (const std::uint32_t first : order) {
            if (field_.piece[first] != kNoSide) continue;
            field_.piece[first] = piece_count_++;
            std::deque<std::uint32_t> faces{first};
            while (!faces.empty()) {
                spread_from(faces.front(), faces);
                faces.pop_front();
            }
        }
    }

    void spread_from(std::uint32_t face, std::deque<std::uint32_t>& faces)
    {
        for (std::uint32_t side = face * 3; side < face * 3 + 3; ++side) {
            if (!sides_.is_smooth(side)) continue;
            const std::uint32_t other = sides_.twin[side] / 3;
            if (field_.piece[other] != kNoSide) continue;
            field_.piece[other] = field_.piece[face];
            angle_[other] -= kQuarter * static_cast<float>(quarters(side));
            field_.is_cut[side] = field_.is_cut[sides_.twin[side]] = false;
            faces.push_back(other);
        }
    }

    /// Beside the tree over which directions spread every edge is cut: too many. Cuts that end blind are healed, but
    /// for those that reach a singular point.
    void cut_to_discs()
    {
        std::vector<std::uint32_t> degree(mesh_.positions.size(), 0);
        std::vector<std::vector<std::uint32_t>> sides_at(mesh_.positions.size());
        const auto ends = [&](std::uint32_t side) {
            return std::array{mesh_.faces[side / 3][side % 3], mesh_.faces[side / 3][next_corner(side) % 3]};
        };
        for (std::uint32_t side = 0; side < sides_.twin.size(); ++side) {
            if (!field_.is_cut[side] || (sides_.twin[side] != kNoSide && sides_.twin[side] < side)) continue;
            for (const std::uint32_t vertex : ends(side)) {
                ++degree[vertex];
                if (sides_.is_smooth(side)) sides_at[vertex].push_back(side);
            }
        }
        std::vector<std::uint32_t> blind;
        for (std::uint32_t vertex = 0; vertex < degree.size(); ++vertex) blind.push_back(vertex);
        while (!blind.empty()) {
            const std::uint32_t vertex = blind.back();
            blind.pop_back();
            if (degree[vertex] != 1 || is_singular_[vertex]) continue;
            for (const std::uint32_t side : sides_at[vertex]) {
                if (!field_.is_cut[side] || quarters(side) % 4 != 0) continue;
                field_.is_cut[side] = field_.is_cut[sides_.twin[side]] = false;
                for (const std::uint32_t end : ends(side)) {
                    --degree[end];
                    blind.push_back(end);
                }
            }
        }
    }

    void turn_to_strongest()
    {
        std::vector<float> preference(piece_count_, 0.0f);
        for (std::uint32_t face = 0; face < face_count(); ++face) {
            const float agrees = std::real(forms_[face].wanted * std::polar(1.0f, -2.0f * angle_[face]));
            preference[field_.piece[face]] += sides_.areas[face] * forms_[face].confidence * agrees;
        }
        for (std::uint32_t face = 0; face < face_count(); ++face) {
            const float turn = preference[field_.piece[face]] < 0.0f ? -kQuarter : 0.0f;
            field_.along.push_back(forms_[face].direction(angle_[face] + turn));
        }
    }

    const WeldedMesh& mesh_;
    const SmoothSides& sides_;
    float diagonal_ = 1.0f;
    std::vector<FaceForm> forms_;
    std::vector<float> rotation_;  ///< Of each side.
    std::vector<float> angle_;     ///< Of each face's direction, from its right.
    std::vector<bool> is_singular_;
    std::uint32_t piece_count_ = 0;
    DirectionField field_;
};

}  // namespace

DirectionField principal_field(const WeldedMesh& mesh, const SmoothSides& sides)
{
    return FieldMaker(mesh, sides).make();
}

}  // namespace hw
