#include "scenes/recordings/recorded_trace.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/judge/engine_trace.h"
#include "core/judge/query_attribution.h"
#include "core/judge/query_contacts.h"
#include "core/judge/test_links.h"
#include "core/model/tree.h"
#include "core/platform/number_list.h"
#include "scb/error.h"

namespace scb::scenes {
namespace {

using Ended = RecordedQueries::Ended;

bool are_objects(const std::array<BodyAtFrame, 2>& bodies) {
    return bodies[0].mesh->triangles.empty() || bodies[1].mesh->triangles.empty();
}

/// Whether the query tested the nodes, and whether it rejected them although their volumes overlap.
struct NodesTested {
    bool any = false, wrong = false;
};

NodesTested tested(const EngineQuery& query, IndexPair numbers) {
    NodesTested result;
    for (const EngineEvent& event : query.events) {
        if (event.kind != EngineEvent::Kind::volumes || event.a != numbers.a ||
            event.b != numbers.b)
            continue;
        result.any = true;
        const IndexPair nodes = nodes_of(query, event);
        result.wrong = event.stage != 0 && query.placed && nodes.a != no_index &&
                       nodes.b != no_index &&
                       exact_verdict((*query.sides[0].tree)[nodes.a].volume,
                                     (*query.sides[1].tree)[nodes.b].volume, query.b_to_a,
                                     tolerance_of(query, nodes))
                               .contact == Contact::overlapping;
        if (result.wrong) break;
    }
    return result;
}

}  // namespace

RecordedTrace::RecordedTrace(std::shared_ptr<const Recording> recording, const std::string& bodies,
                             const std::string& frames)
    : recording_(std::move(recording)) {
    choose(bodies, frames);
    read_bodies();
    queries_ = std::make_unique<RecordedQueries>(*recording_->file);
}

RecordedTrace::RecordedTrace(const RecordedTrace& other)
    : recording_(other.recording_),
      sides_(other.sides_),
      numbers_(other.numbers_),
      frames_(other.frames_),
      all_frames_(other.all_frames_),
      header_(other.header_),
      stages_(other.stages_),
      bodies_(other.bodies_),
      test_counts_(other.test_counts_),
      has_same_limits_(other.has_same_limits_),
      ended_early_(other.ended_early_),
      queries_(std::make_unique<RecordedQueries>(*recording_->file)) {}

std::unique_ptr<RecordedTrace> RecordedTrace::rewound() const {
    return std::unique_ptr<RecordedTrace>(new RecordedTrace(*this));
}

void RecordedTrace::choose(const std::string& bodies, const std::string& frames) {
    const QueriedPair& chosen = chosen_pair(*recording_, bodies);
    numbers_ = chosen.bodies;
    for (std::size_t side = 0; side < 2; ++side)
        sides_[side] = recording_->bodies.at(numbers_[side]);
    all_frames_ = chosen.frames;
    frames_ = frames == auto_frames ? std::vector{chosen.fullest}
                                    : frames_among(chosen.frames, frames, recording_->file->title(),
                                                   "a recording may have");
}

bool RecordedTrace::is_wanted(const RecordedQueries& queries) const {
    return queries.query_bodies() == numbers_ &&
           std::binary_search(frames_.begin(), frames_.end(), queries.frame());
}

void RecordedTrace::read_bodies() {
    RecordedQueries queries(*recording_->file);
    BodyCopies copies;
    TraceEngine& engine = header_.engine.emplace();
    for (Ended ended = queries.next(); ended != Ended::end; ended = queries.next()) {
        if (ended != Ended::query || !is_wanted(queries)) continue;
        if (bodies_.contains(queries.frame())) {
            ++engine.left_out;
            continue;
        }
        take_kind(queries.query());
        const std::vector<EngineEvent>& events = queries.query().events;
        test_counts_[queries.frame()] = static_cast<std::uint64_t>(std::count_if(
            events.begin(), events.end(),
            [](const EngineEvent& event) { return event.kind == EngineEvent::Kind::volumes; }));
        std::array<BodyAtFrame, 2>& at = bodies_[queries.frame()];
        for (std::size_t side = 0; side < 2; ++side)
            at[side] = copies.copy(queries, *recording_, numbers_[side]);
    }
    header_.source = {recording_->file->path};
    header_.scene = scene().name;
    engine.name = recording_->engine;
    engine.selection = recording_->file->selection.title();
    engine.volumes = copies.volumes();
    take_engine(queries);
    take_stages(queries);
}

void RecordedTrace::take_engine(const RecordedQueries& queries) {
    TraceEngine& engine = *header_.engine;
    const std::array<BodyAtFrame, 2>& first = bodies_.at(frames_.front());
    engine.objects = are_objects(first);
    for (std::size_t side = 0; side < 2; ++side)
        header_.bodies[side] = {first[side].name, fingerprint(*first[side].mesh)};
    std::map<const Tree*, std::uint64_t> hashes;  // lookups only
    for (const auto& [frame, at] : bodies_) {
        for (std::size_t side = 0; side < 2; ++side) {
            const auto [hash, added] = hashes.try_emplace(at[side].tree.get());
            if (added) hash->second = at[side].tree->hash();
            engine.trees[frame][side] = hash->second;
        }
        if (are_objects(at) != engine.objects)
            throw InputError(recording_->file->path +
                             ": a body has triangles at some of these frames, and objects " +
                             "at others such as frame " + std::to_string(frame) +
                             "; name frames of one kind with --frames.");
    }
    for (const RecordedSetting& setting : queries.settings())
        if (setting.key != "engine" && setting.key != "scene" && setting.key != "results")
            engine.settings.push_back({setting.key, setting.value});
}

void RecordedTrace::take_kind(const EngineQuery& query) {
    const bool is_first = bodies_.empty();
    if (!is_first && query.kind != header_.kind)
        throw InputError(recording_->file->path +
                         ": the queries of these bodies are of several kinds, at frame " +
                         std::to_string(query.frame) +
                         " of another kind than before; select queries of one kind with --query, "
                         "--tag or --frames.");
    header_.kind = query.kind;
    if (!query.complete && !ended_early_) ended_early_ = query.frame;
    if (!is_of_distance(query.kind)) return;
    const bool is_within = query.kind == QueryKind::within;
    double& limit = is_within ? header_.tolerance : header_.distance.limit;
    double& error = header_.distance.relative_error;
    const bool is_same = limit == query.limit && (is_within || error == query.relative_error);
    has_same_limits_ = has_same_limits_ && (is_first || is_same);
    limit = query.limit;
    if (!is_within) error = query.relative_error;
}

void RecordedTrace::take_stages(const RecordedQueries& queries) {
    const std::set<std::uint8_t>& used = recording_->file->summary.stages;
    std::vector<std::uint8_t> order = queries.stage_order();
    for (const std::uint8_t number : used)
        if (!queries.stages().contains(number)) order.push_back(number);
    std::map<std::uint8_t, std::string> names;
    std::set<std::string> taken = {std::string(stage_name(Stage::overlapping))};
    for (const std::uint8_t number : order) {
        const auto named = queries.stages().find(number);
        std::string& name = names[number];
        name = named != queries.stages().end() ? named->second : "stage " + std::to_string(number);
        // Names must differ, since counts go by names.
        while (!taken.insert(name).second) name += " (" + std::to_string(number) + ")";
    }
    // Stages at which tests ended come first, and have the first colors.
    for (const bool are_used : {true, false})
        for (const std::uint8_t number : order)
            if (used.contains(number) == are_used)
                stages_[number] = header_.stages.add(names[number]);
    for (const std::uint8_t number : order) header_.engine->stages.push_back(stages_[number]);
    if (!is_of_distance(header_.kind)) return;
    std::string name = "left out by its bound";
    while (!taken.insert(name).second) name += " of distance";
    stages_[left_out_stage] = header_.stages.add(name);
    header_.engine->stages.push_back(stages_[left_out_stage]);
}

const BodyAtFrame& RecordedTrace::body(std::size_t side, int frame) const {
    return bodies_.at(frame)[side];
}

const QueryTrace& RecordedTrace::frame(int number) {
    if (latest_ == number) return frame_;
    latest_ = number;
    while (true) {
        const Ended ended = queries_->next();
        if (ended == Ended::end)
            throw InputError(recording_->file->path + ": it has no frame " +
                             std::to_string(number) + " any more.");
        if (ended == Ended::query && queries_->frame() == number && is_wanted(*queries_)) break;
    }
    return set_frame(queries_->query());
}

const QueryTrace* RecordedTrace::frame_at(const RecordedQueries& queries) {
    if (!is_wanted(queries) || visited_ == queries.frame()) return nullptr;
    visited_ = queries.frame();
    latest_.reset();
    return &set_frame(queries.query());
}

const QueryTrace& RecordedTrace::set_frame(const EngineQuery& query) {
    frame_ = trace_frame(query, stages_);
    for (std::size_t side = 0; side < 2; ++side) frame_.trees[side] = body(side, query.frame).tree;
    return frame_;
}

int RecordedTrace::frame_of_test(IndexPair nodes, int usual) const {
    RecordedQueries queries(*recording_->file);
    std::optional<int> seen;  // of several queries in a frame, the first counts
    std::optional<int> first;
    for (Ended ended = queries.next(); ended != Ended::end; ended = queries.next()) {
        if (ended != Ended::query || queries.query_bodies() != numbers_ || seen == queries.frame())
            continue;
        seen = queries.frame();
        const NodesTested found = tested(queries.query(), nodes);
        if (found.wrong) return *seen;
        if (found.any && (!first || *seen == usual)) first = seen;
    }
    return first.value_or(usual);
}

Attribution RecordedTrace::attribution() {
    const EngineQuery& query = queries_->query();
    if (!query.placed) return {};
    return scb::attribution(query, judge_query(query, own_.truth(query, queries_->finite_meshes())),
                            header_, frame_);
}

RecordedResults RecordedTrace::results() {
    EngineQuery query = queries_->query();
    if (!query.placed) return {};
    // Tests of volumes take most of the time, and do not affect results.
    std::erase_if(query.events, [](const EngineEvent& event) {
        return event.kind == EngineEvent::Kind::volumes;
    });
    const QueryJudgement judged = judge_query(query, own_.truth(query, queries_->finite_meshes()));
    RecordedResults results{judged.reported, judged.not_looked_into, 0, judged.grazing};
    for (const PairProblem& problem : judged.pairs)
        ++(is_missed(problem.cause) ? results.missed : results.wrong);
    return results;
}

std::vector<std::size_t> RecordedTrace::level_overlaps(std::size_t most) {
    return scb::level_overlaps(queries_->query(), most);
}

}  // namespace scb::scenes
