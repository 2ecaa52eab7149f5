#include "core/analysis/trace_diff.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <tuple>

#include "core/analysis/ending.h"
#include "core/collide/index_pairs.h"
#include "core/distance/distance_certificate.h"
#include "scb/error.h"

namespace scb {
namespace {

const std::string* value_of(const std::vector<TraceField>& fields, const std::string& name) {
    for (const TraceField& field : fields)
        if (field.name == name) return &field.value;
    return nullptr;
}

/// Recordings have names of volumes in capitals.
std::string lower_case(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

std::vector<FieldDifference> asked_differently(const TraceHeader& a, const TraceHeader& b) {
    std::vector<FieldDifference> result;
    std::vector<TraceField> fields_a = fields_of(a), fields_b = fields_of(b);
    const bool of_engines = a.engine && b.engine;
    // Names of recordings are not compared, and trees are compared frame by frame if both are
    // known.
    for (std::vector<TraceField>* fields : {&fields_a, &fields_b})
        std::erase_if(*fields, [of_engines](const TraceField& field) {
            return field.name.starts_with("tree of ") || (of_engines && field.name == "scene");
        });
    if (of_engines) {
        for (std::size_t side = 0; side < 2; ++side)
            if (const auto frame = other_tree_at(*a.engine, *b.engine, side))
                for (const auto& [engine, fields] :
                     {std::pair(&*a.engine, &fields_a), std::pair(&*b.engine, &fields_b)})
                    fields->push_back({side == 0 ? "tree of A" : "tree of B",
                                       hash_text(engine->trees.at(*frame)[side]) + " at frame " +
                                           std::to_string(*frame)});
    }
    for (const TraceField& field : fields_a) {
        const std::string* other = value_of(fields_b, field.name);
        if (other == nullptr ||
            (field.name == "volume" ? lower_case(*other) != lower_case(field.value)
                                    : *other != field.value))
            result.push_back({field.name, field.value, other ? *other : "-"});
    }
    for (const TraceField& field : fields_b)
        if (value_of(fields_a, field.name) == nullptr)
            result.push_back({field.name, "-", field.value});
    return result;
}

/// A test of a query of distances that does not reject has the volumes near enough.
std::string stage_words_of_kind(const TraceHeader& header, Stage stage) {
    return is_of_distance(header.kind) && stage == Stage::overlapping ? "near"
                                                                      : stage_words(header, stage);
}

/// The names of all stages: this project's, then the engines' own in their order.
std::vector<std::string> stage_order(const TraceHeader& a, const TraceHeader& b) {
    std::vector<std::string> names = {stage_words_of_kind(a, Stage::overlapping)};
    const auto add = [&names](std::string name) {
        if (std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(std::move(name));
    };
    for (const std::span<const Stage> test :
         {stages_of(OverlapTest::corrected), scb2_stages(), convex_stages(), obb_stages()})
        for (const Stage stage : test) add(std::string(stage_name(stage)));
    for (const TraceHeader* header : {&a, &b})
        if (header->engine)
            for (const Stage stage : header->engine->stages) add(stage_words(*header, stage));
    return names;
}

/// Index of the first volume test that differs in its nodes, its outcome or its triangle tests.
/// Nothing if all are the same.
std::optional<std::size_t> parting_test(const QueryTrace& a, const Outcomes& outcomes_a,
                                        const QueryTrace& b, const Outcomes& outcomes_b) {
    const auto differ = [](const auto& of_a, const auto& of_b) -> std::size_t {
        const auto first = std::mismatch(of_a.begin(), of_a.end(), of_b.begin(), of_b.end());
        return static_cast<std::size_t>(first.first - of_a.begin());
    };
    std::size_t test =
        std::min(differ(a.steps.volumes, b.steps.volumes), differ(outcomes_a, outcomes_b));
    const auto& triangles_a = a.steps.items;
    const auto& triangles_b = b.steps.items;
    const std::size_t triangles = differ(triangles_a, triangles_b);
    if (triangles < triangles_a.size())
        test = std::min<std::size_t>(test, triangles_a[triangles].step);
    if (triangles < triangles_b.size())
        test = std::min<std::size_t>(test, triangles_b[triangles].step);
    const bool same = test == outcomes_a.size() && test == outcomes_b.size();
    return same ? std::nullopt : std::optional(test);
}

std::optional<NearestTriangles> nearest_of(const QueryTrace& frame) {
    if (!frame.nearest || frame.found.pairs.empty()) return std::nullopt;
    return NearestTriangles{frame.nearest->distance, frame.found.pairs.front()};
}

/// The frame of B with the stages of A's table, by name.
QueryTrace with_stages_of(const TraceHeader& a, const TraceHeader& b, QueryTrace frame) {
    constexpr Stage not_of_a{255};
    std::map<Stage, Stage> renamed;
    for (const Stage stage : b.engine->stages)
        renamed[stage] = a.stages.find(stage_words(b, stage)).value_or(not_of_a);
    for (Step& test : frame.steps.volumes)
        if (const auto found = renamed.find(test.stage); found != renamed.end())
            test.stage = found->second;
    return frame;
}

std::optional<TracedTest> traced(const TraceHeader& header, const QueryTrace& frame,
                                 const Outcomes& outcomes, std::size_t index) {
    if (index >= frame.steps.volumes.size()) return std::nullopt;
    return traced_test(header, frame, outcomes, index);
}

bool same_pose(const Pose& a, const Pose& b) {
    return a.rotation == b.rotation && a.translation == b.translation;
}

/// The volume test that led to the pair. Other engines may not record it.
std::optional<std::size_t> test_of(const TraceHeader& header, const QueryTrace& frame,
                                   const Outcomes& outcomes, bool of_nodes, IndexPair pair) {
    if (of_nodes)
        for (std::size_t i = 0; i < outcomes.size(); ++i)
            if (outcomes[i] == Stage::found && frame.steps.volumes[i].nodes == pair) return i;
    for (const ItemStep& t : frame.steps.items)
        if (t.hit && pair_of(header, t) == pair) return t.step;
    return std::nullopt;
}

/// A query at one frame.
struct AtFrame {
    const TraceHeader& header;
    const QueryTrace& frame;
    const Outcomes& outcomes;
};

/// Looks for the test by which `lost_by` left out the pair that `found` has.
LostPair lost_pair(const AtFrame& found, const AtFrame& lost_by, const TraceDiff& d,
                   IndexPair pair) {
    const auto& [finder_header, finder, finder_outcomes] = found;
    const auto& [other_header, other, other_outcomes] = lost_by;
    const IndexPair told = d.of_nodes ? numbers_of(finder, pair) : pair;
    LostPair lost{finder.frame, told, false, !other.found.complete, std::nullopt, 0};
    if (!d.nodes_comparable) return lost;
    const std::optional<std::size_t> from =
        test_of(finder_header, finder, finder_outcomes, d.of_nodes, pair);
    if (!from) return lost;
    // The finder came down from the roots step by step, so these are all ancestors of the pair.
    std::set<std::uint32_t> ancestors_a, ancestors_b;
    for (std::size_t i = *from;; i = finder.steps.volumes[i].parent) {
        ancestors_a.insert(finder.steps.volumes[i].nodes.a);
        ancestors_b.insert(finder.steps.volumes[i].nodes.b);
        if (finder.steps.volumes[i].parent == no_step) break;
    }
    for (std::size_t i = 0; i < other.steps.volumes.size(); ++i) {
        const Stage outcome = other_outcomes[i];
        const IndexPair nodes = other.steps.volumes[i].nodes;
        if (is_divided(outcome) || !ancestors_a.contains(nodes.a) || !ancestors_b.contains(nodes.b))
            continue;
        lost.lost_at = traced_test(other_header, other, other_outcomes, i);
        lost.test = i;
        break;
    }
    return lost;
}

/// The pairs that only one of the two found.
void compare_pairs(const AtFrame& a, const AtFrame& b, FrameDifference& difference,
                   TraceDiff& result) {
    const auto& pairs_a = a.frame.found.pairs;
    const auto& pairs_b = b.frame.found.pairs;
    std::vector<IndexPair> only_a, only_b;
    std::set_difference(pairs_a.begin(), pairs_a.end(), pairs_b.begin(), pairs_b.end(),
                        std::back_inserter(only_a));
    std::set_difference(pairs_b.begin(), pairs_b.end(), pairs_a.begin(), pairs_a.end(),
                        std::back_inserter(only_b));
    result.pairs_only_in_a += difference.pairs_only_in_a = only_a.size();
    result.pairs_only_in_b += difference.pairs_only_in_b = only_b.size();
    for (const IndexPair& pair : only_a) {
        if (result.lost.size() == TraceDiff::most_lost) return;
        result.lost.push_back(lost_pair(a, b, result, pair));
        result.lost.back().found_by_a = true;
    }
    for (const IndexPair& pair : only_b) {
        if (result.lost.size() == TraceDiff::most_lost) return;
        result.lost.push_back(lost_pair(b, a, result, pair));
    }
}

QueryTraces frames_of(const Trace& trace) {
    return [&trace, next = std::size_t{0}]() mutable {
        return next < trace.frames.size() ? &trace.frames[next++] : nullptr;
    };
}

}  // namespace

bool FrameDifference::distances_differ() const {
    if (!nearest_a || !nearest_b) return nearest_a.has_value() != nearest_b.has_value();
    return !equal_distances(nearest_a->distance, nearest_b->distance, rounding);
}

bool FrameDifference::triangles_differ() const {
    if (!nearest_a || !nearest_b || meshes_differ || distances_differ()) return false;
    return nearest_a->triangles != nearest_b->triangles &&
           (nearest_a->distance > 0 || nearest_b->distance > 0);
}

void TraceCounts::add(const TraceHeader& header, const QueryTrace& frame) {
    const Collision& found = frame.found;
    pairs += found.pairs.size();
    n_v += found.n_v;
    n_p += found.n_p;
    if (!header.engine) n_u = n_u.value_or(0) + found.n_u;
    EndingCounts tests{};
    for (const Step& test : frame.steps.volumes) ++tests[static_cast<std::size_t>(test.stage)];
    for (std::size_t s = 0; s < tests.size(); ++s)
        if (tests[s] != 0) stages[stage_words_of_kind(header, static_cast<Stage>(s))] += tests[s];
}

bool operator==(const TraceCounts& a, const TraceCounts& b) {
    return std::tie(a.pairs, a.n_v, a.n_p, a.stages) == std::tie(b.pairs, b.n_v, b.n_p, b.stages) &&
           (!a.n_u || !b.n_u || a.n_u == b.n_u);
}

TracedTest traced_test(const TraceHeader& header, const QueryTrace& frame, const Outcomes& outcomes,
                       std::size_t index) {
    const Steps& steps = frame.steps;
    TracedTest result;
    result.kind = header.kind;
    const auto numbered = [&](std::size_t i) {
        Step test = steps.volumes[i];
        test.nodes = numbers_of(frame, test.nodes);
        return test;
    };
    result.test = numbered(index);
    result.outcome = outcomes[index];
    result.stage = stage_words(header, result.test.stage);
    auto triangles = std::lower_bound(steps.items.begin(), steps.items.end(), index,
                                      [](const ItemStep& t, std::size_t i) { return t.step < i; });
    for (; triangles != steps.items.end() && triangles->step == index; ++triangles) {
        if (!result.triangles || (triangles->hit && result.intersecting == 0))
            result.triangles = *triangles;
        ++result.triangle_tests;
        result.intersecting += triangles->hit;
    }
    if (const std::uint32_t parent = frame.steps.volumes[index].parent; parent != no_step) {
        result.parent = numbered(parent);
        result.parent_outcome = outcomes[parent];
    }
    return result;
}

TraceDiff diff(const TraceHeader& a, const QueryTraces& frames_a, const TraceHeader& b,
               const QueryTraces& frames_b) {
    if (a.kind != b.kind && (is_of_distance(a.kind) || is_of_distance(b.kind)))
        throw InputError(std::string("the first trace has queries of the kind ") +
                         std::string(query_kind_name(a.kind)) + ", and the second of the kind " +
                         std::string(query_kind_name(b.kind)) + "; compare two of one kind.");
    TraceDiff result;
    result.kind = a.kind;
    result.asked = asked_differently(a, b);
    result.stages = stage_order(a, b);
    result.nodes_comparable = same_meshes(a, b);
    result.meshes_differ = !result.nodes_comparable;
    result.of_engines = a.engine || b.engine;
    result.trees_known = a.engine.has_value() == b.engine.has_value();
    result.nodes_comparable &= same_nodes(a, b);
    result.bodies = side_names(a);
    result.of_nodes = pairs_are_nodes(a);
    result.pairs_comparable =
        a.kind != QueryKind::distance && !result.meshes_differ &&
        pairs_are_nodes(b) == result.of_nodes &&
        (a.engine || b.engine || a.options.stop_level == b.options.stop_level) &&
        (result.nodes_comparable || !result.of_nodes);
    const QueryTrace* frame_a = frames_a();
    const QueryTrace* frame_b = frames_b();
    while (frame_a || frame_b) {
        if (!frame_b || (frame_a && frame_a->frame < frame_b->frame)) {
            result.only_in_a.push_back(frame_a->frame);
            frame_a = frames_a();
            continue;
        }
        if (!frame_a || frame_b->frame < frame_a->frame) {
            result.only_in_b.push_back(frame_b->frame);
            frame_b = frames_b();
            continue;
        }
        ++result.common;
        result.sum_a.add(a, *frame_a);
        result.sum_b.add(b, *frame_b);
        FrameDifference difference;
        difference.frame = frame_a->frame;
        difference.poses_differ = !same_pose(frame_a->b_to_a, frame_b->b_to_a);
        difference.a.add(a, *frame_a);
        difference.b.add(b, *frame_b);
        if (a.kind == QueryKind::distance) {
            difference.nearest_a = nearest_of(*frame_a);
            difference.nearest_b = nearest_of(*frame_b);
            difference.rounding = std::max(frame_a->rounding, frame_b->rounding);
            difference.meshes_differ = result.meshes_differ;
        }
        std::optional<std::size_t> test;
        Outcomes outcomes_a, outcomes_b;
        if (result.nodes_comparable || result.pairs_comparable) {
            outcomes_a = outcomes_of(a, *frame_a);
            outcomes_b = outcomes_of(b, *frame_b);
        }
        if (result.nodes_comparable && a.engine && b.engine) {
            const QueryTrace renamed = with_stages_of(a, b, *frame_b);
            test = parting_test(*frame_a, outcomes_a, renamed, outcomes_of(b, renamed));
        } else if (result.nodes_comparable) {
            test = parting_test(*frame_a, outcomes_a, *frame_b, outcomes_b);
        }
        if (result.nodes_comparable) {
            if (test && !result.first)
                result.first =
                    Parting{frame_a->frame, *test, traced(a, *frame_a, outcomes_a, *test),
                            traced(b, *frame_b, outcomes_b, *test)};
        }
        if (result.pairs_comparable)
            compare_pairs({a, *frame_a, outcomes_a}, {b, *frame_b, outcomes_b}, difference, result);
        if (test || difference.poses_differ || difference.pairs_differ() ||
            difference.distances_differ() || difference.triangles_differ() ||
            difference.a != difference.b)
            result.frames.push_back(difference);
        frame_a = frames_a();
        frame_b = frames_b();
    }
    return result;
}

TraceDiff diff(const Trace& a, const Trace& b) {
    return diff(a.header, frames_of(a), b.header, frames_of(b));
}

}  // namespace scb
