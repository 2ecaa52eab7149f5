#include "app/inspect/judgement_json.h"

#include <nlohmann/json.hpp>

#include "app/query/recording_verdict.h"
#include "core/platform/utf8.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;
using scenes::FrameJudgement;
using scenes::ProblemGroup;
using scenes::RecordingJudgement;
using scenes::TreeJudgement;

const char* verdict_name(scenes::Verdict verdict) {
    return verdict == scenes::Verdict::valid   ? "valid"
           : verdict == scenes::Verdict::wrong ? "wrong"
                                               : "partly judged";
}

Json case_json(const scenes::ProblemCase& one) {
    Json json = {
        {"frame", one.query.frame}, {"bodies", {one.query.a, one.query.b}}, {"words", one.words}};
    if (!one.query.name.empty()) json["query"] = as_utf8(one.query.name);
    if (one.nodes.a != no_index) json["nodes"] = {one.nodes.a, one.nodes.b};
    if (one.items.a != no_index) json["triangles"] = {one.items.a, one.items.b};
    if (one.test != no_index) json["test"] = one.test;
    return json;
}

Json group_json(const ProblemGroup& group) {
    Json cases = Json::array();
    for (const scenes::ProblemCase& one : group.cases) cases.push_back(case_json(one));
    return {{"what", group.what}, {"count", group.count}, {"cases", std::move(cases)}};
}

Json groups_json(const std::vector<ProblemGroup>& groups) {
    Json json = Json::array();
    for (const ProblemGroup& group : groups) json.push_back(group_json(group));
    return json;
}

Json tree_json(const TreeJudgement& tree) {
    Json problems = Json::array();
    for (const WatchedProblem& watched : tree.problems) {
        Json problem = {{"what", watched.words}, {"since", watched.since}};
        if (watched.problem.node != no_index) problem["node"] = watched.problem.node;
        if (watched.problem.item != no_index) problem["triangle"] = watched.problem.item;
        if (watched.problem.amount > 0)
            problem.update({{"amount", watched.problem.amount},
                            {"worst_at", watched.worst_at},
                            {"since_amount", watched.since_amount},
                            {"told_at", watched.recorded_at},
                            {"stale", watched.stale},
                            {"inherited", watched.problem.inherited},
                            {"frames", watched.frames}});
        if (watched.links_at >= 0)
            problem.update({{"links_at", watched.links_at}, {"kept_from", watched.kept_from}});
        problems.push_back(std::move(problem));
    }
    Json of_tree = {{"tree", tree.number},
                    {"name", tree.name},
                    {"nodes", tree.nodes},
                    {"depth", tree.depth},
                    {"roots", tree.roots},
                    {"triangles_in_several_leaves", tree.in_several_leaves},
                    {"problems", std::move(problems)}};
    if (tree.fit)
        of_tree["fit"] = {{"what", tree.fit->what},
                          {"nodes", tree.fit->nodes},
                          {"of", tree.fit->of},
                          {"frame", tree.fit_at}};
    return of_tree;
}

}  // namespace

Json recording_json(const RecordingJudgement& judged, const std::string& file) {
    Json json = {{"recording", file},
                 {"engine", judged.engine},
                 {"verdict", verdict_name(judged.verdict())},
                 {"wrong", judged.wrong()}};
    json["not_judged"] = Json::array();
    for (const scenes::NotJudged& part : judged.not_judged)
        json["not_judged"].push_back(
            {{"count", part.count}, {"of", part.of}, {"what", part.what}, {"why", part.why}});
    json["costs"] = Json::array();
    for (const scenes::CostFinding& cost : judged.costs)
        json["costs"].push_back(cost_finding_words(cost));
    if (!judged.damage.empty()) json["damage"] = judged.damage;
    json["trees"] = Json::array();
    for (const TreeJudgement& tree : judged.trees) json["trees"].push_back(tree_json(tree));
    json["stages"] = Json::array();
    for (const auto& stage : judged.stages)
        json["stages"].push_back({{"name", stage.name},
                                  {"tests", stage.tests},
                                  {"false_positives", stage.false_positives},
                                  {"wrong", stage.wrong}});
    json["poses"] = Json::array();
    for (const auto& pose : judged.poses)
        json["poses"].push_back({{"frame", pose.query.frame},
                                 {"bodies", {pose.query.a, pose.query.b}},
                                 {"fits", pose.pose},
                                 {"only_volumes", pose.only_volumes},
                                 {"wrong_as_told", pose.told.all_wrong()}});
    json["test_problems"] = groups_json(judged.test_problems);
    json["missed"] = groups_json(judged.missed);
    json["false"] = groups_json(judged.false_pairs);
    json["wrong_distances"] = groups_json(judged.answers);
    json["wasted"] = {{"loose", judged.wasted.by(PassReason::loose_fit)},
                      {"weak", judged.wasted.by(PassReason::weak_test)},
                      {"early", judged.wasted.by(PassReason::early)},
                      {"not_judged", judged.wasted.by(PassReason::unjudged)}};
    json["unjudged"] = judged.unjudged;
    json["not_looked_into"] = judged.not_looked_into;
    json["ended_early"] = judged.ended_early;
    json["unjudged_results"] = judged.unknown_items;
    json["grazing"] = judged.grazing;
    json["frames"] = Json::array();
    for (const FrameJudgement& f : judged.frames) {
        Json frame = {{"frame", f.frame},
                      {"queries", f.queries},
                      {"volume_tests", f.volume_tests},
                      {"triangle_tests", f.item_tests},
                      {"wasted", f.wasted},
                      {"wrong", f.wrong},
                      {"missed", f.missed},
                      {"false_pairs", f.false_pairs},
                      {"pairs", f.pairs},
                      {"tolerance", f.tolerance.volumes},
                      {"triangle_tolerance", f.tolerance.triangles},
                      {"from_origin", f.tolerance.away}};
        if (!f.log.empty()) frame["log"] = f.log;
        json["frames"].push_back(std::move(frame));
    }
    json["stretches"] = judged.stretches;
    json["odd"] = judged.odd.first;
    for (const std::string& words : judged.unusable.first) json["odd"].push_back(words);
    json["notes"] = judged.notes;
    return json;
}

}  // namespace scb::app
