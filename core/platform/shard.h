#pragma once

#include <cstddef>
#include <string_view>

namespace scb {

/// One of several shares of a long run, each for a machine of its own: the k-th of n, from 1.
struct Shard {
    std::size_t k = 1, n = 1;

    friend bool operator==(const Shard&, const Shard&) = default;
};

/// Reads "K/N", such as "2/3". Throws InputError if it has another form, or K is not in 1 to N.
Shard parse_shard(std::string_view text);

/// Whether the part of the run with this index, from 0, belongs to the shard. Shards take parts in
/// turn: each part belongs to one shard, and the numbers of parts differ by at most one.
bool in_shard(const Shard& shard, std::size_t index);

}  // namespace scb
