#include "scenes/recordings/distance_findings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/text_format.h"
#include "core/judge/tree_check.h"
#include "scenes/recordings/judgement_words.h"

namespace scb::scenes {
namespace {

/// Per test of volumes, the smallest distance that the query had measured before.
std::vector<double> distances_before(const EngineQuery& query) {
    std::vector<double> before;
    double least = query.limit;
    for (const EngineEvent& event : query.events) {
        if (event.kind == EngineEvent::Kind::volumes)
            before.push_back(least);
        else if (query.kind == QueryKind::distance && event.has_length)
            least = std::min(least, event.length);
    }
    return before;
}

/// The comparison of squares with plain lengths that explains why nodes were left out: each has a
/// bound below the distance then known. Empty: none does.
std::string comparison_words(const EngineQuery& query, const QueryJudgement& judged,
                             const std::vector<std::uint32_t>& tests) {
    const std::vector<double> before = distances_before(query);
    // The comparison must leave out the nodes that were left out, and no others.
    const auto all = [&](const auto& leaves_out) {
        const auto is_left_out = [&](std::uint32_t i) {
            return leaves_out(query.events[judged.tests[i].event].length, before[i]);
        };
        for (std::uint32_t i = 0; i < judged.tests.size(); ++i) {
            const EngineEvent& event = query.events[judged.tests[i].event];
            const bool is_divided = event.stage == 0 && !judged.tests[i].left_out;
            if (is_divided && event.has_length && is_left_out(i)) return false;
        }
        return std::all_of(tests.begin(), tests.end(), is_left_out);
    };
    const std::string known =
        query.kind == QueryKind::within ? "the tolerance" : "the distance that was known then";
    if (all([](double bound, double best) { return bound * bound >= best; }))
        return "; the square of each such bound is above " + known +
               ": is a square compared with a plain length?";
    if (all([](double bound, double best) { return bound >= best * best; }))
        return "; each such bound is above the square of " + known +
               ": is a plain length compared with a square?";
    return "; no test of nodes below them followed";
}

/// The bounds that are too large, and the nodes that were left out although they are nearer than
/// the answer.
void take_tests(const EngineQuery& query, const QueryJudgement& judged, const QueryName& name,
                TestFindings& tests) {
    const auto note = [&](std::uint32_t number, const std::string& what, const std::string& more) {
        const EngineEvent& event = query.events[judged.tests[number].event];
        const IndexPair nodes{event.a, event.b};
        // `scb explain` explains tests of overlap only.
        tests.add(what, {name,
                         pair_words("nodes", event.a, event.b) + test_words(number) + more,
                         nodes,
                         {no_index, no_index},
                         number,
                         false});
    };
    std::vector<bool> has_wrong_bound(judged.tests.size(), false);
    for (const WrongBound& wrong : judged.wrong_bounds) {
        has_wrong_bound[wrong.test] = true;
        const std::string bound = format(", bound %.6g", wrong.bound);
        if (std::isinf(wrong.excess))
            note(wrong.test, "a bound that is no number", bound);
        else
            note(wrong.test, "a bound that is larger than the distance of the volumes",
                 bound + ", too large by " + amount_words(wrong.excess) + " or more");
    }
    std::vector<std::uint32_t> below, unknown;
    for (std::uint32_t i = 0; i < judged.tests.size(); ++i) {
        if (judged.tests[i].verdict != TestVerdict::wrong || has_wrong_bound[i]) continue;
        (query.events[judged.tests[i].event].has_length ? below : unknown).push_back(i);
    }
    const std::string than = query.kind == QueryKind::within ? "the tolerance" : "the answer";
    const std::string why = below.empty() ? std::string() : comparison_words(query, judged, below);
    const auto nearer = [&](std::uint32_t i) {
        return ", nearer than " + than + " by " + amount_words(judged.tests[i].margin) + " or more";
    };
    for (const std::uint32_t i : below)
        note(i, "nodes were left out although their bound is below " + than,
             format(", bound %.6g", query.events[judged.tests[i].event].length) + nearer(i) + why);
    for (const std::uint32_t i : unknown)
        note(i, "nodes were left out although they are nearer than " + than, nearer(i));
}

}  // namespace

std::vector<IndexPair> reported_pairs(const EngineQuery& query) {
    const auto reports = query.has_pairs ? EngineEvent::Kind::pair : EngineEvent::Kind::items_meet;
    std::vector<IndexPair> pairs;
    for (const EngineEvent& event : query.events)
        if (event.kind == reports) pairs.push_back({event.a, event.b});
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

std::optional<double> DistanceFindings::before(const Bodies& bodies, int frame) const {
    const auto last = last_.find(bodies);
    if (last == last_.end() || last->second.first >= frame) return std::nullopt;
    return last->second.second;
}

void DistanceFindings::take(const EngineQuery& query, const Bodies& bodies, const QueryTruth& truth,
                            const QueryJudgement& judged, const QueryName& name,
                            TestFindings& tests) {
    ++queries_;
    ++states_[static_cast<std::size_t>(judged.answer)];
    take_tests(query, judged, name, tests);
    if (query.kind != QueryKind::distance) return;
    count_ += query.answer.has_value();
    if (truth.certified) last_[bodies] = {query.frame, truth.distance};
    for (const AnswerProblem& problem : judged.answer_problems)
        add_case(answers_, fault_words(problem.fault),
                 {name, words_of(problem), {no_index, no_index}, problem.items});
}

void DistanceFindings::list_not_judged(std::vector<NotJudged>& parts) const {
    const auto list = [&](AnswerState state, const char* why) {
        const std::uint64_t count = states_[static_cast<std::size_t>(state)];
        if (count > 0) parts.push_back({count, queries_, "queries of distances", why});
    };
    list(AnswerState::not_of_triangles, "they are of objects, or of a body to itself");
    list(AnswerState::not_recorded,
         "no distances were recorded; where none was found, the setting `results` with the value "
         "`pairs` says so");
    list(AnswerState::not_certified, "no certificate proves the distance of the bodies");
}

}  // namespace scb::scenes
