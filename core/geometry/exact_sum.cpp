#include "core/geometry/exact_sum.h"

#include <algorithm>
#include <bit>

namespace scb {
namespace {

__extension__ typedef unsigned __int128 Uint128;

constexpr int limb_bits = 32;
constexpr std::uint64_t digit_mask = 0xffffffffu;

// The product of three mantissas has 159 bits; shifted by up to 31, it takes six digits.
constexpr int product_digits = 6;

}  // namespace

Dyadic::Dyadic(double value) {
    constexpr std::uint64_t fraction_mask = (std::uint64_t{1} << 52) - 1;
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const int field = static_cast<int>((bits >> 52) & 0x7ff);
    negative = (bits >> 63) != 0;
    mantissa = (bits & fraction_mask) | (field == 0 ? 0 : fraction_mask + 1);
    exponent = (field == 0 ? 1 : field) - 1075;
}

ExactSum::ExactSum(int lowest_exponent, int highest_exponent)
    : count_((highest_exponent - lowest_exponent) / limb_bits + product_digits + 1),
      lowest_exponent_(lowest_exponent) {
    std::fill_n(digits_.begin(), count_, 0);
}

void ExactSum::accumulate(const Dyadic& x, const Dyadic& y, const Dyadic& z, bool negate) {
    if (x.mantissa == 0 || y.mantissa == 0 || z.mantissa == 0) return;
    const auto shift =
        static_cast<unsigned>(x.exponent + y.exponent + z.exponent - lowest_exponent_);
    const unsigned low_shift = shift % limb_bits;

    // xy < 2^106, so its upper word times z, shifted, still fits 128 bits.
    const Uint128 xy = static_cast<Uint128>(x.mantissa) * y.mantissa;
    const Uint128 low = static_cast<Uint128>(static_cast<std::uint64_t>(xy)) * z.mantissa;
    const Uint128 high = (xy >> 64) * z.mantissa + (low >> 64);
    const Uint128 shifted_low = static_cast<Uint128>(static_cast<std::uint64_t>(low)) << low_shift;
    const Uint128 shifted_high = (high << low_shift) + (shifted_low >> 64);
    const std::array<std::uint64_t, 3> words{static_cast<std::uint64_t>(shifted_low),
                                             static_cast<std::uint64_t>(shifted_high),
                                             static_cast<std::uint64_t>(shifted_high >> 64)};

    const std::int64_t sign = (static_cast<int>(x.negative) ^ static_cast<int>(y.negative) ^
                               static_cast<int>(z.negative) ^ static_cast<int>(negate)) != 0
                                  ? -1
                                  : 1;
    std::int64_t* digit = digits_.data() + shift / limb_bits;
    for (const std::uint64_t word : words) {
        *digit++ += sign * static_cast<std::int64_t>(word & digit_mask);
        *digit++ += sign * static_cast<std::int64_t>(word >> limb_bits);
    }
}

int ExactSum::sign() const {
    std::int64_t carry = 0;
    std::uint64_t any = 0;
    for (int i = 0; i < count_; ++i) {
        const std::int64_t digit = digits_[static_cast<std::size_t>(i)] + carry;
        any |= static_cast<std::uint64_t>(digit) & digit_mask;
        carry = digit >> limb_bits;  // rounds down, so digits stay in 0 .. 2^32 - 1
    }
    // The last digit can hold the sum of positive products, so no carry leaves it.
    return carry < 0 ? -1 : any != 0 ? 1 : 0;
}

ScaledDouble ExactSum::value() const {
    const bool negative = sign() < 0;
    std::array<std::uint32_t, max_digits + 2> magnitude{};  // two zeros, then the digits
    std::int64_t carry = 0;
    int top = 2;
    for (int i = 0; i < count_; ++i) {
        const std::int64_t word = digits_[static_cast<std::size_t>(i)];
        const std::int64_t digit = (negative ? -word : word) + carry;
        const auto place = static_cast<std::size_t>(i + 2);
        magnitude[place] = static_cast<std::uint32_t>(static_cast<std::uint64_t>(digit));
        if (magnitude[place] != 0) top = i + 2;
        carry = digit >> limb_bits;
    }
    const auto at = static_cast<std::size_t>(top);
    const double upper = magnitude[at] * 0x1p64 + magnitude[at - 1] * 0x1p32 + magnitude[at - 2];
    return {negative ? -upper : upper, lowest_exponent_ + (top - 4) * limb_bits};
}

}  // namespace scb
