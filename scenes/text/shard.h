#pragma once

#include <cstddef>
#include <string_view>

namespace scb::scenes {

/// One of several shares of a long run that are done on machines of their own: the k-th of n, from
/// 1.
struct Shard {
    std::size_t k = 1, n = 1;

    friend bool operator==(const Shard&, const Shard&) = default;
};

/// Reads "K/N", such as "2/3". Throws InputError where it is not that, or K is not in 1 to N.
Shard parse_shard(std::string_view text);

/// Whether the part of the run with that index, from 0, belongs to the shard. Parts are dealt in
/// turn: each belongs to one shard of n, and none has two parts more than another.
bool in_shard(const Shard& shard, std::size_t index);

}  // namespace scb::scenes
