#include "render/plots/icicle.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "core/analysis/traversal_tree.h"

namespace scb::render {
namespace {

std::size_t depth_of(const VolumeTest& test) { return std::size_t{test.depth_a} + test.depth_b; }

/// Where each test begins, in tests.
std::vector<std::uint32_t> begins_of(const TraversalTree& tree,
                                     const std::vector<std::uint32_t>& sizes) {
    std::vector<std::uint32_t> begins(sizes.size(), 0);
    std::vector<std::uint32_t> next(sizes.size(), 0);  // where a test's next child begins
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const std::uint32_t parent = tree.parents[i];
        if (parent != TraversalTree::no_parent) {
            begins[i] = next[parent];
            next[parent] += sizes[i];
        }
        next[i] = begins[i];
    }
    return begins;
}

/// The tests of each row, in their order.
std::vector<std::vector<std::uint32_t>> rows_of(const std::vector<VolumeTest>& tests,
                                                std::size_t depths_per_row) {
    std::vector<std::vector<std::uint32_t>> rows;
    for (std::uint32_t i = 0; i < tests.size(); ++i) {
        const std::size_t row = depth_of(tests[i]) / depths_per_row;
        if (row >= rows.size()) rows.resize(row + 1);
        rows[row].push_back(i);
    }
    return rows;
}

/// For each outcome the index of its group; groups.size() for pairs that were divided.
class GroupIndex {
  public:
    explicit GroupIndex(const std::vector<EndingGroup>& groups)
        : divided_(static_cast<std::uint32_t>(groups.size())) {
        for (std::uint32_t g = 0; g < groups.size(); ++g)
            for (const Outcome ending : groups[g].endings)
                of_[static_cast<std::size_t>(ending)] = g;
    }
    std::uint32_t operator()(Outcome outcome) const {
        return is_ending(outcome) ? of_[static_cast<std::size_t>(outcome)] : divided_;
    }
    std::uint32_t divided() const { return divided_; }

  private:
    std::uint32_t divided_;
    std::array<std::uint32_t, ending_count> of_{};
};

/// One column of a row.
struct Column {
    std::array<std::uint32_t, ending_count + 1> tests{};  ///< per group that touch it
    std::uint32_t touched = 0;                            ///< their sum
    std::uint32_t last = 0;                               ///< the last one that touches it
};

/// Picks the outcomes of the columns of a row, from left to right.
class Picker {
  public:
    std::uint32_t operator()(const Column& column) {
        std::size_t best = credit_.size();
        for (std::size_t g = 0; g < credit_.size(); ++g) {
            if (column.tests[g] == 0) continue;
            credit_[g] += one * column.tests[g] / column.touched;
            if (best == credit_.size() || credit_[g] > credit_[best]) best = g;
        }
        credit_[best] -= one;
        return static_cast<std::uint32_t>(best);
    }

  private:
    static constexpr std::int64_t one = 1 << 24;  // a column
    std::array<std::int64_t, ending_count + 1> credit_{};
};

}  // namespace

Icicle icicle(const Events& events, const TraversalTree& tree,
              const std::vector<EndingGroup>& groups, int columns, int most_rows) {
    assert(columns > 0 && most_rows > 0 && "an icicle has pixels");
    assert(groups.size() <= ending_count && "each ending is in one group");
    const std::vector<VolumeTest>& tests = events.volume_tests;
    Icicle result;
    result.columns = columns;
    if (tests.empty()) return result;

    std::size_t depths = 0;
    for (const VolumeTest& test : tests) depths = std::max(depths, depth_of(test) + 1);
    const auto most = static_cast<std::size_t>(most_rows);
    const std::size_t per_row = (depths + most - 1) / most;
    result.depths_per_row = static_cast<int>(per_row);
    const std::vector<std::uint32_t> sizes = subtree_sizes(tree);
    const std::vector<std::uint32_t> begins = begins_of(tree, sizes);
    const std::vector<std::vector<std::uint32_t>> rows = rows_of(tests, per_row);
    result.rows = static_cast<int>(rows.size());
    const GroupIndex group_of(groups);

    const auto width = static_cast<std::uint64_t>(columns);
    const std::uint64_t all = sizes[0];
    std::vector<Column> line(width);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        std::fill(line.begin(), line.end(), Column{});
        for (const std::uint32_t i : rows[row]) {
            const std::uint32_t group = group_of(tree.outcomes[i]);
            const std::uint64_t first = begins[i] * width / all;
            const std::uint64_t behind =
                ((begins[i] + std::uint64_t{sizes[i]}) * width + all - 1) / all;
            for (std::uint64_t x = first; x < behind; ++x) {
                ++line[x].tests[group];
                ++line[x].touched;
                line[x].last = i;
            }
        }
        Picker picker;
        for (int x = 0; x < columns; ++x) {
            const Column& column = line[static_cast<std::size_t>(x)];
            if (column.touched == 0) continue;
            const bool alone = column.touched == 1;
            std::uint32_t group = alone ? group_of(tree.outcomes[column.last]) : picker(column);
            if (group == group_of.divided()) group = IcicleRun::divided;
            const std::uint32_t test = alone ? column.last : IcicleRun::several;
            if (!result.runs.empty()) {
                IcicleRun& before = result.runs.back();
                if (before.row == static_cast<int>(row) && before.end == x &&
                    before.group == group && before.test == test) {
                    ++before.end;
                    continue;
                }
            }
            result.runs.push_back({static_cast<int>(row), x, x + 1, group, test});
        }
    }
    return result;
}

}  // namespace scb::render
