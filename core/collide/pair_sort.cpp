#include "core/collide/pair_sort.h"

#include <algorithm>
#include <array>

namespace scb {
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
