#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/text_format.h"
#include "golden/compare/image_difference.h"
#include "golden/compare/number_words.h"
#include "golden/report/report_values.h"
#include "render/files/image_file.h"
#include "scb/error.h"

namespace scb::golden::report {
namespace {

namespace fs = std::filesystem;
using kainjow::mustache::data;
using words::box_words;
using words::change_of;
using words::grouped_signed;

/// Rows that a table shows at once; the rest is folded away.
constexpr std::size_t shown_rows = 24;
/// A page with more rows would be too long to read; results.json has all.
constexpr std::size_t most_rows = 1000;
constexpr std::size_t shown_pixels = 6;

/// Rows to show and rows to fold away, as `NAME` and `NAME_more`.
template <class Row, class Fill>
void set_rows(data& values, const std::string& name, const std::vector<Row>& rows, Fill fill) {
    data shown(data::type::list), more(data::type::list);
    // A fold that hides only a few rows is not useful.
    const std::size_t split = rows.size() <= shown_rows + 4 ? rows.size() : shown_rows;
    for (std::size_t i = 0; i < rows.size() && i < most_rows; ++i) {
        data row;
        fill(rows[i], row);
        (i < split ? shown : more) << row;
    }
    values["has_" + name] = flag(!rows.empty());
    values.set(name, shown);
    values["has_" + name + "_more"] = flag(rows.size() > split);
    values[name + "_more_words"] =
        counted(std::min(rows.size(), most_rows) - split, "more row", "more rows");
    values.set(name + "_more", more);
    values["has_" + name + "_rest"] = flag(rows.size() > most_rows);
    values[name + "_rest"] =
        rows.size() > most_rows
            ? counted(rows.size() - most_rows, "more is", "more are") + " in results.json."
            : "";
}

void fill_count(const CountChange& change, data& row) {
    const auto value = [](const std::optional<std::int64_t>& n, const std::string& text) {
        return n ? grouped_signed(*n) : !text.empty() ? text : std::string("–");
    };
    const bool was = change.before || !change.before_text.empty(),
               is = change.after || !change.after_text.empty();
    // Long places may break after a slash.
    data parts(data::type::list);
    for (std::size_t at = 0; at <= change.place.size();) {
        const std::size_t end = std::min(change.place.find('/', at), change.place.size());
        data part;
        part["part"] = change.place.substr(at, end + 1 - at);
        parts << part;
        at = end + 1;
    }
    row.set("parts", parts);
    const bool hash = is_hash(change);
    row["before"] = hash ? std::string() : value(change.before, change.before_text);
    row["after"] = hash ? std::string() : value(change.after, change.after_text);
    row["change"] = change.before && change.after && !hash
                        ? change_of(*change.before, *change.after)
                    : was && is ? std::string("changed")
                    : is        ? std::string("new")
                                : std::string("gone");
}

void fill_id(const IdChange& change, const std::string& owner, data& row) {
    row["id"] = std::to_string(change.id);
    row["owner"] = owner;
    row["before"] = count_text(change.before);
    row["after"] = count_text(change.after);
    row["change"] = change.before == 0  ? std::string("appeared")
                    : change.after == 0 ? std::string("vanished")
                                        : change_of(static_cast<std::int64_t>(change.before),
                                                    static_cast<std::int64_t>(change.after));
    row["moved"] = count_text(change.moved);
    row["box"] = box_numbers(change.box);
    row["where"] = box_words(change.box);
}

/// Where the number of pixels beyond a channel difference changes: [d, pixels], up to the first d
/// with none.
std::vector<std::pair<int, std::size_t>> sweep_of(const ImageDifference& difference) {
    std::vector<std::pair<int, std::size_t>> steps;
    for (std::size_t d = 0; d < difference.beyond.size(); ++d)
        if (d == 0 || difference.beyond[d] != difference.beyond[d - 1])
            steps.emplace_back(static_cast<int>(d), difference.beyond[d]);
    return steps;
}

void set_colors(data& values, const CaseResult& result) {
    values["has_colors"] = flag(result.colors.has_value());
    const ImageDifference none, &colors = result.colors ? *result.colors : none;
    const ColorTolerance& allowed = result.tolerance;
    std::string words = counted(colors.pixels, "pixel differs", "pixels differ") +
                        (colors.box.empty() ? "" : ", " + box_words(colors.box)) + ", by up to " +
                        std::to_string(colors.largest) + " of 255 in a channel. Allowed: ";
    if (allowed.max_channel_delta == 0 && allowed.max_pixels == 0)
        words += "none.";
    else
        words += "up to " + std::to_string(allowed.max_channel_delta) + " in a channel, and " +
                 counted(allowed.max_pixels, "pixel", "pixels") + " beyond.";
    values["colors_words"] = words;
    set_rows(values, "sweep", result.colors ? sweep_of(colors) : sweep_of(none),
             [&](const std::pair<int, std::size_t>& step, data& row) {
                 row["delta"] = std::to_string(step.first);
                 row["pixels"] = count_text(step.second);
                 row["width"] = percent(static_cast<double>(step.second),
                                        static_cast<double>(colors.beyond[0]));
             });
}

/// Counts of the baseline, and counts that only traces have, which are only hints.
void set_counts(data& values, const CaseResult& result) {
    std::vector<CountChange> counts, depths;
    for (const CountChange& change : result.counts)
        (is_of_trace(change) ? depths : counts).push_back(change);
    const bool all_new = std::all_of(counts.begin(), counts.end(), [](const CountChange& change) {
        return !change.before && change.before_text.empty();
    });
    data tables(data::type::list);
    const auto add = [&](const std::vector<CountChange>& rows, const std::string& words) {
        if (rows.empty()) return;
        data table;
        table["words"] = words;
        set_rows(table, "counts", rows, fill_count);
        tables << table;
    };
    add(counts, all_new ? counted(counts.size(), "count is new", "counts are new")
                        : counted(counts.size(), "count differs", "counts differ"));
    add(depths, counted(depths.size(), "count of tests by depth differs in the traces",
                        "counts of tests by depth differ in the traces"));
    values.set("count_tables", tables);
}

std::string hex_color(render::Rgba8 color) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), color.a == 255 ? "#%02x%02x%02x" : "#%02x%02x%02x%02x",
                  color.r, color.g, color.b, color.a);
    return text.data();
}

/// None if a picture cannot be read.
std::vector<PixelChange> worst_pixels_of(const CaseResult& result, const fs::path& folder) {
    const ResultPictures& picture = result.picture;
    if (!result.colors || picture.baseline.empty() || picture.candidate.empty()) return {};
    try {
        const render::Image before = render::read_png(folder / picture.baseline);
        const render::Image after = render::read_png(folder / picture.candidate);
        if (before.width != after.width || before.height != after.height) return {};
        return worst_pixels(before, after, result.focus, shown_pixels);
    } catch (const InputError&) {
        return {};
    }
}

void set_worst_pixels(data& values, const std::vector<PixelChange>& worst) {
    data rows(data::type::list);
    for (const PixelChange& change : worst) {
        std::string by;
        const std::array<int, 4> channels = change.by();
        for (std::size_t i = 0; i < (channels[3] == 0 ? 3u : 4u); ++i) {
            const int d = channels[i];
            by += (i == 0 ? "" : ", ") + std::string(d > 0 ? "+" : "") + grouped_signed(d);
        }
        data row;
        row["at"] = "(" + std::to_string(change.x) + ", " + std::to_string(change.y) + ")";
        row["before"] = hex_color(change.before);
        row["after"] = hex_color(change.after);
        row["change"] = by;
        row["box"] = box_numbers({change.x, change.y, change.x + 1, change.y + 1});
        rows << row;
    }
    values["has_worst"] = flag(!worst.empty());
    values.set("worst", rows);
}

}  // namespace

void set_tables(data& values, const CaseResult& result, const fs::path& folder) {
    set_counts(values, result);
    const IdDifference no_ids, &ids = result.ids ? *result.ids : no_ids;
    set_rows(values, "ids", ids.changes, [&](const IdChange& change, data& row) {
        const auto at = static_cast<std::size_t>(&change - ids.changes.data());
        fill_id(change, at < result.owners.size() ? result.owners[at] : "", row);
    });
    values["ids_words"] = counted(ids.pixels, "pixel has", "pixels have") + " another owner" +
                          (ids.box.empty() ? "" : ", " + box_words(ids.box));
    set_colors(values, result);
    set_worst_pixels(values, worst_pixels_of(result, folder));
}

using kainjow::mustache::data;

data flag(bool value) { return data(value ? data::type::bool_true : data::type::bool_false); }

std::string percent(double part, double whole) {
    return format("%.4g", whole > 0 ? 100 * part / whole : 0);
}

std::string box_numbers(const PixelBox& box) {
    if (box.empty()) return "";
    return std::to_string(box.left) + " " + std::to_string(box.top) + " " +
           std::to_string(box.right) + " " + std::to_string(box.bottom);
}

}  // namespace scb::golden::report
