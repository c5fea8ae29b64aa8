#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace hw {

/// A signed whole number of 320 bits in two's complement: wide enough for the determinant of four grid planes (262
/// bits). Overflow wraps; whoever adds a product shows that it fits.
class WideInt {
 public:
    WideInt() = default;
    explicit WideInt(__int128 value)
    {
        words_[0] = static_cast<std::uint64_t>(value);
        words_[1] = static_cast<std::uint64_t>(value >> 64);
        for (std::size_t i = 2; i < kWords; ++i) words_[i] = value < 0 ? ~std::uint64_t{0} : 0;
    }

    int sign() const
    {
        if (is_negative()) return -1;
        for (const std::uint64_t word : words_) {
            if (word != 0) return 1;
        }
        return 0;
    }

    WideInt operator-() const
    {
        WideInt result;
        std::uint64_t carry = 1;
        for (std::size_t i = 0; i < kWords; ++i) {
            result.words_[i] = ~words_[i] + carry;
            carry = carry != 0 && result.words_[i] == 0 ? 1 : 0;
        }
        return result;
    }

    WideInt operator+(const WideInt& other) const
    {
        WideInt result;
        unsigned __int128 sum = 0;
        for (std::size_t i = 0; i < kWords; ++i) {
            sum += static_cast<unsigned __int128>(words_[i]) + other.words_[i];
            result.words_[i] = static_cast<std::uint64_t>(sum);
            sum >>= 64;
        }
        return result;
    }

    WideInt operator-(const WideInt& other) const { return *this + (-other); }

    /// In two's complement the low words of a product do not depend on the signs.
    WideInt operator*(const WideInt& other) const
    {
        WideInt result;
        for (std::size_t i = 0; i < kWords; ++i) {
            unsigned __int128 carry = 0;
            for (std::size_t j = 0; i + j < kWords; ++j) {
                carry += static_cast<unsigned __int128>(words_[i]) * other.words_[j] + result.words_[i + j];
                result.words_[i + j] = static_cast<std::uint64_t>(carry);
                carry >>= 64;
            }
        }
        return result;
    }

    /// Rounded to about one unit in the last place.
    double to_double() const
    {
        if (is_negative()) return -(-*this).to_double();
        double result = 0.0;
        for (std::size_t i = kWords; i-- > 0;) result = result * 0x1p64 + static_cast<double>(words_[i]);
        return result;
    }

 private:
    static constexpr std::size_t kWords = 5;
    bool is_negative() const { return (words_[kWords - 1] >> 63) != 0; }

    std::array<std::uint64_t, kWords> words_{};
};

}  // namespace hw
