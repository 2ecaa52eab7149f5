#include "app/inspect/inspected_queries.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/cli/progress.h"
#include "core/judge/query_attribution.h"
#include "core/platform/number_list.h"
#include "scb/error.h"

namespace scb::app {
namespace {

WasteCauses causes_of(const QuerySource& source, int frame, const FrameFindings& found) {
    const BodyAtFrame a = source.body(0, frame), b = source.body(1, frame);
    const std::size_t of_b = source.header().kind == QueryKind::self ? 0 : 1;
    return waste_causes({*a.mesh, depth(a.tree->shape()), found.tested[0]},
                        {*b.mesh, depth(b.tree->shape()), found.tested[of_b]}, found.vain);
}

}  // namespace

InspectedQueries open_recording(const InspectOptions& options) {
    InspectedQueries result;
    const std::string& path = options.scene.names[0];
    result.file = options.scene.recording_file();
    result.frames = frames_among(result.file->summary.frames, options.query.frames,
                                 result.file->title(), "a recording may have");
    TraceHeader& header = result.report.header;
    header.scene = header.engine.emplace().name = std::filesystem::path(path).stem().string();
    try {
        result.recording =
            std::make_shared<const scenes::Recording>(scenes::read_recording(result.file));
    } catch (const InputError& error) {
        result.no_waste = error.what();
        return result;
    }
    // Bodies that were not queried are an error; bodies that cannot be placed are judged.
    if (!options.query.bodies.empty() && !result.recording->pairs.empty())
        chosen_pair(*result.recording, options.query.bodies);
    header.scene = result.recording->scene.name;
    header.engine->name = result.recording->engine;
    try {
        result.sources.emplace_back(result.recording, options.query);
        header = result.sources.front().header();
    } catch (const InputError& error) {
        result.no_waste = error.what();
    }
    return result;
}

InspectedQueries open_scene(const InspectOptions& options, const Console& console) {
    InspectedQueries result;
    result.sources.emplace_back(options.scene, options.hierarchy, options.query, options.limits,
                                false);
    const QuerySource& source = result.sources.front();
    note_doubts(options.hierarchy, {source.query().kind}, console.notes());
    note_doubts(options.scene, source.query().scene, options.query, {source.query().kind},
                console.notes());
    result.report.header = source.header();
    result.frames = source.frames();
    return result;
}

void judge(InspectedQueries& inspected, const InspectOptions& options, const Console& console,
           const InterruptWatch& watch) {
    Progress progress(console, inspected.frames.size());
    const std::vector<int>& frames = inspected.frames;
    scenes::JudgedQueryVisitor visit;
    if (!inspected.sources.empty()) {
        QuerySource& source = inspected.sources.front();
        inspected.found.emplace(source.header(), static_cast<std::size_t>(options.top));
        visit = [&](const scenes::RecordedQueries& queries, const QueryJudgement& judged) {
            const QueryTrace* frame = source.recorded()->frame_at(queries);
            if (frame == nullptr) return;
            inspected.found->add(source, *frame,
                                 attribution(queries.query(), judged, source.header(), *frame));
        };
    }
    scenes::RecordingJudgement judged = scenes::judge_recording(
        *inspected.file,
        [&](int frame) { return std::binary_search(frames.begin(), frames.end(), frame); },
        [&](bool frame) {
            if (frame) progress.step("frames");
            return watch.signal() == 0;
        },
        visit);
    if (judged.trees.empty() && judged.summary.queries == 0)
        throw InputError(inspected.file->path +
                         ": it has no trees and no queries, so there is nothing to judge." +
                         (judged.damage.empty() ? "" : " " + judged.damage));
    inspected.done = frames.size() - judged.frames_left;
    const auto top = static_cast<std::size_t>(options.top);
    inspected.report.recording = {
        inspected.file->path, std::move(judged), top, options.asks_top ? top : 1, {}};
}

void inspect_frames(InspectedQueries& inspected, const InspectOptions& options, Parts& parts,
                    const Console& console, const InterruptWatch& watch) {
    QuerySource& source = inspected.sources.front();
    const std::vector<int>& frames = inspected.frames;
    Progress progress(console, frames.size());
    const auto top = static_cast<std::size_t>(options.top);
    const auto inspect_frame = [&source](FrameFindings& findings, int number) {
        const QueryTrace& frame = source.frame(number);
        findings.add(source, frame, source.attribution(frame));
    };
    FrameFindings& found = inspected.found.emplace(source.header(), top);
    std::size_t& done = inspected.done;
    for (; done < frames.size() && watch.signal() == 0; ++done) {
        const int number = frames[done];
        if (parts.are_merged()) {
            parts.read(done, [&](const nlohmann::ordered_json& made, const auto&) {
                found += findings_of_json(made, source, number, top);
            });
        } else if (parts.are_of_shard() && parts.is_made_here(done)) {
            FrameFindings of_frame(source.header(), top);
            inspect_frame(of_frame, number);
            parts.keep(done, findings_json(of_frame));
        } else if (!parts.are_of_shard()) {
            inspect_frame(found, number);
        }
        progress.step("frames");
    }
}

ExplainedPairs report_waste(InspectedQueries& inspected) {
    InspectReport& report = inspected.report;
    if (!inspected.found || inspected.found->frames.empty()) {
        report.has_waste = false;
        return {};
    }
    const FrameFindings& found = *inspected.found;
    const QuerySource& source = inspected.sources.front();
    report.frames = found.frames;
    for (const InspectedFrame& frame : found.frames) report.sum += frame.found;
    // An error may be the cause of the waste of a recording that is wrong.
    if (inspected.file)
        report.has_waste = source.recorded()->has_results() && !report.recording->judged.wrong() &&
                           report.sum.counts.all.volume_tests > 0;
    if (!report.has_waste) return {};
    for (std::size_t side = 0; side < 2; ++side) {
        const Mesh& mesh = *source.body(side, found.frames.front().frame).mesh;
        // In another frame a recorded body may have a mesh of more triangles.
        std::erase_if(inspected.found->tested[side], [&mesh](const TestedTriangle& one) {
            return one.triangle >= mesh.triangles.size();
        });
        report.triangles[side] = {costly_triangles(found.tested[side], mesh, most_costly),
                                  item_tests(found.tested[side])};
    }
    report.others = found.others;
    report.wrong = found.wrong.pairs();
    for (const WorstPairs& worst : found.worst)
        report.worst.push_back({worst.reason(), worst.pairs()});
    // The steps of an overlap test explain no bound.
    ExplainedPairs explained;
    if (!is_of_distance(report.header.kind)) explained = explain_pairs(report, source);
    sort_by_waste(report.frames);
    if (!report.header.engine || !report.header.engine->objects)
        report.causes = causes_of(source, found.frames.front().frame, found);
    return explained;
}

bool can_compare_distances(const InspectedQueries& inspected) {
    if (inspected.sources.empty() || !is_of_distance(inspected.report.header.kind)) return false;
    const QuerySource& source = inspected.sources.front();
    if (inspected.file) return !inspected.report.recording->judged.wrong();
    // The commands of an advice take no trace.
    return source.makes_queries() && source.query().distance.has_value() &&
           source.query().mutation == Mutation::none &&
           inspected.report.sum.counts.wrongly_rejected == 0;
}

bool can_compare(const InspectedQueries& inspected) {
    if (inspected.sources.empty() || is_of_distance(inspected.report.header.kind)) return false;
    if (inspected.file) return !inspected.report.recording->judged.wrong();
    const SceneQuery& query = inspected.sources.front().query();
    return inspected.found->complete && query.options.stop_level < 0 &&
           query.mutation == Mutation::none && inspected.report.sum.counts.missed == 0;
}

}  // namespace scb::app
