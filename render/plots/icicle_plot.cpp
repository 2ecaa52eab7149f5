#include "render/plots/icicle_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/analysis/costly_tests.h"
#include "core/analysis/outcome.h"
#include "render/overlay/figure_layout.h"
#include "render/overlay/font_face.h"
#include "render/plots/icicle.h"

namespace scb::render {
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
