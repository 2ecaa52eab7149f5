#include "core/collide/index_pairs.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace scb {
namespace {

class Fnv1a {
  public:
    explicit Fnv1a(std::uint64_t start) : value_(start) {}

    void add(char byte) {
        constexpr std::uint64_t prime = 0x100000001b3;
        value_ = (value_ ^ static_cast<unsigned char>(byte)) * prime;
    }
    void add(std::uint32_t number) {
        std::array<char, 10> decimal;
        const char* end =
            std::to_chars(decimal.data(), decimal.data() + decimal.size(), number).ptr;
        for (const char* digit = decimal.data(); digit != end; ++digit) add(*digit);
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_;
};

}  // namespace

std::uint64_t pairs_hash(std::span<const IndexPair> pairs, std::uint64_t start) {
    Fnv1a hash(start);
    for (const IndexPair& pair : pairs) {
        hash.add(pair.a);
        hash.add(' ');
        hash.add(pair.b);
        hash.add('\n');
    }
    return hash.value();
}

std::uint64_t joined_hash(std::span<const std::uint64_t> hashes) {
    std::uint64_t joined = hashes.empty() ? fnv_offset_basis : hashes.front();
    for (std::size_t i = 1; i < hashes.size(); ++i) {
        Fnv1a hash(joined);
        for (const char digit : hash_text(hashes[i])) hash.add(digit);
        joined = hash.value();
    }
    return joined;
}

std::string hash_text(std::uint64_t hash) {
    constexpr std::size_t size = 16;
    std::string text(size, '0');
    for (std::size_t i = size; i-- > 0; hash >>= 4) text[i] = "0123456789abcdef"[hash & 0xf];
    return text;
}

namespace {

constexpr int digit_bits = 8;
constexpr std::size_t digits = std::size_t{1} << digit_bits;

/// Sorts by one digit of one index, stably.
template <class Index>
void sort_by_digit(const std::vector<IndexPair>& from, std::vector<IndexPair>& to, Index index,
                   int shift) {
    std::array<std::uint32_t, digits> next{};
    const auto digit = [&](const IndexPair& pair) { return index(pair) >> shift & (digits - 1); };
    for (const IndexPair& pair : from) ++next[digit(pair)];
    std::uint32_t sum = 0;
    for (std::uint32_t& count : next) {
        const std::uint32_t here = count;
        count = sum;
        sum += here;
    }
    for (const IndexPair& pair : from) to[next[digit(pair)]++] = pair;
}

}  // namespace

void sort_pairs(std::vector<IndexPair>& pairs, std::vector<IndexPair>& room) {
    // Fewer pairs are sorted faster by comparison.
    constexpr std::size_t few = 200;
    if (pairs.size() < few) {
        std::sort(pairs.begin(), pairs.end());
        return;
    }
    std::uint32_t most_a = 0, most_b = 0;
    for (const IndexPair& pair : pairs) {
        most_a = std::max(most_a, pair.a);
        most_b = std::max(most_b, pair.b);
    }
    room.resize(pairs.size());
    const auto sort_by = [&](auto index, std::uint32_t most) {
        for (int shift = 0; shift < 32 && most >> shift != 0; shift += digit_bits) {
            sort_by_digit(pairs, room, index, shift);
            pairs.swap(room);
        }
    };
    sort_by([](const IndexPair& pair) { return pair.b; }, most_b);
    sort_by([](const IndexPair& pair) { return pair.a; }, most_a);
}

}  // namespace scb
