#include "render/figures/traversal_figure.h"

#include <algorithm>
#include <vector>

#include "core/analysis/depth_matrix.h"
#include "render/figures/distance_figure.h"
#include "render/overlay/figure_layout.h"
#include "render/overlay/font_face.h"
#include "render/plots/bounds_plot.h"
#include "render/plots/ending_colors.h"
#include "render/plots/icicle.h"

namespace scb::render {
namespace {

/// Plots that are less tall, in text units, have neither legend nor notes.
constexpr int least_body = 14;

/// A remark on things that a reader would otherwise miss; may be empty.
std::string remark_of(const TraceHeader& header, const Collision& found, bool part) {
    if (is_of_distance(header.kind))
        return !found.pairs.empty()               ? ""
               : header.kind == QueryKind::within ? "no triangles are so near"
                                                  : "nothing within the limit";
    if (part) return found.pairs.empty() ? "no pairs below it" : "";
    if (found.n_v == 0) return "no tests of volumes were recorded";
    if (!found.complete)
        return "stopped at " + count_text(found.pairs.size()) +
               (found.pairs.size() == 1 ? " pair" : " pairs");
    if (!found.pairs.empty()) return "";
    if (found.n_v == 1 && found.stages[static_cast<std::size_t>(Stage::overlapping)] == 0)
        return "no overlap: 1 test";
    if (header.options.stop_level >= 0)
        return "no overlap at level " + std::to_string(header.options.stop_level);
    return "no contact";
}

/// In tenths of a percent, rounded to the nearest.
std::string share_text(std::uint64_t part, std::uint64_t all) {
    if (all == 0) return "–";
    const std::uint64_t tenths = (2000 * part + all) / (2 * all);
    if (tenths == 0 && part > 0) return "<0.1 %";
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " %";
}

/// A count and its name.
struct Number {
    std::string label, value;
};

std::uint64_t deepest_pair(const Steps& steps) {
    std::uint64_t deepest = 0;
    for (const Step& step : steps.volumes)
        deepest = std::max(deepest, std::uint64_t{step.depth_a} + step.depth_b);
    return deepest;
}

std::vector<Number> numbers_of(const TraceHeader& header, const QueryTrace& frame,
                               const DepthMatrix& matrix) {
    const Collision& found = frame.found;
    const std::size_t of_a = matrix.depths_a, of_b = matrix.depths_b;
    std::string depth = count_text(deepest_pair(frame.steps));
    if (of_a > 0 && of_b > 0)
        depth +=
            "; A down to " + std::to_string(of_a - 1) + ", B down to " + std::to_string(of_b - 1);
    const std::uint64_t rejected =
        found.n_v - found.stages[static_cast<std::size_t>(Stage::overlapping)];
    std::vector<Number> numbers = {
        frame.nearest ? Number{"distance", distance_text(frame.nearest->distance)}
        : header.kind == QueryKind::distance ? Number{"distance", "none"}
                                             : Number{"pairs", count_text(found.pairs.size())},
        {"N_v", count_text(found.n_v)},
        {is_of_distance(header.kind) ? "left out" : "rejected",
         count_text(rejected) + " (" + share_text(rejected, found.n_v) + " of N_v)"},
        {"N_p", count_text(found.n_p)}};
    if (!header.engine) numbers.push_back({"N_u", count_text(found.n_u)});
    numbers.push_back({"deepest pair", depth});
    return numbers;
}

/// Draws numbers in a row, or in several rows if they are too many. Returns the y below.
int draw_numbers(Overlay& overlay, const PixelRect& rect, const std::vector<Number>& numbers,
                 const std::string& remark, const FigureStyle& style) {
    const int unit = style.unit;
    const TextStyle name{unit, FontWeight::regular, style.theme.faint_text};
    const TextStyle value{unit, FontWeight::bold, style.theme.text};
    int x = rect.x, y = rect.y;
    const auto place = [&](int width) {
        if (x > rect.x && x + width > rect.x + rect.width) {
            x = rect.x;
            y += unit * 5 / 4;
        }
    };
    if (!remark.empty()) {
        const TextStyle loud{unit, FontWeight::bold, style.theme.accent};
        overlay.text(x, y, fitted_text(overlay, remark, loud, rect.width), loud);
        x += overlay.measure(remark, loud).width + unit * 3 / 2;
    }
    for (const Number& number : numbers) {
        const int before = overlay.measure(number.label, name).width + unit / 3;
        const int width = before + overlay.measure(number.value, value).width;
        place(width);
        overlay.text(x, y, number.label, name);
        overlay.text(x + before, y, number.value, value);
        x += width + unit * 3 / 2;
    }
    return y + unit * 5 / 4;
}

/// A color of the icicle, its meaning, and the number of tests with this outcome.
struct Key {
    std::string label;
    Rgba8 color;
    std::uint64_t count = 0;
};

std::vector<Key> keys_of(const TraceHeader& header, const std::vector<EndingGroup>& groups,
                         const Outcomes& outcomes, const Theme& theme) {
    EndingCounts counts{};
    std::uint64_t divided = 0;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        if (is_ending(outcomes[i]))
            ++counts[static_cast<std::size_t>(outcomes[i])];
        else
            ++divided;
    }
    std::vector<Key> keys = {{"divided", divided_color(theme), divided}};
    for (const EndingGroup& group : groups) {
        const std::uint64_t count = count_of(group, counts);
        // A query without an early end leaves nothing over to explain.
        if (group.endings.front() == Stage::left_over && count == 0) continue;
        keys.push_back({ending_words(group, header.kind), group.color, count});
    }
    return keys;
}

/// The tests of a query of distances by bound and depth, and the meaning of their colors.
struct BoundTests {
    BoundsPlot plot;
    std::vector<Key> keys;  ///< by group of the plot
};

BoundTests bound_tests(const TraceHeader& header, const QueryTrace& frame,
                       const DistanceSteps& steps, const Outcomes& outcomes,
                       const std::vector<EndingGroup>& groups, const Theme& theme) {
    BoundTests result;
    const bool is_limit = header.kind == QueryKind::within || !frame.nearest;
    const std::string answer = is_limit ? "limit" : "distance";
    result.keys = {{"divided, and led to the answer", theme.text},
                   {"divided in vain, bound below the " + answer, body_b_color},
                   {"divided in vain, before it was known", mix(body_b_color, theme.text, 0.6)}};
    for (const EndingGroup& group : groups) {
        const bool is_left_out = is_rejection(group.endings.front());
        result.keys.push_back(
            {(is_left_out ? "left out: " : "") + ending_words(group, header.kind), group.color});
    }
    std::vector<std::size_t> key_of(outcomes.size());
    for (std::size_t i = 0; i < outcomes.size(); ++i)
        for (std::size_t group = 0; group < groups.size(); ++group)
            if (std::find(groups[group].endings.begin(), groups[group].endings.end(),
                          outcomes[i]) != groups[group].endings.end())
                key_of[i] = 3 + group;
    const Attribution verdicts = attribute(header, frame, tested_pairs(steps, frame, outcomes));
    for (const PassedPair& pair : verdicts.passed)
        if (is_divided(outcomes[pair.test]))
            key_of[pair.test] = pair.reason == PassReason::triangles_meet ? 0
                                : pair.reason == PassReason::early        ? 2
                                                                          : 1;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        ++result.keys[key_of[i]].count;
        const Step& step = frame.steps.volumes[i];
        result.plot.tests.push_back({std::uint32_t{step.depth_a} + step.depth_b, steps.bounds[i],
                                     static_cast<std::uint8_t>(key_of[i])});
    }
    for (const Key& key : result.keys) result.plot.colors.push_back(key.color);
    result.plot.answer = steps.answer;
    result.plot.answer_label =
        (header.kind == QueryKind::within ? "at most" : answer) + " " + distance_text(steps.answer);
    return result;
}

/// The legend of outcomes, in as many columns as fit.
class Legend {
  public:
    Legend(Overlay& overlay, std::vector<Key> keys, std::uint64_t all, int width,
           const FigureStyle& style)
        : overlay_(overlay), keys_(std::move(keys)), all_(all), style_(style) {
        for (const Key& key : keys_) {
            label_ = std::max(label_, overlay.measure(key.label, left()).width);
            count_ = std::max(count_, overlay.measure(count_text(key.count), right()).width);
        }
        share_ = overlay.measure("100.0 %", right()).width;
        const int gap = 2 * style.unit;
        const int each = indent() + label_ + count_ + share_ + 2 * space();
        columns_ = std::clamp((width + gap) / (each + gap), 1, static_cast<int>(keys_.size()));
        const auto count = static_cast<int>(keys_.size());
        rows_ = (count + columns_ - 1) / columns_;
        columns_ = (count + rows_ - 1) / rows_;
        pitch_ = std::min(each + 2 * gap, (width + gap) / columns_);
        label_ = std::min(label_, std::max(0, width - each + label_));
    }

    int height() const { return rows_ * line(); }

    void draw(int x, int y) const {
        for (std::size_t i = 0; i < keys_.size(); ++i) {
            const Key& key = keys_[i];
            const auto place = static_cast<int>(i);
            const int at = x + place / rows_ * pitch_, top = y + place % rows_ * line();
            const int unit = style_.unit;
            overlay_.rectangle({at, top + unit / 10, unit * 4 / 5, unit * 4 / 5}, key.color);
            overlay_.text(at + indent(), top, fitted_text(overlay_, key.label, left(), label_),
                          left());
            const int end = at + indent() + label_ + space() + count_;
            overlay_.text(end, top, count_text(key.count), right());
            TextStyle faint = right();
            faint.color = style_.theme.faint_text;
            overlay_.text(end + space() + share_, top, share_text(key.count, all_), faint);
        }
    }

  private:
    int line() const { return style_.unit * 5 / 4; }
    int indent() const { return style_.unit * 5 / 4; }
    int space() const { return style_.unit * 3 / 4; }
    TextStyle left() const { return {style_.unit, FontWeight::regular, style_.theme.text}; }
    TextStyle right() const {
        return {style_.unit, FontWeight::regular, style_.theme.text, Align::right};
    }

    Overlay& overlay_;
    std::vector<Key> keys_;
    std::uint64_t all_;
    FigureStyle style_;
    int label_ = 0, count_ = 0, share_ = 0;  ///< widths
    int columns_ = 1, rows_ = 1, pitch_ = 0;
};

/// The caption above a plot.
struct Caption {
    std::string title, note;
};

int caption_height(Overlay& overlay, const Caption& caption, int width, const FigureStyle& style) {
    const int small = small_size(style.unit);
    const TextStyle note{small, FontWeight::regular, style.theme.faint_text};
    const auto lines = static_cast<int>(wrapped_text(overlay, caption.note, note, width).size());
    return style.unit * 5 / 4 + lines * small * 5 / 4 + style.unit / 4;
}

std::string body_text(const std::string& side, const std::string& name) {
    return name == side ? side : side + " (" + name + ")";
}

/// The rest below a caption of this height.
PixelRect below(const PixelRect& rect, int height) {
    return {rect.x, rect.y + height, rect.width, std::max(1, rect.height - height)};
}

void draw_caption(Overlay& overlay, const PixelRect& rect, const Caption& caption,
                  const FigureStyle& style) {
    const TextStyle bold{style.unit, FontWeight::bold, style.theme.text};
    overlay.text(rect.x, rect.y, fitted_text(overlay, caption.title, bold, rect.width), bold);
    const int small = small_size(style.unit);
    const TextStyle note{small, FontWeight::regular, style.theme.faint_text};
    int y = rect.y + style.unit * 5 / 4;
    for (const std::string& line : wrapped_text(overlay, caption.note, note, rect.width)) {
        overlay.text(rect.x, y, line, note);
        y += small * 5 / 4;
    }
}

std::string icicle_note(bool numbers, bool stacks) {
    return std::string("rows: depth of A + B") + (numbers ? "; numbers: tests" : "") +
           (stacks ? "; narrow tests: their shares, stacked" : "");
}

/// The plot of bounds, and below it its legend if there is room.
void draw_bounds(Overlay& overlay, const PixelRect& rect, const BoundTests& tests,
                 std::uint64_t n_v, const FigureStyle& style) {
    PixelRect plot = rect;
    const Legend legend(overlay, tests.keys, n_v, rect.width, style);
    const Caption caption = {
        "Bound of each test by depth",
        "bars: tests of a depth with nearly this bound; length: the square root of their number, "
        "at most a column. In vain: no triangles below are as near as the answer"};
    const int above = caption_height(overlay, caption, rect.width, style),
              below_plot = legend.height() + style.unit / 2;
    if (rect.height - above - below_plot >= least_body * style.unit) {
        draw_caption(overlay, rect, caption, style);
        plot = below(rect, above);
        plot.height -= below_plot;
        legend.draw(rect.x, plot.y + plot.height + style.unit / 2);
    }
    draw_bounds_plot(overlay, plot, tests.plot, style);
}

}  // namespace

Picture compose(const TraversalFigure& figure, const TraceHeader& header, const QueryTrace& frame,
                int width, int height, Overlay& overlay) {
    const Theme& theme = *figure.theme;
    const FigureLayout layout = figure_layout(width, height);
    const FigureStyle style{theme, layout.unit};
    const int unit = layout.unit, margin = layout.heading.x, inside = width - 2 * margin;
    const Outcomes outcomes = outcomes_of(header, frame);
    const DepthMatrix matrix = depth_matrix(frame.steps);
    const std::vector<EndingGroup> groups = ending_groups(header, theme);

    overlay.begin();
    draw_heading(overlay, layout, theme, figure.title, figure.subtitle);
    int top = layout.heading.y + layout.heading.height;
    top = draw_numbers(overlay, {margin, top, inside, unit}, numbers_of(header, frame, matrix),
                       remark_of(header, frame.found, figure.part), style) +
          unit / 2;
    int bottom = height - margin;
    if (figure.bounds != nullptr) {
        const BoundTests tests =
            bound_tests(header, frame, *figure.bounds, outcomes, groups, theme);
        draw_bounds(overlay, {margin, top, inside, bottom - top}, tests, frame.found.n_v, style);
        return Picture{width, height, 1, theme.background, {}};
    }
    if (figure.icicle) {
        const Legend legend(overlay, keys_of(header, groups, outcomes, theme), frame.found.n_v,
                            inside, style);
        // In a tiny picture the plots come first.
        if (bottom - legend.height() - top >= least_body * unit) {
            bottom -= legend.height();
            legend.draw(margin, bottom);
            bottom -= unit / 2;
        }
    }

    const BodyNames names = body_names(header);
    Caption matrix_caption = {figure.measure == MatrixMeasure::tests ? "Volume tests by depth"
                                                                     : "Share rejected by depth",
                              "across: depth of " + body_text("A", names[0]) + "; down: of " +
                                  body_text("B", names[1]) +
                                  (figure.measure == MatrixMeasure::share ? "; numbers in %" : "")};
    Caption icicle_caption = {"Recursion: width is tests below, color is outcome",
                              icicle_note(true, true)};
    const bool notes = bottom - top >= least_body * unit;
    if (!notes) matrix_caption.note = icicle_caption.note = "";
    PixelRect left{margin, top, inside, bottom - top}, right = left;
    const bool both = figure.matrix && figure.icicle;
    const bool stacked = layout.portrait;
    if (both && stacked) {
        left.height = (left.height - unit) / 2;
        right.y += left.height + unit;
        right.height -= left.height + unit;
    } else if (both) {
        left.width = std::min(inside * 2 / 5, left.height);
        right.x += left.width + 2 * unit;
        right.width -= left.width + 2 * unit;
    }
    int of_matrix = caption_height(overlay, matrix_caption, left.width, style);
    int of_icicle = caption_height(overlay, icicle_caption, right.width, style);
    // Side by side, the roots of both are at one height.
    if (both && !stacked) of_matrix = of_icicle = std::max(of_matrix, of_icicle);
    if (figure.matrix) {
        draw_caption(overlay, left, matrix_caption, style);
        draw_depth_matrix(overlay, below(left, of_matrix), matrix, figure.measure, style);
    }
    if (figure.icicle) {
        const DrawnIcicle drawn =
            draw_icicle(overlay, below(right, of_icicle), frame.steps, outcomes, groups, style);
        if (notes) icicle_caption.note = icicle_note(drawn.numbers, drawn.stacks);
        draw_caption(overlay, right, icicle_caption, style);
    }
    return Picture{width, height, 1, theme.background, {}};
}

}  // namespace scb::render
