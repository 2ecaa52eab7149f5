#include "render/plots/icicle.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

#include "core/analysis/outcome.h"
#include "core/analysis/traversal_part.h"
#include "render/overlay/figure_layout.h"
#include "render/overlay/font_face.h"

namespace scb::render {
namespace {

std::size_t depth_of(const Step& test) { return std::size_t{test.depth_a} + test.depth_b; }

/// The position at which each test begins, in tests.
std::vector<std::uint32_t> begins_of(const std::vector<Step>& tests,
                                     const std::vector<std::uint32_t>& sizes) {
    std::vector<std::uint32_t> begins(sizes.size(), 0);
    std::vector<std::uint32_t> next(sizes.size(), 0);  // the begin of each test's next child
    std::uint32_t next_root = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const std::uint32_t parent = tests[i].parent;
        if (parent != no_step) {
            begins[i] = next[parent];
            next[parent] += sizes[i];
        } else {
            begins[i] = next_root;
            next_root += sizes[i];
        }
        next[i] = begins[i];
    }
    return begins;
}

/// The tests of each row, in their order.
std::vector<std::vector<std::uint32_t>> rows_of(const std::vector<Step>& tests,
                                                std::size_t first_depth,
                                                std::size_t depths_per_row) {
    std::vector<std::vector<std::uint32_t>> rows;
    for (std::uint32_t i = 0; i < tests.size(); ++i) {
        const std::size_t row = (depth_of(tests[i]) - first_depth) / depths_per_row;
        if (row >= rows.size()) rows.resize(row + 1);
        rows[row].push_back(i);
    }
    return rows;
}

/// The index of each outcome's group; groups.size() for divided pairs.
class GroupIndex {
  public:
    explicit GroupIndex(const std::vector<EndingGroup>& groups)
        : divided_(static_cast<std::uint32_t>(groups.size())) {
        for (std::uint32_t g = 0; g < groups.size(); ++g)
            for (const Stage ending : groups[g].endings) of_[static_cast<std::size_t>(ending)] = g;
    }
    std::uint32_t operator()(Stage outcome) const {
        return is_ending(outcome) ? of_[static_cast<std::size_t>(outcome)] : divided_;
    }
    std::uint32_t divided() const { return divided_; }

  private:
    std::uint32_t divided_;
    std::array<std::uint32_t, StageTable::most_rows> of_{};
};

/// One column of a row. Widths are exact integers: a column has the width of the number of tests, a
/// test the width of the number of columns.
struct Column {
    std::array<std::uint64_t, most_groups + 1> covered{};   ///< by each group
    std::uint32_t touched = 0;                              ///< tests that touch it
    std::uint32_t begins = 0;                               ///< tests whose first column it is
    std::array<std::uint32_t, most_groups + 1> begin_in{};  ///< of these, the tests of each group
    std::uint32_t last = 0;                                 ///< the last test that touches it
};

std::uint32_t largest_group(const Column& column) {
    const auto most = std::max_element(column.covered.begin(), column.covered.end());
    return static_cast<std::uint32_t>(most - column.covered.begin());
}

/// Adds columns that are drawn test by test.
void add_runs(Icicle& icicle, int row, const std::vector<Column>& line, int begin, int end,
              std::uint32_t divided) {
    for (int x = begin; x < end; ++x) {
        const Column& column = line[static_cast<std::size_t>(x)];
        if (column.touched == 0) continue;
        std::uint32_t group = largest_group(column);
        if (group == divided) group = IcicleRun::divided;
        const std::uint32_t test = column.touched == 1 ? column.last : IcicleRun::several;
        if (!icicle.runs.empty()) {
            IcicleRun& before = icicle.runs.back();
            if (before.row == row && before.end == x && before.group == group &&
                before.test == test) {
                ++before.end;
                continue;
            }
        }
        icicle.runs.push_back({row, x, x + 1, group, test});
    }
}

/// Adds columns as one stack.
void add_stack(Icicle& icicle, int row, const std::vector<Column>& line, int begin, int end,
               std::uint32_t divided) {
    IcicleStack stack{row, begin, end, 0, 0, {}};
    for (int x = begin; x < end; ++x) {
        const Column& column = line[static_cast<std::size_t>(x)];
        stack.tests += column.begins;
        stack.divided += column.begin_in[divided];
        for (std::uint32_t g = 0; g < divided; ++g) stack.groups[g] += column.begin_in[g];
    }
    icicle.stacks.push_back(stack);
}

}  // namespace

Icicle icicle(const Steps& steps, const Outcomes& outcomes, const std::vector<EndingGroup>& groups,
              int columns, int most_rows, int block) {
    assert(columns > 0 && most_rows > 0 && block > 0 && "an icicle has pixels");
    assert(groups.size() <= most_groups && "each ending is in one group");
    const std::vector<Step>& tests = steps.volumes;
    Icicle result;
    result.columns = columns;
    if (tests.empty()) return result;

    std::size_t first_depth = depth_of(tests[0]);
    for (const Step& test : tests) first_depth = std::min(first_depth, depth_of(test));
    std::size_t depths = 0;
    for (const Step& test : tests) depths = std::max(depths, depth_of(test) - first_depth + 1);
    const auto most = static_cast<std::size_t>(most_rows);
    const std::size_t per_row = (depths + most - 1) / most;
    result.first_depth = static_cast<int>(first_depth);
    result.depths_per_row = static_cast<int>(per_row);
    const std::vector<std::uint32_t> sizes = subtree_sizes(steps);
    const std::vector<std::uint32_t> begins = begins_of(tests, sizes);
    const std::vector<std::vector<std::uint32_t>> rows = rows_of(tests, first_depth, per_row);
    result.rows = static_cast<int>(rows.size());
    const GroupIndex group_of(groups);

    const auto width = static_cast<std::uint64_t>(columns);
    const std::uint64_t all = tests.size();
    std::vector<Column> line(width);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        std::fill(line.begin(), line.end(), Column{});
        for (const std::uint32_t i : rows[row]) {
            const std::uint32_t group = group_of(outcomes[i]);
            const std::uint64_t begin = std::uint64_t{begins[i]} * width;
            const std::uint64_t end = begin + std::uint64_t{sizes[i]} * width;
            ++line[begin / all].begins;
            ++line[begin / all].begin_in[group];
            for (std::uint64_t x = begin / all; x * all < end; ++x) {
                line[x].covered[group] += std::min(end, (x + 1) * all) - std::max(begin, x * all);
                ++line[x].touched;
                line[x].last = i;
            }
        }
        for (int begin = 0; begin < columns; begin += block) {
            const int end = std::min(begin + block, columns);
            std::uint32_t in_block = 0;
            for (int x = begin; x < end; ++x) in_block += line[static_cast<std::size_t>(x)].begins;
            const int at = static_cast<int>(row);
            if (2 * in_block > static_cast<std::uint32_t>(end - begin))
                add_stack(result, at, line, begin, end, group_of.divided());
            else
                add_runs(result, at, line, begin, end, group_of.divided());
        }
    }
    return result;
}

namespace {

// Rectangles of at least this width end with a thin line, and rows of at least this height with a
// line of background. Within a row, background means no tests.
constexpr int least_parted_width = 5, least_parted_height = 5;
constexpr int least_icicle_text = 9;
constexpr int block_width = 8;

/// Shares of a stack as whole rows of pixels, from the top: divided pairs, then the groups of
/// endings. Rounding errors are carried to the next stack of the row, so that rare outcomes also
/// have their share along the row.
class StackRows {
  public:
    /// The y at which each of them ends.
    std::vector<int> operator()(const IcicleStack& stack, std::size_t groups, int height) {
        if (stack.row != row_ || stack.begin != end_) carried_.fill(0);
        row_ = stack.row;
        end_ = stack.end;
        std::vector<int> ends;
        int y = 0;
        for (std::size_t part = 0; part <= groups; ++part) {
            const std::uint32_t tests = part == 0 ? stack.divided : stack.groups[part - 1];
            const double wish = static_cast<double>(height) * tests / stack.tests + carried_[part];
            const int rows = std::clamp(static_cast<int>(std::lround(wish)), 0, height - y);
            carried_[part] = wish - rows;
            y += rows;
            ends.push_back(y);
        }
        return ends;
    }

  private:
    int row_ = -1, end_ = 0;
    std::array<double, most_groups + 1> carried_{};
};

}  // namespace

Rgba8 divided_color(const Theme& theme) { return mix(theme.background, theme.text, 0.1); }

DrawnIcicle draw_icicle(Overlay& overlay, const PixelRect& rect, const Steps& steps,
                        const Outcomes& outcomes, const std::vector<EndingGroup>& groups,
                        const FigureStyle& style) {
    const Theme& theme = style.theme;
    const int unit = style.unit, small = small_size(unit);
    const TextStyle label{small, FontWeight::regular, theme.faint_text, Align::right};
    const int left = overlay.measure("00", label).width + unit / 3;
    if (rect.width <= left || rect.height < 1) return {{rect.x, rect.y, 0, 0}};
    const Icicle icicle =
        render::icicle(steps, outcomes, groups, rect.width - left, rect.height, block_width);
    if (icicle.rows == 0) return {{rect.x, rect.y, 0, 0}};
    DrawnIcicle drawn{{rect.x, rect.y, rect.width, 0}, false, !icicle.stacks.empty()};
    const std::vector<std::uint32_t> sizes = subtree_sizes(steps);

    const int row_height = std::min(rect.height / icicle.rows, 2 * unit);
    const int row_gap = row_height >= least_parted_height ? 1 : 0;
    const int text = std::min(small, row_height - row_gap);
    StackRows rows_of;
    for (const IcicleStack& stack : icicle.stacks) {
        const int top = rect.y + stack.row * row_height;
        int y = 0;
        const std::vector<int> ends = rows_of(stack, groups.size(), row_height - row_gap);
        for (std::size_t part = 0; part < ends.size(); ++part) {
            if (ends[part] > y)
                overlay.rectangle(
                    {rect.x + left + stack.begin, top + y, stack.end - stack.begin, ends[part] - y},
                    part == 0 ? divided_color(theme) : groups[part - 1].color);
            y = ends[part];
        }
    }
    for (const IcicleRun& run : icicle.runs) {
        PixelRect box{rect.x + left + run.begin, rect.y + run.row * row_height, run.end - run.begin,
                      row_height - row_gap};
        const bool divided = run.group == IcicleRun::divided;
        overlay.rectangle(box, divided ? divided_color(theme) : groups[run.group].color);
        if (box.width >= least_parted_width && run.test != IcicleRun::several)
            overlay.rectangle({--box.width + box.x, box.y, 1, box.height}, theme.border);
        if (!divided || run.test == IcicleRun::several || text < least_icicle_text) continue;
        const TextStyle number{text, FontWeight::regular, theme.text, Align::center};
        const std::string count = count_text(sizes[run.test]);
        if (overlay.measure(count, number).width + unit / 2 > box.width) continue;
        overlay.text(box.x + box.width / 2, box.y + (box.height - text) / 2, count, number);
        drawn.numbers = true;
    }

    int stride = 1;
    for (const int factor : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000}) {
        stride = factor;
        if (row_height * factor >= small) break;
    }
    for (int row = 0; row < icicle.rows; row += stride)
        overlay.text(rect.x + left - unit / 3,
                     rect.y + row * row_height + (row_height - row_gap - small) / 2,
                     std::to_string(icicle.first_depth + row * icicle.depths_per_row), label);
    drawn.covered.height = icicle.rows * row_height;
    return drawn;
}

}  // namespace scb::render
