#include "app/study/frame_findings.h"

#include <nlohmann/json.hpp>

#include "app/study/proven_distance.h"

namespace scb {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(IndexPair, a, b)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Step, nodes, depth_a, depth_b, stage)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Work, volume_tests, triangle_tests, operations)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PassCounts, inner, leaves, touching, wrongly_rejected, missed,
                                   all, wasted_for)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WastedTests, by_reason)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DepthInspection, tests, wasted, passed)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Inspection, pairs, counts, depths)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(InspectedFrame, frame, found, distance, certified)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(VainTests, tests, parallel)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TestedTriangle, triangle, items, volumes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PassedPair, test, reason, leaves, within, exact, gap, below)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FalsePair, frame, pair, test, margin)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WrongRejection, test, missed, exact)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WronglyRejectedPair, frame, rejection, test)

}  // namespace scb

namespace scb::app {
namespace {

// The JSON library's macros know only this type.
using MacroJson = nlohmann::json;

/// Throws if a number is impossible for the frame's query: the file was edited.
class Checks {
  public:
    Checks(const QuerySource& source, int frame) : query_(source.query()), frame_(frame) {}

    void operator()(bool is_right) const {
        if (!is_right)
            throw MacroJson::other_error::create(501, "numbers of another query", nullptr);
    }
    void operator()(const FalsePair& pair) const {
        (*this)(pair.frame, pair.test);
        (*this)(static_cast<std::size_t>(pair.pair.reason) < pass_reason_count);
        (*this)(static_cast<std::size_t>(pair.pair.within) < pass_reason_count);
        (*this)(pair.pair.exact);
    }
    void operator()(const WronglyRejectedPair& pair) const {
        (*this)(pair.frame, pair.test);
        (*this)(pair.rejection.exact);
    }

  private:
    void operator()(int frame, const Step& test) const {
        (*this)(frame == frame_ && test.nodes.a < node_count(query_.a) &&
                test.nodes.b < node_count(query_.b) &&
                static_cast<std::size_t>(test.stage) < stage_count);
    }
    void operator()(Contact contact) const {
        (*this)(contact >= Contact::disjoint && contact <= Contact::touching);
    }

    std::size_t node_count(std::size_t body) const {
        return topology_of(query_.hierarchy(body)).nodes.size();
    }

    const SceneQuery& query_;
    int frame_;
};

}  // namespace

FrameFindings::FrameFindings(const TraceHeader& header, std::size_t top) : wrong(top) {
    for (const PassReason reason : waste_reasons(header.kind)) worst.emplace_back(reason, top);
    for (const OverlapOptions& other : alternative_tests(header))
        others.emplace_back().overlap = other;
}

void FrameFindings::add(const QuerySource& source, const QueryTrace& frame,
                        const Attribution& attribution) {
    frames.push_back({frame.frame, inspection(frame, attribution)});
    // Without results, tests are not attributed, but counted.
    Work& all = frames.back().found.counts.all;
    if (all.volume_tests == 0) all = {frame.found.n_v, frame.found.n_p, 0};
    if (frame.nearest) frames.back().distance = frame.nearest->distance;
    frames.back().certified = !source.is_recording() && is_certified(source.query(), frame);
    complete &= frame.found.complete;
    vain += vain_tests(*source.body(0, frame.frame).mesh, *source.body(1, frame.frame).mesh, frame);
    if (!source.header().engine || !source.header().engine->objects)
        for (std::size_t side = 0; side < 2; ++side)
            add_tests(
                tested[source.header().kind == QueryKind::self ? 0 : side],
                tested_triangles(frame.steps, source.body(side, frame.frame).tree->shape(), side));
    wrong.add(frame, attribution);
    for (WorstPairs& pairs : worst) pairs.add(frame, attribution);
    if (others.empty()) return;
    const SceneQuery& query = source.query();
    for (AlternativeTest& other : others)
        other.add(try_alternative_test(query.hierarchy(query.a), query.mesh(query.a),
                                       query.hierarchy(query.b), query.mesh(query.b),
                                       source.header(), frame, attribution, other.overlap));
}

FrameFindings& FrameFindings::operator+=(const FrameFindings& other) {
    frames.insert(frames.end(), other.frames.begin(), other.frames.end());
    complete &= other.complete;
    vain += other.vain;
    for (std::size_t side = 0; side < 2; ++side) add_tests(tested[side], other.tested[side]);
    wrong.add(other.wrong.pairs());
    for (std::size_t i = 0; i < worst.size(); ++i)
        worst[i].add(other.worst[i].outermost(), other.worst[i].parts());
    for (std::size_t i = 0; i < others.size(); ++i) others[i].add(other.others[i]);
    return *this;
}

nlohmann::ordered_json findings_json(const FrameFindings& findings) {
    MacroJson others = MacroJson::array();
    for (const AlternativeTest& other : findings.others)
        others.push_back({{"caught", other.caught}, {"pairs", other.pairs}, {"all", other.all}});
    MacroJson worst = MacroJson::array();
    for (const WorstPairs& pairs : findings.worst)
        worst.push_back({{"outermost", pairs.outermost()}, {"parts", pairs.parts()}});
    return MacroJson{{"frames", findings.frames},  {"complete", findings.complete},
                     {"vain", findings.vain},      {"tested", findings.tested},
                     {"worst", std::move(worst)},  {"wrong", findings.wrong.pairs()},
                     {"others", std::move(others)}};
}

FrameFindings findings_of_json(const nlohmann::ordered_json& json, const QuerySource& source,
                               int frame, std::size_t top) {
    const MacroJson of_frame = json;
    const Checks check(source, frame);
    FrameFindings findings(source.header(), top);
    of_frame.at("frames").get_to(findings.frames);
    check(findings.frames.size() == 1 && findings.frames[0].frame == frame);
    of_frame.at("complete").get_to(findings.complete);
    of_frame.at("vain").get_to(findings.vain);
    of_frame.at("tested").get_to(findings.tested);
    for (std::size_t side = 0; side < 2; ++side)
        for (const TestedTriangle& one : findings.tested[side])
            check(one.triangle < source.body(side, frame).mesh->triangles.size());
    const auto pairs_of = [&]<class P>(const MacroJson& in, const char* name,
                                       std::vector<P> pairs) {
        in.at(name).get_to(pairs);
        for (const P& pair : pairs) check(pair);
        return pairs;
    };
    const MacroJson& worst = of_frame.at("worst");
    check(worst.size() == findings.worst.size());
    for (std::size_t i = 0; i < worst.size(); ++i)
        findings.worst[i].add(pairs_of(worst[i], "outermost", std::vector<FalsePair>()),
                              pairs_of(worst[i], "parts", std::vector<FalsePair>()));
    findings.wrong.add(pairs_of(of_frame, "wrong", std::vector<WronglyRejectedPair>()));
    const MacroJson& others = of_frame.at("others");
    check(others.size() == findings.others.size());
    for (std::size_t i = 0; i < findings.others.size(); ++i) {
        others[i].at("caught").get_to(findings.others[i].caught);
        others[i].at("pairs").get_to(findings.others[i].pairs);
        others[i].at("all").get_to(findings.others[i].all);
    }
    return findings;
}

}  // namespace scb::app
