#pragma once

#include <cstdint>

namespace scb {

/// A hash of a sequence of words: FNV-1a (Fowler, Noll, Vo) with words in place of bytes, and a
/// shift that carries high bits down. The same on every machine; not safe against adversaries.
struct WordHash {
    std::uint64_t value = 0xcbf29ce484222325;

    void add(std::uint64_t word) {
        value = (value ^ word) * 0x100000001b3;
        value ^= value >> 29;
    }
};

}  // namespace scb
