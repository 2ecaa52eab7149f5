#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scb/observer.h"

namespace scb {

/// The offset basis of 64-bit FNV-1a.
inline constexpr std::uint64_t fnv_offset_basis = 0xcbf29ce484222325;

/// 64-bit FNV-1a (Fowler, Noll and Vo, draft-eastlake-fnv) over the pairs in order, each written as
/// "A B\n" in decimal: tells apart answers with equal numbers of pairs. `start`: the first hash
/// value, for recorded hashes with another basis.
std::uint64_t pairs_hash(std::span<const IndexPair> pairs, std::uint64_t start = fnv_offset_basis);

/// One hash of the pairs of several queries, from the hash of each in order. It begins with the
/// first hash, and continues over the 16 digits of each further hash.
std::uint64_t joined_hash(std::span<const std::uint64_t> hashes);

/// A hash as 16 hexadecimal digits, small letters.
std::string hash_text(std::uint64_t hash);

/// Sorts pairs by a, then b: a radix sort, least significant digit first. `room`: scratch space,
/// resized as needed.
void sort_pairs(std::vector<IndexPair>& pairs, std::vector<IndexPair>& room);

}  // namespace scb
