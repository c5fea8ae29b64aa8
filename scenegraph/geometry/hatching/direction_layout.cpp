// Strokes are the lines on which v is constant, so what counts is that u's gradient points along the field; how fast u
// rises matters little, since the spacing of strokes is computed on the screen. Errors across the field therefore weigh
// more than errors along it.
#include "hatchway/geometry/hatching/direction_layout.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

namespace hw {
namespace {

constexpr double kLengthWeight = 0.25;
constexpr double kResidual = 1e-4;
constexpr int kMostSteps = 500;

/// One face's part of the equations of both coordinates.
struct Element {
    std::array<std::uint32_t, 3> unknown;
    std::array<std::array<float, 6>, 2> stiffness;  ///< 00 01 02 11 12 22, of u and of v.
    std::array<std::array<float, 3>, 2> right_side;
};

Element element_of(const std::array<glm::vec3, 3>& p, const glm::vec3& normal, double area, const glm::vec3& along)
{
    Element element{};
    const glm::vec3 left = glm::cross(normal, along);
    std::array<std::array<double, 2>, 3> gradient;  // of each corner's hat function, along and left
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 g = glm::cross(glm::dvec3(normal), glm::dvec3(p[(i + 2) % 3] - p[(i + 1) % 3])) / (2.0 * area);
        gradient[i] = {glm::dot(g, glm::dvec3(along)), glm::dot(g, glm::dvec3(left))};
    }
    for (int which = 0; which < 2; ++which) {
        const int wanted = which;  // u rises along, v to the left
        const int unwanted = 1 - which;
        int place = 0;
        for (int i = 0; i < 3; ++i) {
            for (int j = i; j < 3; ++j)
                element.stiffness[which][place++] =
                    static_cast<float>(area * (kLengthWeight * gradient[i][wanted] * gradient[j][wanted] +
                                               gradient[i][unwanted] * gradient[j][unwanted]));
            element.right_side[which][i] = static_cast<float>(area * kLengthWeight * gradient[i][wanted]);
        }
    }
    return element;
}

/// Conjugate gradients with the diagonal as preconditioner. The equations leave a constant open in each piece: its
/// value stays that of the start.
class LayoutSolver {
 public:
    LayoutSolver(const std::vector<Element>& elements, std::uint32_t count, int which)
        : elements_(elements), count_(count), which_(which)
    {
    }

    std::vector<double> solve()
    {
        std::vector<double> x(count_, 0.0);
        std::vector<double> residual(count_, 0.0);
        std::vector<double> inverse(count_, 0.0);
        for (const Element& element : elements_) {
            constexpr std::array kDiagonal{0, 3, 5};
            for (int i = 0; i < 3; ++i) {
                residual[element.unknown[i]] += element.right_side[which_][i];
                inverse[element.unknown[i]] += element.stiffness[which_][kDiagonal[i]];
            }
        }
        for (double& d : inverse) d = d > 0.0 ? 1.0 / d : 0.0;
        std::vector<double> conditioned = times(inverse, residual);
        std::vector<double> step = conditioned;
        double energy = dot(residual, conditioned);
        const double enough = energy * kResidual * kResidual;
        for (int i = 0; i < kMostSteps && energy > enough && energy > 0.0; ++i) {
            const std::vector<double> image = apply(step);
            const double curvature = dot(step, image);
            if (!(curvature > 0.0)) break;
            const double length = energy / curvature;
            for (std::uint32_t k = 0; k < count_; ++k) {
                x[k] += length * step[k];
                residual[k] -= length * image[k];
            }
            conditioned = times(inverse, residual);
            const double before = energy;
            energy = dot(residual, conditioned);
            for (std::uint32_t k = 0; k < count_; ++k) step[k] = conditioned[k] + energy / before * step[k];
        }
        return x;
    }

 private:
    static std::vector<double> times(const std::vector<double>& a, const std::vector<double>& b)
    {
        std::vector<double> result(a.size());
        for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] * b[i];
        return result;
    }
    static double dot(const std::vector<double>& a, const std::vector<double>& b)
    {
        return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
    }
    std::vector<double> apply(const std::vector<double>& x) const
    {
        std::vector<double> result(count_, 0.0);
        for (const Element& element : elements_) {
            const auto& k = element.stiffness[which_];
            const auto& at = element.unknown;
            const double a = x[at[0]];
            const double b = x[at[1]];
            const double c = x[at[2]];
            result[at[0]] += k[0] * a + k[1] * b + k[2] * c;
            result[at[1]] += k[1] * a + k[3] * b + k[4] * c;
            result[at[2]] += k[2] * a + k[4] * b + k[5] * c;
        }
        return result;
    }

    const std::vector<Element>& elements_;
    std::uint32_t count_;
    int which_;
};

}  // namespace

std::vector<glm::vec2> lay_out(const WeldedMesh& mesh, const SmoothSides& sides, const DirectionField& field)
{
    std::vector<bool> is_joined(field.is_cut);
    is_joined.flip();
    const CornerGroups groups = join_corners(sides, is_joined);
    std::vector<Element> elements;
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
        if (!(sides.areas[face] > 1e-30f) || glm::length(field.along[face]) < 0.5f) continue;
        std::array<glm::vec3, 3> p;
        for (int c = 0; c < 3; ++c) p[c] = mesh.positions[mesh.faces[face][c]];
        elements.push_back(element_of(p, sides.normals[face], sides.areas[face], field.along[face]));
        for (int c = 0; c < 3; ++c) elements.back().unknown[c] = groups.group[face * 3 + c];
    }
    const std::vector<double> u = LayoutSolver(elements, groups.count, 0).solve();
    const std::vector<double> v = LayoutSolver(elements, groups.count, 1).solve();
    std::vector<glm::vec2> uv;
    for (const std::uint32_t group : groups.group)
        uv.emplace_back(static_cast<float>(u[group]), static_cast<float>(v[group]));
    return uv;
}

}  // namespace hw
