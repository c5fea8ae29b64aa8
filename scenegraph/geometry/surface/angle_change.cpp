#include "hatchway/geometry/surface/angle_change.hpp"

#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>

namespace hw {
namespace {

constexpr double kSteps = 0x1p20;  // matrices of rotations are off by far less than half a step
constexpr double kMost = 0x1p40;   // maps that change angles more flatten

double size_of(const glm::dmat3& map)
{
    return std::cbrt(std::abs(glm::determinant(map)));
}

}  // namespace

AngleChange angle_change(const glm::dmat3& map)
{
    const double size = size_of(map);
    if (!(size > 0.0)) return {};
    const glm::dmat3 unit = map / size;
    const glm::dmat3 square = glm::transpose(unit) * unit - glm::dmat3(1.0);
    AngleChange change;
    std::size_t at = 0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row <= column; ++row) {
            if (!(std::abs(square[column][row]) < kMost)) return {};
            change.square[at++] = std::llround(kSteps * square[column][row]);
        }
    return change;
}

glm::dmat3 fold_normal_matrix(const glm::dmat3& map)
{
    return angle_change(map).is_none() ? glm::dmat3(1.0) : glm::inverseTranspose(map / size_of(map));
}

}  // namespace hw
