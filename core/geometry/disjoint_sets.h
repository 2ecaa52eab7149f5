#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace scb {

/// Disjoint sets that can be joined; one of its members represents each set.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t i, std::uint32_t j) { parent_[find(i)] = find(j); }

  private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace scb
