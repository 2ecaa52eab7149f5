#include "app/timing/bench_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/report/trace_report.h"
#include "core/analysis/measure_correlation.h"
#include "core/base/statistics.h"
#include "core/base/text_format.h"
#include "render/overlay/figure_layout.h"
#include "scenes/scene/scene_group.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

/// The first subject with slab cut balls: the reference for speed-ups.
const SubjectBench* first_scb(const SceneBench& bench) {
    for (const SubjectBench& subject : bench.subjects)
        if (subject.subject.kind == VolumeKind::scb) return &subject;
    return nullptr;
}

std::vector<double> doubles(const std::vector<std::uint64_t>& values) {
    return {values.begin(), values.end()};
}

/// Table 3 of the paper for a scene and a hierarchy: means per frame.
struct Table3Entry {
    double ms, n_v, n_p;  ///< on an Intel T2600 at 2.16 GHz
};

struct Table3Row {
    Table3Entry ball, scb, obb;
};

/// In the order of table_3_scenes.
constexpr std::array<Table3Row, std::size(scenes::table_3_scenes)> table_3 = {{
    {{8.0, 99733, 10585}, {3.3, 21412, 2112}, {4.9, 13350, 1135}},
    {{16.4, 200235, 20776}, {6.5, 42295, 4419}, {9.2, 24835, 2240}},
    {{9.7, 68543, 15503}, {1.8, 13005, 63}, {3.0, 8731, 0}},
    {{12.5, 121316, 31703}, {1.7, 14189, 53}, {2.4, 9047, 0}},
    {{18.4, 175479, 49840}, {1.8, 14367, 33}, {2.5, 9365, 0}},
    {{8.6, 93193, 12709}, {5.8, 39469, 4773}, {8.4, 23200, 1748}},
    {{101.4, 1028875, 161923}, {62.1, 387257, 53083}, {83.2, 239346, 17522}},
}};

/// The entry of Table 3; none for other scenes and Ritter's balls, or if frames or pairs are
/// missing. Its OBB figures are RAPID's.
std::optional<Table3Entry> paper_entry(const SceneBench& bench, VolumeKind kind) {
    if (!bench.builtin || !bench.all_frames || bench.first || bench.distance) return std::nullopt;
    for (std::size_t i = 0; i < table_3.size(); ++i) {
        if (scenes::table_3_scenes[i] != bench.scene) continue;
        if (kind == VolumeKind::ball) return table_3[i].ball;
        if (kind == VolumeKind::scb) return table_3[i].scb;
        if (kind == VolumeKind::obb) return table_3[i].obb;
    }
    return std::nullopt;
}

// Table 3's figures, and the time as a multiple of the time of the paper's SCBTree.
std::string paper_cells(const SceneBench& bench, VolumeKind kind) {
    const std::optional<Table3Entry> entry = paper_entry(bench, kind);
    if (!entry) return "";
    const double scb_ms = paper_entry(bench, VolumeKind::scb)->ms;
    return format("  | %8.1f %8.2f %10.0f %9.0f", entry->ms, ratio(entry->ms, scb_ms), entry->n_v,
                  entry->n_p);
}

std::string count_cell(std::size_t width, const std::vector<std::uint64_t>& counts) {
    return " " + right_aligned(render::mean_text(
                                   std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}),
                                   counts.size()),
                               width - 1);
}

/// The share of queries that began at the front of an earlier one.
std::string front_cell(const SubjectBench& subject) {
    return subject.subject.coherent ? format(" %5.1f %%", 100 * subject.from_front) : "       -";
}

/// Whether each query looks for the smallest distance.
bool is_of_smallest(const std::optional<DistanceQuery>& query) { return query && !query->within; }

/// The found distances of all frames; null if there are none.
Json mean_distance(const SubjectBench& subject) {
    double sum = 0;
    std::size_t found = 0;
    for (const double distance : subject.distances)
        if (std::isfinite(distance)) {
            sum += distance;
            ++found;
        }
    return found == 0 ? Json() : Json(sum / static_cast<double>(found));
}

std::string distance_cell(const SubjectBench& subject) {
    const Json distance = mean_distance(subject);
    return distance.is_null() ? "          -" : format(" %10.5g", distance.get<double>());
}

/// "  All found the same distances.", or the names of the subjects that did not. With an allowed
/// error, they may differ.
std::string distances_text(const SceneBench& bench) {
    if (bench.distance->limits.relative_error > 0) return "";
    const SubjectBench& first = bench.subjects.front();
    std::string others;
    for (const SubjectBench& subject : bench.subjects)
        if (subject.distances != first.distances)
            others += (others.empty() ? "" : ", ") + subject.subject.title();
    return others.empty()
               ? "  All found the same distances.\n"
               : "  Other distances than " + first.subject.title() + ": " + others + "\n";
}

/// What the queries look for, at the end of a title: ", distance".
std::string asked_words(const std::optional<DistanceQuery>& query) {
    if (!query) return "";
    return query->within ? format(", triangles at most %g apart", *query->within) : ", distance";
}

/// "  All found the same pairs.", or the names of the subjects that did not.
std::string pairs_text(const SceneBench& bench) {
    if (bench.subjects.size() < 2) return "";
    if (is_of_smallest(bench.distance)) return distances_text(bench);
    const SubjectBench& first = bench.subjects.front();
    std::string others;
    for (const SubjectBench& subject : bench.subjects)
        if (subject.pairs_hash() != first.pairs_hash())
            others += (others.empty() ? "" : ", ") + subject.subject.title();
    const std::string what = bench.first ? "answers" : "pairs";
    return others.empty()
               ? "  All found the same " + what + ".\n"
               : "  Other " + what + " than " + first.subject.title() + ": " + others + "\n";
}

}  // namespace

std::string bench_table(const SceneBench& bench) {
    const SubjectBench* scb = first_scb(bench);
    const bool in_paper = paper_entry(bench, VolumeKind::scb).has_value();
    std::string text = bench.scene + ": " + bench.bodies[0] + " and " + bench.bodies[1] +
                       format(", %s and %s triangles, %zu frame%s\n",
                              render::count_text(bench.triangles[0]).c_str(),
                              render::count_text(bench.triangles[1]).c_str(), bench.frames.size(),
                              bench.frames.size() == 1 ? "" : "s");
    text.insert(text.size() - 1, asked_words(bench.distance));
    std::size_t width = 16;
    for (const SubjectBench& subject : bench.subjects)
        width = std::max(width, subject.subject.title().size());
    const int column = static_cast<int>(width);
    const bool coherent =
        std::any_of(bench.subjects.begin(), bench.subjects.end(),
                    [](const SubjectBench& subject) { return subject.subject.coherent; });
    text += format("  %-*s", column, "hierarchy");
    const bool of_smallest = is_of_smallest(bench.distance);
    text += std::string("       ms    / SCB         N_v        N_p ") +
            (of_smallest ? "  distance" : "     pairs") + "   ns/N_v  bytes";
    if (coherent) text += "   front";
    text += in_paper ? "  |  Table 3: ms / SCB        N_v       N_p\n" : "\n";
    for (const SubjectBench& subject : bench.subjects) {
        const double ms = subject.mean_ms(), n_v = mean(subject.n_v);
        text += format("  %-*s %8.4f", column, subject.subject.title().c_str(), ms) +
                (scb == nullptr ? std::string("        -")
                                : format(" %8.2f", ratio(ms, scb->mean_ms()))) +
                count_cell(11, subject.n_v) + count_cell(11, subject.n_p) +
                (of_smallest ? distance_cell(subject) : count_cell(11, subject.pairs)) +
                (n_v > 0 ? format(" %8.1f", 1e6 * ms / n_v) : "        -") +
                format(" %6.1f", subject.bytes_per_triangle) +
                (coherent ? front_cell(subject) : "") +
                (subject.subject.layout ? "" : paper_cells(bench, subject.subject.kind)) + "\n";
    }
    text += pairs_text(bench);
    if (in_paper && bench.scene == "hands")
        text += "  (Table 3's hand is another mesh, of 654,666 triangles)\n";
    return text;
}

void BenchCosts::add(const SceneBench& bench) {
    ++scenes;
    titles.resize(bench.subjects.size());
    samples.resize(bench.subjects.size());
    for (std::size_t s = 0; s < bench.subjects.size(); ++s) {
        const SubjectBench& subject = bench.subjects[s];
        titles[s] = subject.subject.title();
        for (std::size_t i = 0; i < bench.frames.size(); ++i)
            samples[s].push_back({1e6 * subject.ms[i], static_cast<double>(subject.n_v[i]),
                                  static_cast<double>(subject.n_p[i]),
                                  static_cast<double>(subject.n_u[i])});
    }
}

std::string BenchCosts::table() const {
    const std::size_t queries = samples.empty() ? 0 : samples[0].size();
    std::size_t width = 16;
    for (const std::string& title : titles) width = std::max(width, title.size());
    const int column = static_cast<int>(width);
    std::string text =
        format("Equation 1, T = N_v C_v + N_p C_p + N_u C_u, over %zu quer%s of %zu scene%s:\n",
               queries, queries == 1 ? "y" : "ies", scenes, scenes == 1 ? "" : "s") +
        format("  %-*s", column, "hierarchy") +
        "  C_v ns  C_p ns  C_u ns   volumes triangles    moves    error\n";
    std::vector<CostEquation> equations;
    for (const auto& of_subject : samples) equations.push_back(fit_cost_equation(of_subject));
    if (std::none_of(equations.begin(), equations.end(),
                     [](const CostEquation& costs) { return costs.determined; }))
        return format(
            "Equation 1, T = N_v C_v + N_p C_p + N_u C_u: %zu quer%s of %zu scene%s "
            "cannot tell its costs apart; time more frames or other scenes.\n",
            queries, queries == 1 ? "y" : "ies", scenes, scenes == 1 ? "" : "s");
    bool doubtful = false, without_moves = false, none = false;
    for (std::size_t s = 0; s < samples.size(); ++s) {
        const CostEquation& costs = equations[s];
        text += format("  %-*s", column, titles[s].c_str());
        if (!costs.determined) {
            text += "       -       -       -         -         -        -        -\n";
            doubtful = true;
            continue;
        }
        without_moves |= !costs.moves_apart;
        none |= costs.c_v == 0 || costs.c_p == 0;
        const auto cost = [](double c) { return c > 0 ? format(" %7.2f", c) : "       -"; };
        const auto share = [](double c, double of_all) {
            return c > 0 ? format(" %7.0f %%", 100 * of_all) : "         -";
        };
        text += cost(costs.c_v) + cost(costs.c_p) + cost(costs.c_u) +
                share(costs.c_v, costs.share_v) + share(costs.c_p, costs.share_p) +
                share(costs.c_u, costs.share_u).substr(1) +
                format(" %6.0f %%\n", 100 * costs.error);
    }
    if (without_moves)
        text +=
            "  - of C_u: volumes are moved as their tests need it, so C_v holds that; packed "
            "layouts do not count it.\n";
    if (none)
        text +=
            "  - of C_v or C_p: there were no such tests, or what they cost is in the other; time "
            "more and other scenes.\n";
    if (doubtful)
        text +=
            "  - of all: the counts go together in these queries, or they are too few, so that "
            "costs cannot be told apart; time more and other scenes.\n";
    return text;
}

Json BenchCosts::json() const {
    Json list = Json::array();
    for (std::size_t s = 0; s < samples.size(); ++s) {
        const CostEquation costs = fit_cost_equation(samples[s]);
        const auto known = [&](double value) {
            return costs.determined && value > 0 ? Json(value) : Json();
        };
        list.push_back({{"hierarchy", titles[s]},
                        {"queries", samples[s].size()},
                        {"c_v_ns", known(costs.c_v)},
                        {"c_p_ns", known(costs.c_p)},
                        {"c_u_ns", costs.moves_apart ? Json(costs.c_u) : Json()},
                        {"share_v", known(costs.share_v)},
                        {"share_p", known(costs.share_p)},
                        {"share_u", costs.moves_apart ? Json(costs.share_u) : Json()},
                        {"error", costs.determined ? Json(costs.error) : Json()}});
    }
    return list;
}

Json bench_json(const SceneBench& bench) {
    const SubjectBench* scb = first_scb(bench);
    const bool of_smallest = is_of_smallest(bench.distance);
    Json hierarchies = Json::array();
    for (const SubjectBench& subject : bench.subjects) {
        const double ms = subject.mean_ms(), n_v = mean(subject.n_v);
        Json row = {{"hierarchy", subject.subject.title()},
                    {"volume", volume_kind_name(subject.subject.kind)},
                    {"split", split_method_name(subject.subject.split)}};
        if (subject.subject.layout)
            row["layout"] = packed_layout_name(*subject.subject.layout);
        else if (subject.subject.test)
            row["test"] = overlap_test_name(*subject.subject.test);
        if (subject.subject.coherent) row["from_front"] = subject.from_front;
        row["ms"] = ms;
        row["n_v"] = n_v;
        row["n_p"] = mean(subject.n_p);
        row["n_u"] = mean(subject.n_u);
        if (of_smallest)
            row["distance"] = mean_distance(subject);
        else
            row["pairs"] = mean(subject.pairs);
        if (!bench.first && !of_smallest) row["pairs_hash"] = hash_text(subject.pairs_hash());
        row["ns_per_volume_test"] = n_v > 0 ? Json(1e6 * ms / n_v) : Json();
        row["bytes_per_triangle"] = subject.bytes_per_triangle;
        for (std::size_t p = 0; p < subject.predictors.size(); ++p)
            row["measures"][std::string(cost_predictors()[p].name)] = subject.predictors[p];
        if (scb != nullptr) row["time_over_scb"] = ratio(ms, scb->mean_ms());
        if (const std::optional<Table3Entry> entry = paper_entry(bench, subject.subject.kind))
            row["table_3"] = {
                {"ms", entry->ms},
                {"n_v", entry->n_v},
                {"n_p", entry->n_p},
                {"time_over_scb", ratio(entry->ms, paper_entry(bench, VolumeKind::scb)->ms)}};
        hierarchies.push_back(std::move(row));
    }
    return {{"scene", bench.scene},
            {"bodies", bench.bodies},
            {"triangles", bench.triangles},
            {"frames", bench.frames.size()},
            {"hierarchies", hierarchies}};
}

Json bench_frame_json(const SceneBench& bench, std::size_t i) {
    Json subjects = Json::array();
    for (const SubjectBench& subject : bench.subjects)
        subjects.push_back(
            {{"ms", subject.ms[i]},
             {"n_v", subject.n_v[i]},
             {"n_p", subject.n_p[i]},
             {"n_u", subject.n_u[i]},
             {"pairs", subject.pairs[i]},
             {"pairs_hash", subject.pairs_hashes[i]},
             {"distance",
              std::isfinite(subject.distances[i]) ? Json(subject.distances[i]) : Json()},
             {"bytes_per_triangle", subject.bytes_per_triangle},
             {"predictors", subject.predictors}});
    return {{"frame", bench.frames[i]}, {"subjects", std::move(subjects)}};
}

void add_bench_frame(SceneBench& bench, const Json& json) {
    bench.frames.push_back(json.at("frame").get<int>());
    for (std::size_t s = 0; s < bench.subjects.size(); ++s) {
        const Json& from = json.at("subjects").at(s);
        SubjectBench& subject = bench.subjects[s];
        const auto count = [&](const char* name) { return from.at(name).get<std::uint64_t>(); };
        subject.ms.push_back(from.at("ms").get<double>());
        subject.n_v.push_back(count("n_v"));
        subject.n_p.push_back(count("n_p"));
        subject.n_u.push_back(count("n_u"));
        subject.pairs.push_back(count("pairs"));
        subject.pairs_hashes.push_back(count("pairs_hash"));
        const Json& distance = from.at("distance");
        subject.distances.push_back(distance.is_null() ? std::numeric_limits<double>::infinity()
                                                       : distance.get<double>());
        // These values are the same in each frame.
        from.at("bytes_per_triangle").get_to(subject.bytes_per_triangle);
        from.at("predictors").get_to(subject.predictors);
    }
}

Json asked_json(const DistanceQuery& query) {
    return query.within ? Json{{"tolerance", *query.within}} : limits_json(query.limits);
}

std::string bench_csv_header(const std::optional<DistanceQuery>& query) {
    return std::string("scene,hierarchy,test,frame,ms,n_v,n_p,n_u,") +
           (is_of_smallest(query) ? "distance" : "pairs") + ",split\n";
}

namespace {

/// The number of pairs, or the distance with all of its digits; empty if there is none.
std::string found_cell(const SceneBench& bench, const SubjectBench& subject, std::size_t i) {
    if (!is_of_smallest(bench.distance)) return std::to_string(subject.pairs[i]);
    const double distance = subject.distances[i];
    return std::isfinite(distance) ? exact_number(distance) : "";
}

}  // namespace

std::string bench_csv(const SceneBench& bench) {
    std::string text;
    for (const SubjectBench& s : bench.subjects) {
        const std::string start =
            bench.scene + "," + std::string(volume_kind_name(s.subject.kind)) + "," +
            (s.subject.layout
                 ? packed_layout_name(*s.subject.layout) + (s.subject.coherent ? " front" : "")
             : s.subject.test ? std::string(overlap_test_name(*s.subject.test))
                              : std::string());
        for (std::size_t i = 0; i < bench.frames.size(); ++i)
            text += start +
                    format(",%d,%.6f,%llu,%llu,%llu,", bench.frames[i], s.ms[i],
                           static_cast<unsigned long long>(s.n_v[i]),
                           static_cast<unsigned long long>(s.n_p[i]),
                           static_cast<unsigned long long>(s.n_u[i])) +
                    found_cell(bench, s, i) + "," +
                    std::string(split_method_name(s.subject.split)) + "\n";
    }
    return text;
}

render::BenchFigure bench_figure(const SceneBench& bench) {
    render::BenchFigure figure;
    figure.scene = bench.scene + asked_words(bench.distance);
    figure.triangles = {bench.triangles.begin(), bench.triangles.end()};
    for (const SubjectBench& subject : bench.subjects) {
        render::BenchSeries series;
        series.name = subject.subject.title();
        series.kind = subject.subject.kind;
        series.frames = bench.frames;
        series.n_v = doubles(subject.n_v);
        series.n_p = doubles(subject.n_p);
        series.ms = subject.ms;
        if (!is_of_smallest(bench.distance)) series.pairs = doubles(subject.pairs);
        figure.series.push_back(std::move(series));
    }
    // The surfaces of the two spheres pass each other here (Section 5).
    if (bench.builtin && bench.scene.starts_with("spheres-"))
        figure.ranges.push_back({244, 256, "parallel close proximity"});
    return figure;
}

}  // namespace scb::app
