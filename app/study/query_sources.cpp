#include "app/study/query_sources.h"
#include "app/report/scene_report.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/report/trace_report.h"
#include "core/platform/number_list.h"
#include "render/figures/figure_words.h"
#include "scb/error.h"
#include "scenes/recordings/recording_input.h"

namespace scb::app {
namespace {

/// In --compare, the name of the recorded query.
constexpr const char* recorded_name = "recorded";

/// The options of one of two queries that are compared.
struct Side {
    HierarchyOptions hierarchy;
    QueryOptions query;
};

std::array<Side, 2> sides_of(const CompareOptions& compare, const HierarchyOptions& hierarchy,
                             const QueryOptions& query) {
    const std::string option = "--compare " + compare.names;
    const std::vector<std::string> names = split_list(compare.names);
    const auto all = [&names](auto known) {
        return std::all_of(names.begin(), names.end(),
                           [&](const std::string& name) { return known(name).has_value(); });
    };
    const bool of_tests = all([](const std::string&n) { return overlap_test_of(n); }),
               of_volumes = all([](const std::string&n) { return volume_kind_of(n); });
    if (names.size() != 2 || names[0] == names[1] || (!of_tests && !of_volumes))
        throw InputError(option +
                         ": give two overlap tests, such as corrected,printed, or two volumes, "
                         "such as scb,ball.");
    const std::string taken = of_tests ? "--test" : "--volume";
    if (std::find(compare.given.begin(), compare.given.end(), taken) != compare.given.end())
        throw InputError(option + ": it says the " + taken.substr(2) + "s; leave out " + taken +
                         ".");
    if (of_tests && hierarchy.kind() != VolumeKind::scb)
        throw InputError(
            option + ": these are tests for slab cut balls with one slab (scb), and --volume is " +
            hierarchy.volumes + "; leave it out, or compare two volumes.");
    std::array<Side, 2> sides;
    for (std::size_t i = 0; i < 2; ++i) {
        sides[i] = {hierarchy, query};
        (of_tests ? sides[i].query.test : sides[i].hierarchy.volumes) = names[i];
    }
    return sides;
}

std::string text_of(const TraceHeader& header) { return header.scene + ", " + bodies_text(header); }

void check_comparable(const QuerySources& sources) {
    const TraceHeader &a = sources[0].header(), &b = sources[1].header();
    // Bodies of two mesh files are called after these, which may have been renamed.
    const bool are_named = (a.source.size() != 2 || b.source.size() != 2) && !a.engine && !b.engine;
    for (std::size_t side = 0; side < 2; ++side)
        if ((are_named && (a.scene != b.scene || a.bodies[side].name != b.bodies[side].name)) ||
            !same_meshes(a, b))
            throw InputError("the traces are of other scenes, bodies or meshes (" + text_of(a) +
                             "; " + text_of(b) + "); give two of one scene.");
    if (a.kind != b.kind && (is_of_distance(a.kind) || is_of_distance(b.kind)))
        throw InputError("the two inputs have queries of different kinds (" +
                         std::string(query_kind_name(a.kind)) + ", " +
                         std::string(query_kind_name(b.kind)) + "); give two of one kind.");
    if (pairs_are_nodes(a) != pairs_are_nodes(b) || a.options.stop_level != b.options.stop_level)
        throw InputError(
            "the traces stop at other levels, so that one has pairs of other things; record them "
            "with the same --level.");
    if (sources[0].frames() != sources[1].frames())
        throw InputError(
            "the traces have other frames; name frames that are in both with --frames.");
}

/// If two files show different frames by default, shows one frame of both files: preferably the
/// default of a recording, which is its frame with the most pairs.
void show_one_frame(QuerySources& sources,
                    const std::function<QuerySource(std::size_t, const std::string&)>& open) {
    if (sources[0].frames() == sources[1].frames()) return;
    const std::vector<int> of_a = sources[0].all_frames(), of_b = sources[1].all_frames();
    std::vector<int> both;
    std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                          std::back_inserter(both));
    if (both.empty()) return;
    int shown = both.front();
    bool chosen = false;
    for (const bool recorded : {true, false})
        for (const QuerySource& source : sources) {
            const int own = source.frames().front();
            if (chosen || source.is_recording() != recorded ||
                !std::binary_search(both.begin(), both.end(), own))
                continue;
            shown = own;
            chosen = true;
        }
    for (std::size_t i = 0; i < 2; ++i)
        if (sources[i].frames() != std::vector{shown}) sources[i] = open(i, std::to_string(shown));
}

/// The text with "-" in place of all but letters, digits, points and hyphens.
std::string file_name_part(const std::string& text) {
    std::string part;
    for (const char c : text) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9') || c == '.' || c == '-';
        part += plain ? c : '-';
    }
    return part;
}

/// The volume's title, with the overlap test if the volume has several.
std::string volume_caption(const TraceHeader& header) {
    const std::string title = render::volume_title(header);
    return !header.engine && header.volume == VolumeKind::scb
               ? title + ", test " + std::string(overlap_test_name(header.options.overlap.test))
               : title;
}

/// A recorded query, and the query that this project makes of the recording's meshes and poses.
QuerySources beside_recording(const SceneOptions& scene, const HierarchyOptions& hierarchy,
                              const QueryOptions& query, const QueryLimits& limits,
                              const CompareOptions& compare) {
    const std::string option = "--compare " + compare.names;
    std::vector<std::string> names = split_list(compare.names);
    const bool has_two =
        names.size() == 2 && std::count(names.begin(), names.end(), recorded_name) == 1;
    HierarchyOptions own = hierarchy;
    if (has_two) own.volumes = names[names[0] == recorded_name ? 1 : 0];
    if (!has_two || !volume_kind_of(own.volumes))
        throw InputError(option +
                         ": give what was recorded and one of this project's volumes, such "
                         "as recorded,scb2.");
    if (std::find(compare.given.begin(), compare.given.end(), "--volume") != compare.given.end())
        throw InputError(option + ": it says the volume; leave out --volume.");
    QuerySources sources;
    QueryOptions of_both = query;
    sources.emplace_back(scene, own, of_both, limits, true);
    // The frames and bodies of the recording.
    of_both.frames = list_text(sources[0].frames());
    of_both.bodies = sources[0].header().bodies[0].name + "," + sources[0].header().bodies[1].name;
    sources.emplace_back(scene, own, of_both, limits, false);
    if (names[1] == recorded_name) std::swap(sources[0], sources[1]);
    return sources;
}

}  // namespace

QuerySources open_sources(const SceneOptions& scene, const HierarchyOptions& hierarchy,
                          const QueryOptions& query, const QueryLimits& limits,
                          const CompareOptions& compare, const Note& note) {
    const auto count = [&scene](bool (*names)(const std::string&)) {
        return static_cast<std::size_t>(
            std::count_if(scene.names.begin(), scene.names.end(), names));
    };
    const std::size_t traces = count(scenes::names_trace),
                      files = traces + count(scenes::names_recording);
    if (traces > 0 && !compare.names.empty())
        throw InputError("--compare " + compare.names +
                         ": a trace is of one query; give two traces, or a scene.");
    QuerySources sources;
    if (files == 2 && scene.names.size() == 2) {
        if (!compare.names.empty())
            throw InputError("--compare " + compare.names +
                             ": these are two queries already; leave it out.");
        const auto open = [&](std::size_t i, const std::string& frames) {
            SceneOptions one = scene;
            one.names = {scene.names[i]};
            QueryOptions of_one = query;
            of_one.frames = frames;
            return QuerySource(one, hierarchy, of_one, limits, true);
        };
        for (std::size_t i = 0; i < 2; ++i) sources.push_back(open(i, query.frames));
        if (query.frames == auto_frames) show_one_frame(sources, open);
        check_comparable(sources);
        for (const QuerySource& source : sources) {
            if (source.is_recording()) continue;
            QueryOptions recorded = query;
            recorded.test = overlap_test_name(source.header().options.overlap.test);
            note_doubts(recorded, {source.query().kind}, note);
        }
    } else if (scene.is_recording() && compare.names.find(recorded_name) != std::string::npos) {
        sources = beside_recording(scene, hierarchy, query, limits, compare);
    } else if (compare.names.empty()) {
        // Distances are measured anew, between the recorded meshes.
        const bool recorded = asks_for_recorded(compare.given) && !query.distance;
        sources.emplace_back(scene, hierarchy, query, limits, recorded);
        if (!sources[0].is_recording()) {
            note_doubts(hierarchy, {sources[0].query().kind}, note);
            note_doubts(scene, sources[0].query().scene, query, {sources[0].query().kind}, note);
        }
    } else {
        for (const Side& side : sides_of(compare, hierarchy, query)) {
            sources.emplace_back(scene, side.hierarchy, side.query, limits, false);
            const SceneQuery& own = sources.back().query();
            if (sources.size() == 1)
                note_doubts(scene, own.scene, side.query, {own.kind}, note);
            else
                note_doubts(side.query, {own.kind}, note);
        }
        note_doubts(hierarchy, {sources[0].query().kind, sources[1].query().kind}, note);
    }
    for (const QuerySource& source : sources)
        if (source.is_recording()) note_left_out(*source.recorded(), note);
    return sources;
}

nlohmann::ordered_json subject_of(const QuerySources& sources) {
    nlohmann::ordered_json subject;
    for (const QuerySource& source : sources)
        subject.push_back(
            {trace_header_json(source.header()), all_poses_json(source.scene(), source.frames())});
    return subject;
}

std::array<QueryLabel, 2> query_labels(const TraceHeader& a, const TraceHeader& b) {
    std::array<QueryLabel, 2> labels;
    const auto add = [](QueryLabel& label, const std::string& caption, const std::string& name) {
        label.caption += (label.caption.empty() ? "" : ", ") + caption;
        label.name += (label.name.empty() ? "" : "-") + file_name_part(name);
    };
    if (a.engine || b.engine) {
        const std::string of_a = render::volume_title(a), of_b = render::volume_title(b);
        const bool tell = of_a != of_b;
        add(labels[0], tell ? of_a : "first, " + of_a, tell ? of_a : "first");
        add(labels[1], tell ? of_b : "second, " + of_b, tell ? of_b : "second");
        return labels;
    }
    const std::vector<TraceField> of_a = fields_of(a), of_b = fields_of(b);
    for (const TraceField& x : of_a)
        for (const TraceField& y : of_b) {
            if (x.name != y.name || x.value == y.value) continue;
            if (x.name == "volume") {
                add(labels[0], volume_caption(a), x.value);
                add(labels[1], volume_caption(b), y.value);
            } else {
                const std::string what = x.name == "test" ? "" : x.name + " ";
                add(labels[0], what + x.value, x.value);
                add(labels[1], what + y.value, y.value);
            }
        }
    if (labels[0].caption.empty()) labels = {QueryLabel{"first", "first"}, {"second", "second"}};
    return labels;
}

}  // namespace scb::app
