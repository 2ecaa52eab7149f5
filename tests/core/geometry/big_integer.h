#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace scb {

/// An integer of any size, for references in tests: slow, and as plain as can be.
class BigInteger {
  public:
    BigInteger(std::int64_t value = 0) {
        const bool negative = value < 0;
        auto rest =
            negative ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
        for (; rest != 0; rest >>= 32) digits_.push_back(static_cast<std::uint32_t>(rest));
        negative_ = negative;
    }

    int sign() const { return digits_.empty() ? 0 : negative_ ? -1 : 1; }

    BigInteger operator-() const {
        BigInteger result = *this;
        result.negative_ = !negative_;
        return result;
    }

    friend BigInteger operator+(const BigInteger& a, const BigInteger& b) {
        BigInteger result;
        if (a.negative_ == b.negative_) {
            result.digits_ = sum(a.digits_, b.digits_);
            result.negative_ = a.negative_;
        } else if (less(a.digits_, b.digits_)) {
            result.digits_ = difference(b.digits_, a.digits_);
            result.negative_ = b.negative_;
        } else {
            result.digits_ = difference(a.digits_, b.digits_);
            result.negative_ = a.negative_;
        }
        return result;
    }

    friend BigInteger operator-(const BigInteger& a, const BigInteger& b) { return a + -b; }

    friend BigInteger operator*(const BigInteger& a, const BigInteger& b) {
        BigInteger result;
        result.digits_.assign(a.digits_.size() + b.digits_.size(), 0);
        for (std::size_t i = 0; i < a.digits_.size(); ++i) {
            std::uint64_t carry = 0;
            for (std::size_t j = 0; j < b.digits_.size(); ++j) {
                carry += std::uint64_t{a.digits_[i]} * b.digits_[j] + result.digits_[i + j];
                result.digits_[i + j] = static_cast<std::uint32_t>(carry);
                carry >>= 32;
            }
            result.digits_[i + b.digits_.size()] = static_cast<std::uint32_t>(carry);
        }
        trim(result.digits_);
        result.negative_ = a.negative_ != b.negative_;
        return result;
    }

  private:
    using Digits = std::vector<std::uint32_t>;  // lowest first, the last one not zero

    static void trim(Digits& digits) {
        while (!digits.empty() && digits.back() == 0) digits.pop_back();
    }

    static bool less(const Digits& a, const Digits& b) {
        if (a.size() != b.size()) return a.size() < b.size();
        return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
    }

    static Digits sum(const Digits& a, const Digits& b) {
        Digits result;
        std::uint64_t carry = 0;
        for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
            if (i < a.size()) carry += a[i];
            if (i < b.size()) carry += b[i];
            result.push_back(static_cast<std::uint32_t>(carry));
            carry >>= 32;
        }
        result.push_back(static_cast<std::uint32_t>(carry));
        trim(result);
        return result;
    }

    static Digits difference(const Digits& larger, const Digits& smaller) {
        Digits result;
        std::int64_t carry = 0;
        for (std::size_t i = 0; i < larger.size(); ++i) {
            carry += std::int64_t{larger[i]} - (i < smaller.size() ? std::int64_t{smaller[i]} : 0);
            result.push_back(static_cast<std::uint32_t>(carry & 0xffffffff));
            carry >>= 32;
        }
        trim(result);
        return result;
    }

    Digits digits_;
    bool negative_ = false;
};

inline int sign_of(const BigInteger& value) { return value.sign(); }
inline int sign_of(std::int64_t value) { return (value > 0) - (value < 0); }

}  // namespace scb
