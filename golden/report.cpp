#include "golden/report.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <kainjow/mustache.hpp>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "golden/base64.h"
#include "render/embedded.h"
#include "render/image_file.h"

SCB_DECLARE_EMBEDDED(report_html)
SCB_DECLARE_EMBEDDED(report_css)
SCB_DECLARE_EMBEDDED(report_js)

namespace scb {
namespace {

namespace fs = std::filesystem;
using kainjow::mustache::data;
using kainjow::mustache::mustache;

/// Rows that a table shows at once; the rest is folded away.
constexpr std::size_t shown_rows = 24;
/// More rows make a page that nobody reads; results.json has them.
constexpr std::size_t most_rows = 1000;

constexpr std::array verdicts = {
    Verdict::different,     Verdict::size_differs, Verdict::missing_baseline, Verdict::new_output,
    Verdict::could_not_run, Verdict::same,         Verdict::skipped,
};

/// In templates a key that is absent is looked up further out, so every flag is always set.
data flag(bool value) { return data(value ? data::type::bool_true : data::type::bool_false); }

/// "20,480"
std::string grouped(std::uint64_t n) {
    std::string text = std::to_string(n);
    for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
    return text;
}

std::uint64_t magnitude(std::int64_t n) {
    const auto bits = static_cast<std::uint64_t>(n);
    return n < 0 ? 0 - bits : bits;
}

std::string signed_text(bool negative, std::uint64_t size) {
    return (negative ? "−" : "") + grouped(size);
}

/// "+12", "−3"; of any two numbers, for unsigned differences do not overflow.
std::string change_of(std::int64_t before, std::int64_t after) {
    const auto a = static_cast<std::uint64_t>(before), b = static_cast<std::uint64_t>(after);
    return after < before ? signed_text(true, a - b) : "+" + grouped(b - a);
}

std::string counted(std::uint64_t n, const char* one, const char* many) {
    return grouped(n) + " " + (n == 1 ? one : many);
}

std::string percent(double part, double whole) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", whole > 0 ? 100 * part / whole : 0);
    return text.data();
}

/// For ids of elements and the links to them.
std::string anchor_of(const std::string& name, std::set<std::string>& taken) {
    std::string anchor = "case-";
    for (const char c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
        anchor += plain ? c : '_';
    }
    const std::string first = anchor;
    for (int i = 2; !taken.insert(anchor).second; ++i) anchor = first + "~" + std::to_string(i);
    return anchor;
}

std::string shell_quoted(const std::string& text) {
    const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("-_./,:=+@%").find(c) != std::string_view::npos;
    });
    if (plain) return text;
    std::string quoted = "'";
    for (const char c : text) {
        if (c == '\'')
            quoted += "'\\''";
        else
            quoted += c;
    }
    return quoted + "'";
}

struct Png {
    std::vector<std::uint8_t> bytes;
    int width = 0, height = 0;
};

/// The bytes of a PNG file, or nothing where it is none.
std::optional<Png> png_file(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    Png png;
    png.bytes.assign(std::istreambuf_iterator<char>(file), {});
    constexpr std::string_view start("\x89PNG\r\n\x1a\n", 8);
    // The size stands in the first chunk, which has a fixed place.
    if (png.bytes.size() < 24 ||
        !std::equal(start.begin(), start.end(), png.bytes.begin(),
                    [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; }))
        return std::nullopt;
    const auto number = [&](std::size_t at) {
        std::uint32_t n = 0;
        for (std::size_t i = at; i < at + 4; ++i) n = n << 8 | png.bytes[i];
        return static_cast<int>(std::min<std::uint32_t>(n, 1u << 20));
    };
    png.width = number(16);
    png.height = number(20);
    if (png.width == 0 || png.height == 0) return std::nullopt;
    return png;
}

/// A color that is the thing's own: neighbors in number are far apart in hue.
Rgba8 color_of(std::uint32_t id) {
    if (id == 0) return {0, 0, 0, 0};
    std::uint32_t h = id * 0x9e3779b1u;
    h ^= h >> 15;
    h *= 0x85ebca77u;
    h ^= h >> 13;
    const auto channel = [&](int shift) {
        return static_cast<std::uint8_t>(60 + ((h >> shift) & 0xff) * 165 / 255);
    };
    return {channel(0), channel(8), channel(16), 255};
}

/// An id picture as people can see it: its own alpha is a byte of the id, mostly 0.
Png shown_ids(const IdImage& ids) {
    Image image{ids.width, ids.height, std::vector<std::uint8_t>(4 * ids.ids.size())};
    for (int y = 0; y < ids.height; ++y)
        for (int x = 0; x < ids.width; ++x) set_pixel(image, x, y, color_of(pixel(ids, x, y)));
    return {encode_png(image), ids.width, ids.height};
}

/// The pixels whose owner differs, on a pale picture of the new owners.
Png shown_id_difference(const IdImage& before, const IdImage& after) {
    Image image{after.width, after.height, std::vector<std::uint8_t>(4 * after.ids.size())};
    for (int y = 0; y < after.height; ++y)
        for (int x = 0; x < after.width; ++x) {
            const std::uint32_t id = pixel(after, x, y);
            const auto pale = static_cast<std::uint8_t>(id == 0 ? 250 : 205 + color_of(id).g / 8);
            set_pixel(image, x, y,
                      id == pixel(before, x, y) ? Rgba8{pale, pale, pale} : Rgba8{213, 0, 70});
        }
    return {encode_png(image), after.width, after.height};
}

struct Pane {
    const char* kind;   ///< also of the styles and the script
    const char* title;  ///< what people read
    std::string path;   ///< empty: there is none
    std::optional<Png> png;
};

std::vector<Pane> panes_of(const ResultPictures& pictures, const fs::path& folder, bool ids) {
    std::vector<Pane> panes{{"baseline", "baseline", pictures.baseline, {}},
                            {"candidate", "new", pictures.candidate, {}},
                            {"difference", "difference", pictures.difference, {}}};
    for (Pane& pane : panes)
        if (!pane.path.empty()) pane.png = png_file(folder / pane.path);
    if (!ids) return panes;
    std::array<std::optional<IdImage>, 2> owners;
    for (std::size_t i = 0; i < 2; ++i) {
        if (!panes[i].png) continue;
        try {
            owners[i] = unpack_ids(read_png(folder / panes[i].path));
            panes[i].png = shown_ids(*owners[i]);
        } catch (const InputError&) {
            panes[i].png.reset();
        }
    }
    if (panes[2].path.empty() && owners[0] && owners[1] && owners[0]->width == owners[1]->width &&
        owners[0]->height == owners[1]->height)
        panes[2].png = shown_id_difference(*owners[0], *owners[1]);
    return panes;
}

std::string box_numbers(const PixelBox& box) {
    if (box.empty()) return "";
    return std::to_string(box.left) + " " + std::to_string(box.top) + " " +
           std::to_string(box.right) + " " + std::to_string(box.bottom);
}

std::string box_words(const PixelBox& box) {
    if (box.empty()) return "";
    if (box.right == box.left + 1 && box.bottom == box.top + 1)
        return "at (" + std::to_string(box.left) + ", " + std::to_string(box.top) + ")";
    return "from (" + std::to_string(box.left) + ", " + std::to_string(box.top) + ") to (" +
           std::to_string(box.right - 1) + ", " + std::to_string(box.bottom - 1) + ")";
}

struct PictureSet {
    const char* id;     ///< also of the styles and the script
    const char* title;  ///< of the button that shows it
    const ResultPictures& pictures;
    PixelBox box;
};

/// Appends a picture in its versions, if there is any.
void append_pictures(data& sets, const PictureSet& set, const CaseResult& result,
                     const fs::path& folder) {
    const bool ids = std::string_view(set.id) == "ids";
    const std::vector<Pane> panes = panes_of(set.pictures, folder, ids);
    int width = 0, height = 0;
    for (const Pane& pane : panes)
        if (pane.png) {
            width = std::max(width, pane.png->width);
            height = std::max(height, pane.png->height);
        }
    data figures(data::type::list);
    bool any = false;
    for (const Pane& pane : panes) {
        if (pane.path.empty() && !pane.png) continue;
        any = true;
        data figure;
        figure["kind"] = pane.kind;
        figure["pane"] = pane.title;
        figure["has_image"] = flag(pane.png.has_value());
        figure["path"] = pane.path;
        figure["alt"] =
            std::string(ids ? "who owns each pixel of " : "") + result.name + ", " + pane.title;
        // Every version is drawn at one scale, also where the sizes differ.
        if (pane.png) {
            figure["url"] = "data:image/png;base64," + base64(pane.png->bytes);
            figure["width"] = std::to_string(pane.png->width);
            figure["height"] = std::to_string(pane.png->height);
            figure["size"] =
                std::to_string(pane.png->width) + " × " + std::to_string(pane.png->height);
            figure["share"] = percent(pane.png->width, width);
        }
        figures << figure;
    }
    if (!any) return;
    data entry;
    entry["set"] = set.id;
    entry["set_title"] = set.title;
    entry["set_note"] =
        ids ? "Each thing has a color of its own; these are not the picture's colors." : "";
    entry["has_set_note"] = flag(ids);
    entry["set_width"] = std::to_string(std::max(width, 1));
    entry["set_height"] = std::to_string(std::max(height, 1));
    entry["comparable"] = flag(panes[0].png && panes[1].png);
    entry["box"] = box_numbers(set.box);
    entry["has_box"] = flag(!set.box.empty() && width > 0);
    entry["box_left"] = percent(set.box.left, width);
    entry["box_top"] = percent(set.box.top, height);
    entry["box_width"] = percent(set.box.right - set.box.left, width);
    entry["box_height"] = percent(set.box.bottom - set.box.top, height);
    entry["first"] = flag(sets.is_empty_list());
    entry.set("figures", figures);
    sets << entry;
}

/// Rows to show and rows to fold away, as `NAME` and `NAME_more`.
template <class Row, class Fill>
void set_rows(data& values, const std::string& name, const std::vector<Row>& rows, Fill fill) {
    data shown(data::type::list), more(data::type::list);
    // A fold that hides two rows is in the way.
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
        return n ? signed_text(*n < 0, magnitude(*n)) : !text.empty() ? text : std::string("–");
    };
    const bool was = change.before || !change.before_text.empty(),
               is = change.after || !change.after_text.empty();
    // Long places may break behind a slash.
    data parts(data::type::list);
    for (std::size_t at = 0; at <= change.place.size();) {
        const std::size_t end = std::min(change.place.find('/', at), change.place.size());
        data part;
        part["part"] = change.place.substr(at, end + 1 - at);
        parts << part;
        at = end + 1;
    }
    row.set("parts", parts);
    row["before"] = value(change.before, change.before_text);
    row["after"] = value(change.after, change.after_text);
    row["change"] = change.before && change.after ? change_of(*change.before, *change.after)
                    : was && is                   ? std::string("changed")
                    : is                          ? std::string("new")
                                                  : std::string("gone");
}

void fill_id(const IdChange& change, data& row) {
    row["id"] = std::to_string(change.id);
    row["before"] = grouped(change.before);
    row["after"] = grouped(change.after);
    row["change"] = change.before == 0  ? std::string("appeared")
                    : change.after == 0 ? std::string("vanished")
                                        : change_of(static_cast<std::int64_t>(change.before),
                                                    static_cast<std::int64_t>(change.after));
    row["moved"] = grouped(change.moved);
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
                 row["pixels"] = grouped(step.second);
                 row["width"] = percent(static_cast<double>(step.second),
                                        static_cast<double>(colors.beyond[0]));
             });
}

std::string hex_color(Rgba8 color) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), color.a == 255 ? "#%02x%02x%02x" : "#%02x%02x%02x%02x",
                  color.r, color.g, color.b, color.a);
    return text.data();
}

struct PixelChange {
    int x = 0, y = 0;
    Rgba8 before, after;

    std::array<int, 4> by() const {
        return {after.r - before.r, after.g - before.g, after.b - before.b, after.a - before.a};
    }
    int most() const {
        int largest = 0;
        for (const int d : by()) largest = std::max(largest, std::abs(d));
        return largest;
    }
};

/// The pixels that differ most, ties from the top; none where a picture cannot be read.
std::vector<PixelChange> worst_pixels(const CaseResult& result, const fs::path& folder) {
    constexpr std::size_t listed = 6;
    const ResultPictures& picture = result.picture;
    if (!result.colors || picture.baseline.empty() || picture.candidate.empty()) return {};
    Image before, after;
    try {
        before = read_png(folder / picture.baseline);
        after = read_png(folder / picture.candidate);
    } catch (const InputError&) {
        return {};
    }
    if (before.width != after.width || before.height != after.height) return {};
    std::vector<PixelChange> worst;
    for (int y = 0; y < after.height; ++y)
        for (int x = 0; x < after.width; ++x) {
            const PixelChange change{x, y, pixel(before, x, y), pixel(after, x, y)};
            const int most = change.most();
            if (most == 0 || (worst.size() == listed && most <= worst.back().most())) continue;
            const auto at = std::find_if(worst.begin(), worst.end(), [&](const PixelChange& other) {
                return other.most() < most;
            });
            worst.insert(at, change);
            if (worst.size() > listed) worst.pop_back();
        }
    return worst;
}

void set_worst_pixels(data& values, const std::vector<PixelChange>& worst) {
    data rows(data::type::list);
    for (const PixelChange& change : worst) {
        std::string by;
        const std::array<int, 4> channels = change.by();
        for (std::size_t i = 0; i < (channels[3] == 0 ? 3u : 4u); ++i) {
            const int d = channels[i];
            by += (i == 0 ? "" : ", ") + std::string(d > 0 ? "+" : "") +
                  signed_text(d < 0, magnitude(d));
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

/// The update command without the name, for the page to put several names behind it.
std::string update_prefix(const CaseResult& result) {
    for (const std::string& name : {shell_quoted(result.name), result.name})
        if (!name.empty() && result.update.size() > name.size() &&
            result.update.ends_with(" " + name))
            return result.update.substr(0, result.update.size() - name.size() - 1);
    return "scb golden update";
}

std::string seconds_text(double seconds) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), seconds < 10 ? "%.2f s" : "%.0f s", seconds);
    return text.data();
}

void set_commands(data& values, const CaseResult& result) {
    data commands(data::type::list);
    const auto add = [&](const char* title, const std::string& text) {
        if (text.empty()) return;
        data command;
        command["title"] = title;
        command["text"] = text;
        commands << command;
    };
    add("Reproduce", result.reproduce);
    if (result.traces.size() == 2)
        add("Find the first pair test that differs",
            "scb diff " + shell_quoted(result.traces[0]) + " " + shell_quoted(result.traces[1]));
    else
        for (const std::string& trace : result.traces) add("Trace", trace);
    add("Update, if the change is right", result.update);
    values["has_commands"] = flag(!commands.is_empty_list());
    values.set("commands", commands);
}

data failure_of(const CaseResult& result, const fs::path& folder, std::set<std::string>& anchors) {
    data values;
    values["name"] = result.name;
    values["anchor"] = anchor_of(result.name, anchors);
    values["verdict"] = std::string(verdict_name(result.verdict));
    values["message"] = result.message;
    values["has_message"] = flag(!result.message.empty());
    values["seconds"] = seconds_text(result.seconds);
    values["variant"] = std::to_string(result.variant);
    values["has_variant"] = flag(result.variant > 1);
    data lines(data::type::list);
    for (const std::string& line : result.lines) {
        data entry;
        entry["line"] = line;
        lines << entry;
    }
    values["has_lines"] = flag(!result.lines.empty());
    values.set("lines", lines);

    data sets(data::type::list);
    append_pictures(
        sets,
        {"colors", "picture", result.picture, result.colors ? result.colors->box : PixelBox{}},
        result, folder);
    append_pictures(sets,
                    {"ids", "ids", result.id_picture, result.ids ? result.ids->box : PixelBox{}},
                    result, folder);
    values["has_pictures"] = flag(!sets.is_empty_list());
    values["two_sets"] = flag(sets.list_value().size() > 1);
    values.set("sets", sets);

    set_rows(values, "counts", result.counts, fill_count);
    values["counts_words"] = counted(result.counts.size(), "count differs", "counts differ");
    const IdDifference no_ids, &ids = result.ids ? *result.ids : no_ids;
    set_rows(values, "ids", ids.changes, fill_id);
    values["ids_words"] = counted(ids.pixels, "pixel has", "pixels have") + " another owner" +
                          (ids.box.empty() ? "" : ", " + box_words(ids.box));
    set_colors(values, result);
    set_worst_pixels(values, worst_pixels(result, folder));
    set_commands(values, result);
    values["can_update"] = flag(!result.update.empty());
    values["update_prefix"] = update_prefix(result);
    values["update_name"] = shell_quoted(result.name);
    return values;
}

/// Cases that need one line only: passed or skipped.
data brief_of(const CaseResult& result) {
    data values;
    values["name"] = result.name;
    values["message"] = result.message;
    values["has_message"] =
        flag(result.verdict == Verdict::skipped ? !result.message.empty() : false);
    values["variant"] = std::to_string(result.variant);
    values["has_variant"] = flag(result.variant > 1);
    return values;
}

void set_header(data& values, const SuiteResult& result, std::size_t failures) {
    const std::size_t all = result.cases.size();
    values["failed"] = flag(failures > 0);
    if (all == 0)
        values["headline"] = "No cases were run";
    else if (failures > 0)
        values["headline"] = grouped(failures) + " of " + counted(all, "case", "cases") + " failed";
    else
        values["headline"] = counted(all, "case", "cases") + ", none failed";
    values["suite"] = result.suite;
    values["shard"] = result.shard;
    values["has_shard"] = flag(!result.shard.empty());
    data chips(data::type::list);
    for (const Verdict verdict : verdicts) {
        const auto n = std::count_if(result.cases.begin(), result.cases.end(),
                                     [&](const CaseResult& c) { return c.verdict == verdict; });
        if (n == 0) continue;
        data chip;
        chip["verdict"] = std::string(verdict_name(verdict));
        chip["n"] = grouped(static_cast<std::uint64_t>(n));
        chips << chip;
    }
    values.set("chips", chips);
    data environment(data::type::list);
    for (const auto& [name, value] : result.environment) {
        data entry;
        entry["name"] = name;
        entry["value"] = value;
        environment << entry;
    }
    values["has_environment"] = flag(!result.environment.empty());
    values.set("environment", environment);
}

}  // namespace

std::string report_html(const SuiteResult& result, const fs::path& folder) {
    data failures(data::type::list), passed(data::type::list), skipped(data::type::list);
    std::set<std::string> anchors;
    std::size_t failed = 0, same = 0, left_out = 0;
    for (const Verdict verdict : verdicts)
        for (const CaseResult& c : result.cases) {
            if (c.verdict != verdict) continue;
            if (is_failure(verdict)) {
                failures << failure_of(c, folder, anchors);
                ++failed;
            } else if (verdict == Verdict::skipped) {
                skipped << brief_of(c);
                ++left_out;
            } else {
                passed << brief_of(c);
                ++same;
            }
        }
    data values;
    values["style"] = std::string(SCB_EMBEDDED(report_css));
    values["script"] = std::string(SCB_EMBEDDED(report_js));
    set_header(values, result, failed);
    values["has_failures"] = flag(failed > 0);
    values["many_failures"] = flag(failed > 1);
    values.set("failures", failures);
    values["has_passed"] = flag(same > 0);
    values["passed_words"] = counted(same, "case is", "cases are") + " the same";
    values.set("passed", passed);
    values["has_skipped"] = flag(left_out > 0);
    values["skipped_words"] = counted(left_out, "case was", "cases were") + " skipped";
    values.set("skipped", skipped);
    mustache html{std::string(SCB_EMBEDDED(report_html))};
    assert(html.is_valid() && "the template is part of the program");
    return html.render(values);
}

}  // namespace scb
