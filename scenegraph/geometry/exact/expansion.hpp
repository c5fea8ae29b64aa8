#pragma once

#include <array>
#include <cstddef>

namespace hw {

/// An exact sum of doubles that do not overlap, smallest first, zeros left out. The basis of the exact predicates.
/// Exact while no product underflows or overflows. Needs strict IEEE arithmetic: include only from files that are
/// compiled without contraction of multiplications and additions. Source: Shewchuk. Adaptive Precision Floating-Point
/// Arithmetic and Fast Robust Geometric Predicates. 1997.
template <std::size_t Capacity>
struct Expansion {
    std::array<double, Capacity> terms;
    std::size_t size = 0;

    void push(double term)
    {
        if (term != 0.0) terms[size++] = term;
    }
    int sign() const { return size == 0 ? 0 : (terms[size - 1] > 0.0 ? 1 : -1); }
};

struct Pair {
    double high;
    double low;
};

inline Pair two_sum(double a, double b)
{
    const double high = a + b;
    const double b_part = high - a;
    return {high, (a - (high - b_part)) + (b - b_part)};
}

inline Pair fast_two_sum(double larger, double smaller)
{
    const double high = larger + smaller;
    return {high, smaller - (high - larger)};
}

inline Pair split(double a)
{
    constexpr double kSplitter = 0x1p27 + 1.0;
    const double c = kSplitter * a;
    const double high = c - (c - a);
    return {high, a - high};
}

inline Pair two_product(double a, double b)
{
    const double high = a * b;
    const Pair as = split(a), bs = split(b);
    const double rest = ((high - as.high * bs.high) - as.low * bs.high) - as.high * bs.low;
    return {high, as.low * bs.low - rest};
}

inline Expansion<2> difference(double a, double b)
{
    const Pair pair = two_sum(a, -b);
    Expansion<2> result;
    result.push(pair.low);
    result.push(pair.high);
    return result;
}

template <std::size_t N>
Expansion<N> negated(Expansion<N> e)
{
    for (std::size_t i = 0; i < e.size; ++i) e.terms[i] = -e.terms[i];
    return e;
}

/// Merges two expansions by magnitude and carries, Shewchuk's fast_expansion_sum_zeroelim.
template <std::size_t M, std::size_t N>
Expansion<M + N> sum(const Expansion<M>& e, const Expansion<N>& f)
{
    Expansion<M + N> result;
    std::size_t i = 0, j = 0;
    const auto next = [&]() {
        const bool take_e = j == f.size || (i < e.size && (e.terms[i] < 0 ? -e.terms[i] : e.terms[i]) <
                                                              (f.terms[j] < 0 ? -f.terms[j] : f.terms[j]));
        return take_e ? e.terms[i++] : f.terms[j++];
    };
    const std::size_t count = e.size + f.size;
    if (count == 0) return result;
    double carry = next();
    for (std::size_t k = 1; k < count; ++k) {
        const Pair pair = two_sum(carry, next());
        result.push(pair.low);
        carry = pair.high;
    }
    result.push(carry);
    return result;
}

/// Shewchuk's scale_expansion_zeroelim.
template <std::size_t N>
Expansion<2 * N> scaled(const Expansion<N>& e, double factor)
{
    Expansion<2 * N> result;
    if (e.size == 0) return result;
    const Pair first = two_product(e.terms[0], factor);
    result.push(first.low);
    double carry = first.high;
    for (std::size_t i = 1; i < e.size; ++i) {
        const Pair term = two_product(e.terms[i], factor);
        const Pair lower = two_sum(carry, term.low);
        result.push(lower.low);
        const Pair upper = fast_two_sum(term.high, lower.high);
        result.push(upper.low);
        carry = upper.high;
    }
    result.push(carry);
    return result;
}

template <std::size_t N>
Expansion<4 * N> product(const Expansion<N>& e, const Expansion<2>& f)
{
    Expansion<4 * N> result;
    if (f.size == 0) return result;
    const auto first = scaled(e, f.terms[0]);
    const auto second = f.size == 2 ? scaled(e, f.terms[1]) : Expansion<2 * N>();
    return sum(first, second);
}

}  // namespace hw
