#include "app/query/expected_pairs.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "app/query/contact_intervals.h"
#include "core/base/text_format.h"
#include "core/geometry/triangle_segment.h"
#include "core/platform/input_files.h"
#include "core/platform/text_lines.h"
#include "core/platform/tokens.h"
#include "scb/error.h"
#include "scb/triangle_distance.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

/// The cells of a line of CSV (RFC 4180). Blanks about a cell are no part of it.
std::vector<std::string> csv_cells(std::string_view line) {
    std::vector<std::string> cells(1);
    bool is_quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool is_doubled = is_quoted && line.substr(i).starts_with("\"\"");
        if (is_doubled) ++i;
        if (line[i] == '"' && !is_doubled)
            is_quoted = !is_quoted;
        else if (line[i] == ',' && !is_quoted)
            cells.emplace_back();
        else if (is_quoted || !Words::is_blank(line[i]) || !cells.back().empty())
            cells.back() += line[i];
    }
    for (std::string& cell : cells)
        while (!cell.empty() && Words::is_blank(cell.back())) cell.pop_back();
    return cells;
}

}  // namespace

/// Reads the rows of the file.
class PairFile::Reader {
  public:
    Reader(const std::string& path, const SceneQuery& query)
        : path_(path), lines_(path), query_(query) {}

    std::vector<Row> read(NotCompared& not_compared) {
        while (const std::optional<std::string_view> line = lines_.next()) {
            const std::vector<std::string> cells = csv_cells(*line);
            if (cells.size() == 1 && cells[0].empty()) continue;
            if (columns_.empty())
                read_header(cells);
            else
                read_row(cells);
        }
        if (columns_.empty()) throw InputError(path_ + ": it has no lines; " + header_words);
        std::sort(rows_.begin(), rows_.end());
        rows_.erase(std::unique(rows_.begin(), rows_.end()), rows_.end());
        not_compared = not_compared_;
        return std::move(rows_);
    }

  private:
    static constexpr const char* header_words =
        "the first line must name the columns frame,triangle_a,triangle_b, or "
        "frame,body_a,body_b,triangle_a,triangle_b, as --pairs-out writes them.";
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    [[noreturn]] void refuse(const std::string& sentence) const {
        throw InputError(lines_.place() + ": " + sentence);
    }

    std::size_t column(const char* name) const {
        const auto at = std::find(columns_.begin(), columns_.end(), name);
        return at == columns_.end() ? none : static_cast<std::size_t>(at - columns_.begin());
    }

    void read_header(const std::vector<std::string>& cells) {
        columns_ = cells;
        frame_ = column("frame");
        triangles_ = {column("triangle_a"), column("triangle_b")};
        bodies_ = {column("body_a"), column("body_b")};
        if (frame_ == none || triangles_[0] == none || triangles_[1] == none ||
            (bodies_[0] == none) != (bodies_[1] == none))
            refuse(header_words);
        for (const char* name : {"frame", "body_a", "body_b", "triangle_a", "triangle_b"})
            if (std::ranges::count(columns_, name) > 1)
                refuse("the column " + std::string(name) +
                       " is there twice; leave one of them out.");
        if (bodies_[0] == none && query_.pairs.size() > 1)
            refuse(sentence("the queries are of ", query_.pairs.size(),
                            " pairs of bodies; add the columns body_a and body_b, or choose two "
                            "bodies with --bodies."));
    }

    void read_row(const std::vector<std::string>& cells) {
        if (cells.size() != columns_.size())
            refuse(sentence("it has ", counted(cells.size(), "cell", "cells"),
                            ", and the first line ", columns_.size(),
                            "; write a pair in each line."));
        Row row;
        const std::uint32_t frame = number(cells, frame_, "frame");
        if (frame >= static_cast<std::uint32_t>(query_.scene.frames))
            refuse(sentence("there is no frame ", frame, "; the scene '", query_.scene.name,
                            "' has the frames 0 to ", query_.scene.frames - 1, "."));
        row.frame = static_cast<int>(frame);
        BodyPair bodies = query_.pairs.front();
        if (bodies_[0] != none) bodies = {body(cells[bodies_[0]]), body(cells[bodies_[1]])};
        row.triangles = {triangle(cells, 0, bodies), triangle(cells, 1, bodies)};
        const std::optional<std::size_t> queried = index_of(bodies, row.triangles);
        if (!std::ranges::binary_search(query_.frames, row.frame)) {
            ++not_compared_.of_frames;
        } else if (!queried) {
            ++not_compared_.of_bodies;
        } else {
            row.bodies = static_cast<std::uint32_t>(*queried);
            rows_.push_back(row);
        }
    }

    /// The index of the pair of bodies, if it is queried. Swaps the triangles into its order.
    std::optional<std::size_t> index_of(const BodyPair& bodies, IndexPair& triangles) const {
        if (bodies[0] == bodies[1] && triangles.a > triangles.b)
            std::swap(triangles.a, triangles.b);
        for (std::size_t i = 0; i < query_.pairs.size(); ++i) {
            if (query_.pairs[i] == bodies) return i;
            if (query_.pairs[i] != BodyPair{bodies[1], bodies[0]}) continue;
            std::swap(triangles.a, triangles.b);
            return i;
        }
        return std::nullopt;
    }

    std::uint32_t number(const std::vector<std::string>& cells, std::size_t at,
                         const char* name) const {
        const std::string& cell = cells[at];
        std::uint32_t value = 0;
        const auto parsed = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        if (parsed.ec != std::errc{} || parsed.ptr != cell.data() + cell.size())
            refuse(std::string(name) + " is '" + excerpt(cell) +
                   "'; give a whole number from 0 on.");
        return value;
    }

    std::uint32_t triangle(const std::vector<std::string>& cells, std::size_t side,
                           const BodyPair& bodies) const {
        const char* const name = side == 0 ? "triangle_a" : "triangle_b";
        const std::uint32_t value = number(cells, triangles_[side], name);
        const std::size_t count = query_.mesh(bodies[side]).triangles.size();
        if (value >= count)
            refuse(sentence(name, " is ", value, ", and ", query_.scene.bodies[bodies[side]].name,
                            " has the triangles 0 to ", count - 1,
                            "; number them in the order of the mesh file",
                            value < query_.mesh(bodies[1 - side]).triangles.size()
                                ? ", and see whether triangle_a and triangle_b are exchanged."
                                : "."));
        return value;
    }

    std::size_t body(const std::string& name) const {
        const std::vector<scenes::Body>& bodies = query_.scene.bodies;
        for (std::size_t i = 0; i < bodies.size(); ++i)
            if (bodies[i].name == name) return i;
        refuse("there is no body '" + excerpt(name) + "'; the scene has " +
               name_list(bodies, &scenes::Body::name) + ".");
    }

    std::string path_;
    TextLines lines_;
    const SceneQuery& query_;
    std::vector<std::string> columns_;  ///< the names in the first line
    std::size_t frame_ = none;
    std::array<std::size_t, 2> triangles_{}, bodies_{};
    std::vector<Row> rows_;
    NotCompared not_compared_;
};

PairFile::PairFile(const std::string& path, const SceneQuery& query) : path_(path) {
    note_input(path);
    rows_ = Reader(path, query).read(not_compared_);
}

std::string PairFile::note() const {
    std::string reasons;
    for (const auto& [count, words] :
         {std::pair(not_compared_.of_frames, " of frames that are not queried"),
          std::pair(not_compared_.of_bodies, " of bodies that are not queried")})
        if (count > 0) reasons += (reasons.empty() ? "" : ", ") + count_text(count) + words;
    if (reasons.empty()) return "";
    return path_ + ": " +
           counted(not_compared_.of_frames + not_compared_.of_bodies, "row is", "rows are") +
           " not compared: " + reasons + ".";
}

std::vector<IndexPair> PairFile::pairs(std::size_t i, int frame) const {
    const std::pair at(static_cast<std::uint32_t>(i), frame);
    const auto place = [](const Row& row) { return std::pair(row.bodies, row.frame); };
    std::vector<IndexPair> pairs;
    std::transform(std::ranges::lower_bound(rows_, at, {}, place),
                   std::ranges::upper_bound(rows_, at, {}, place), std::back_inserter(pairs),
                   [](const Row& row) { return row.triangles; });
    return pairs;
}

PairComparison::Difference PairComparison::add(std::size_t i, int frame,
                                               std::span<const IndexPair> found) {
    const std::vector<IndexPair> expected = file_.pairs(i, frame);
    std::vector<IndexPair> only_found, only_expected;
    std::ranges::set_difference(found, expected, std::back_inserter(only_found));
    std::ranges::set_difference(expected, found, std::back_inserter(only_expected));
    const Mesh &a = query_.mesh(query_.a), &b = query_.mesh(query_.b);
    const Pose b_to_a = query_.b_to_a(frame);
    const auto corners_of = [&](IndexPair pair) {
        return std::array{corners(a, pair.a), transform_corners(b_to_a, corners(b, pair.b))};
    };
    Difference difference{expected.size(), {}, {}};
    for (const IndexPair pair : only_found) {
        const auto [of_a, of_b] = corners_of(pair);
        difference.missing.push_back({pair, triangle_depth(of_a, of_b)});
    }
    for (const IndexPair pair : only_expected) {
        const auto [of_a, of_b] = corners_of(pair);
        const TriangleContact contact = triangle_contact(of_a, of_b);
        difference.not_found.push_back({pair, contact, triangle_distance(of_a, of_b).distance});
    }
    std::ranges::stable_sort(difference.missing, std::greater{}, &Difference::Missing::depth);
    std::ranges::stable_sort(difference.not_found, std::greater{}, &Difference::False::distance);
    // So that one frame with many does not hide the others.
    const std::size_t most = query_.frames.size() > 1 ? most_listed_of_frame : most_listed;
    const auto first_of = [most](const auto& pairs) {
        return std::span(pairs).first(std::min(most, pairs.size()));
    };
    for (const Difference::Missing& pair : first_of(difference.missing))
        list(frame, pair.triangles, format("missing, depth %.6g", pair.depth));
    for (const Difference::False& pair : first_of(difference.not_found))
        list(frame, pair.triangles,
             pair.contact == TriangleContact::apart ? format("false, distance %.6g", pair.distance)
             : pair.contact == TriangleContact::touching
                 ? "left out here, but the triangles touch"
                 : "left out here, but the triangles cross");
    for (const IndexPair pair : only_found)
        exchanged_ += std::ranges::binary_search(expected, IndexPair{pair.b, pair.a});
    FrameCounts& counts = frames_[frame];
    counts.found += found.size();
    counts.missing += difference.missing.size();
    counts.not_found += difference.not_found.size();
    found_ += found.size();
    missing_ += difference.missing.size();
    false_ += difference.not_found.size();
    if (!difference.missing.empty())
        most_depth_ = std::max(most_depth_, difference.missing.front().depth);
    if (!difference.not_found.empty())
        most_distance_ = std::max(most_distance_, difference.not_found.front().distance);
    return difference;
}

void PairComparison::list(int frame, IndexPair triangles, const std::string& words) {
    if (listed_ == most_listed) return;
    ++listed_;
    list_ += format("  frame %d, ", frame);
    if (query_.pairs.size() > 1)
        list_ += query_.scene.bodies[query_.a].name + " and " + query_.scene.bodies[query_.b].name +
                 ", ";
    list_ += format("triangles (%u, %u): ", triangles.a, triangles.b) + words + "\n";
}

std::string PairComparison::frames_where(
    const std::function<bool(const FrameCounts&)>& condition) const {
    ContactIntervals intervals;
    for (const int frame : query_.frames) {
        const auto counts = frames_.find(frame);
        intervals.add(frame, counts != frames_.end() && condition(counts->second));
    }
    return intervals.empty() ? "" : intervals.words();
}

std::string PairComparison::text(std::size_t frames) const {
    const std::string of_frames = counted(frames, "frame", "frames");
    if (agrees())
        return "\nAll " + counted(found_, "pair", "pairs") + " of " + of_frames + " agree with " +
               file_.path() + ".\n";
    std::string text = "\n" + file_.path() + ": " + of_frames + (frames == 1 ? " has " : " have ") +
                       counted(found_, "pair", "pairs") + ". " +
                       counted(missing_, "pair is", "pairs are") + " missing in the file";
    if (missing_ > 0) text += format(", at most %.6g deep", most_depth_);
    text += "; " + counted(false_, "pair is", "pairs are") + " false in the file";
    if (most_distance_ > 0) text += format(", at most %.6g apart", most_distance_);
    text += ".\n";
    if (frames > 1)
        for (const auto& [words, named] :
             {std::pair("All pairs are missing in ", frames_where([](const FrameCounts& of) {
                            return of.missing > 0 && of.missing == of.found;
                        })),
              {"Pairs are missing in ",
               frames_where([](const FrameCounts& of) { return of.missing > 0; })},
              {"Pairs are false in ",
               frames_where([](const FrameCounts& of) { return of.not_found > 0; })}})
            if (!named.empty()) text += words + named + ".\n";
    if (exchanged_ > 0 && exchanged_ * 10 >= missing_ * 9)
        text += counted(exchanged_, "missing pair is", "missing pairs are") +
                " in the file with the two triangles exchanged; see whether its columns "
                "triangle_a and triangle_b are exchanged.\n";
    text += list_;
    const std::size_t rest = missing_ + false_ - listed_;
    if (rest > 0) text += "  and " + count_text(rest) + " more\n";
    return text;
}

Json json_of(const PairComparison::Difference& difference) {
    Json json = {
        {"pairs", difference.expected}, {"missing", Json::array()}, {"false", Json::array()}};
    const auto triangles = [](IndexPair pair) -> Json { return {{"triangles", {pair.a, pair.b}}}; };
    for (const auto& pair : difference.missing) {
        json["missing"].push_back(triangles(pair.triangles));
        json["missing"].back()["depth"] = pair.depth;
    }
    for (const auto& pair : difference.not_found) {
        json["false"].push_back(triangles(pair.triangles));
        if (pair.contact == TriangleContact::apart)
            json["false"].back()["distance"] = pair.distance;
        else
            json["false"].back()["contact"] =
                pair.contact == TriangleContact::touching ? "touching" : "crossing";
    }
    return json;
}

}  // namespace scb::app
