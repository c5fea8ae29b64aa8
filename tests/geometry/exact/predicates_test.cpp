#include "hatchway/geometry/exact/predicates.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

int rational_sign(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d, double w)
{
    mpq_class p[3], q[3], r[3];
    for (int i = 0; i < 3; ++i) {
        p[i] = mpq_class(b[i]) - mpq_class(a[i]);
        q[i] = mpq_class(c[i]) - mpq_class(a[i]);
        r[i] = mpq_class(d[i]) - w * mpq_class(a[i]);
    }
    return sgn(mpq_class(r[0] * (p[1] * q[2] - p[2] * q[1]) + r[1] * (p[2] * q[0] - p[0] * q[2]) +
                         r[2] * (p[0] * q[1] - p[1] * q[0])));
}

/// Points near a lattice, so that many quadruples are coplanar or all but so.
class NearLattice {
 public:
    glm::dvec3 operator()()
    {
        glm::dvec3 p(lattice_(random_), lattice_(random_), lattice_(random_));
        for (int i = 0; i < 3; ++i) {
            if (p[i] != 0.0 && random_() % 3 == 0) p[i] = std::nextafter(p[i], p[i] + (random_() % 2 ? 1.0 : -1.0));
        }
        return p;
    }

 private:
    std::mt19937 random_{7};
    std::uniform_int_distribution<int> lattice_{-3, 3};
};

}  // namespace

TEST(orient3d, is_positive_on_the_side_from_which_the_corners_turn_counter_clockwise)
{
    EXPECT_EQ(hw::orient3d_sign({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
    EXPECT_EQ(hw::orient3d_sign({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), -1);
    EXPECT_EQ(hw::orient3d_sign({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 7, 0}), 0);
}

TEST(orient3d, agrees_with_rational_arithmetic_on_nearly_coplanar_points)
{
    NearLattice next;
    int zeros = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 a = next(), b = next(), c = next(), d = next();
        const int expected = rational_sign(a, b, c, d, 1.0);
        ASSERT_EQ(hw::orient3d_sign(a, b, c, d), expected) << "trial " << i;
        zeros += expected == 0;
    }
    EXPECT_GT(zeros, 100);
}

TEST(orient3d, sees_one_unit_in_the_last_place_at_an_offset_of_a_million)
{
    const glm::dvec3 a(1e6, 1e6, 1e6), b(1e6 + 1, 1e6, 1e6 + 1), c(1e6, 1e6 + 1, 1e6 + 1);
    const glm::dvec3 on(1e6 + 0.5, 1e6 + 0.5, 1e6 + 1);
    EXPECT_EQ(hw::orient3d_sign(a, b, c, on), 0);
    EXPECT_EQ(hw::orient3d_sign(a, b, c, {on.x, on.y, std::nextafter(on.z, 2e6)}), 1);
    EXPECT_EQ(hw::orient3d_sign(a, b, c, {on.x, on.y, std::nextafter(on.z, 0.0)}), -1);
}

TEST(orient3d, agrees_with_rational_arithmetic_over_mixed_scales)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> part(-1.0, 1.0), exponent(-40.0, 40.0);
    const auto next = [&] { return std::pow(10.0, exponent(random)) * part(random); };
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec3 a(next(), next(), next()), b(next(), next(), next()), c(next(), next(), next());
        const glm::dvec3 d = i % 2 ? a + 3.0 * (b - a) + 2.0 * (c - a) : glm::dvec3(next(), next(), next());
        ASSERT_EQ(hw::orient3d_sign(a, b, c, d), rational_sign(a, b, c, d, 1.0)) << "trial " << i;
    }
}

TEST(direction_sign, agrees_with_rational_arithmetic_on_directions_nearly_in_the_plane)
{
    NearLattice next;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 a = next(), b = next(), c = next(), d = next();
        ASSERT_EQ(hw::direction_sign(a, b, c, d), rational_sign(a, b, c, d, 0.0)) << "trial " << i;
    }
}

TEST(facing, an_eye_in_the_plane_of_a_face_is_neither_in_front_nor_behind)
{
    const glm::vec3 a(0.1f, 0.2f, 0.3f), b(1.7f, 0.2f, 0.3f), c(0.1f, 0.2f, 9.9f);
    EXPECT_EQ(hw::facing_sign(a, b, c, {glm::dvec3(5.0, 0.2f, -3.0)}), 0);
    EXPECT_EQ(hw::facing_sign(a, b, c, {glm::dvec3(5.0, std::nextafter(double{0.2f}, 0.0), -3.0)}), 1);
}

TEST(facing, agrees_with_rational_arithmetic_whichever_stage_decides)
{
    NearLattice next;
    int by_filter = 0, sides_by_exact = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 a(next()), b(next()), c(next());
        const glm::dvec3 eye = next();
        hw::PredicateStage stage = hw::PredicateStage::filter;
        const int expected = rational_sign(glm::dvec3(a), glm::dvec3(b), glm::dvec3(c), eye, 1.0);
        ASSERT_EQ(hw::facing_sign(a, b, c, {eye}, &stage), expected) << "trial " << i;
        by_filter += stage == hw::PredicateStage::filter;
        sides_by_exact += stage == hw::PredicateStage::exact && expected != 0;
    }
    EXPECT_GT(by_filter, 10000);
    EXPECT_GT(sides_by_exact, 100) << "the exact stage tells sides, not only planes";
}

TEST(facing, needs_exact_arithmetic_only_close_to_the_plane)
{
    const glm::vec3 a(0.1f, 0.7f, 0.3f), b(1.3f, 0.9f, 0.2f), c(0.4f, 1.1f, 0.9f);
    const glm::dvec3 up = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    const glm::dvec3 on_edge = 0.5 * (glm::dvec3(a) + glm::dvec3(b));  // without rounding
    const auto expect = [&](const glm::dvec3& eye, int sign, hw::PredicateStage stage) {
        hw::PredicateStage used =
            stage == hw::PredicateStage::exact ? hw::PredicateStage::filter : hw::PredicateStage::exact;
        EXPECT_EQ(hw::facing_sign(a, b, c, {eye}, &used), sign);
        EXPECT_EQ(used, stage);
    };
    for (const int side : {-1, 1}) {
        expect(on_edge + 1.0 * side * up, side, hw::PredicateStage::filter);
        expect(on_edge + 1e-9 * side * up, side, hw::PredicateStage::filter);
        expect(on_edge + 1e-16 * side * up, side, hw::PredicateStage::exact);
    }
    expect(on_edge, 0, hw::PredicateStage::exact);
}

TEST(collinear, is_exact)
{
    EXPECT_TRUE(hw::are_collinear({0, 0, 0}, {1, 2, 3}, {3, 6, 9}));
    EXPECT_FALSE(hw::are_collinear({0, 0, 0}, {1, 2, 3}, {3, 6, std::nextafter(9.0f, 10.0f)}));
    EXPECT_FALSE(hw::are_collinear({0, 0, 0}, {1e-20f, 0, 0}, {1, 1e-20f, 0}));
    EXPECT_TRUE(hw::are_collinear({1e6f, 5, 5}, {1e6f, 6, 5}, {1e6f, 8, 5}));
}

TEST(viewpoint, in_object_space_survives_a_mirror_and_a_matrix_without_inverse)
{
    glm::dmat4 mirror(1.0);
    mirror[0][0] = -2.0;
    const hw::Viewpoint seen = hw::in_object({glm::dvec3(4.0, 5.0, 6.0)}, mirror);
    EXPECT_EQ(seen.eye, glm::dvec3(-2.0, 5.0, 6.0));
    const hw::Viewpoint none = hw::in_object({glm::dvec3(4.0, 5.0, 6.0)}, glm::dmat4(0.0));
    EXPECT_EQ(none.eye, glm::dvec3(0.0));
}
