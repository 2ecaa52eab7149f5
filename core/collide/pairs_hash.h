#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "scb/observer.h"

namespace scb {

/// Where FNV-1a of 64 bits begins.
inline constexpr std::uint64_t fnv_offset_basis = 0xcbf29ce484222325;

/// FNV-1a of 64 bits (Fowler, Noll and Vo, draft-eastlake-fnv) over the pairs in their order, each
/// written as "A B\n" in decimal: two answers with as many pairs, but others, have other hashes.
/// `start`: where it begins, for records of hashes that begin elsewhere.
std::uint64_t pairs_hash(std::span<const IndexPair> pairs, std::uint64_t start = fnv_offset_basis);

/// One hash of the pairs of several queries, of the hashes of each in their order: that of the
/// first, and then, begun there, of the 16 digits of each other.
std::uint64_t joined_hash(std::span<const std::uint64_t> hashes);

/// A hash as 16 hexadecimal digits, small letters.
std::string hash_text(std::uint64_t hash);

}  // namespace scb
