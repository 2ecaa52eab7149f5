#include "core/analysis/alternative_test.h"

#include "core/analysis/assumed_time.h"
#include "core/collide/query_placement.h"
#include "core/overlap/test_functors.h"

namespace scb {
namespace {

bool same(const OverlapOptions& x, const OverlapOptions& y) {
    return x.test == y.test && (!has_threshold(x.test) || x.threshold == y.threshold);
}

}  // namespace

void AlternativeTest::add(const AlternativeTest& other) {
    caught += other.caught;
    pairs += other.pairs;
    all += other.all;
}

std::vector<OverlapOptions> alternative_tests(const TraceHeader& header) {
    std::vector<OverlapOptions> tests;
    if (header.engine || header.volume != VolumeKind::scb) return tests;
    for (const double threshold : {0.5, 0.7, 0.9})
        tests.push_back({OverlapTest::corrected, threshold});
    tests.push_back({OverlapTest::symmetric, OverlapOptions{}.threshold});
    tests.push_back({OverlapTest::extents, OverlapOptions{}.threshold});
    std::erase_if(tests, [&](const OverlapOptions& o) { return same(o, header.options.overlap); });
    return tests;
}

AlternativeTest try_alternative_test(const AnyHierarchy& a, const Mesh& mesh_a,
                                     const AnyHierarchy& b, const Mesh& mesh_b,
                                     const TraceHeader& header, const QueryTrace& frame,
                                     const Attribution& attribution, const OverlapOptions& other) {
    AlternativeTest result;
    result.overlap = other;
    CollideOptions options = header.options;
    options.overlap = other;
    const Collision found = asked_again(a, mesh_a, b, mesh_b, header, frame, options);
    result.pairs = found.pairs.size();
    result.all = work_of(header.volume, other, options.descent, found);
    const auto* scbs_a = std::get_if<Hierarchy<Scb>>(&a);
    const auto* scbs_b = std::get_if<Hierarchy<Scb>>(&b);
    if (scbs_a == nullptr || scbs_b == nullptr) return result;
    const Placement placed = query_placement(*scbs_a, *scbs_b, frame.b_to_a);
    with_overlap_test<Scb>(other, [&](auto test) {
        for (const PassedPair& pair : attribution.passed) {
            if (pair.reason != PassReason::weak_test) continue;
            const IndexPair nodes = frame.steps.volumes[pair.test].nodes;
            result.caught += test(scbs_a->volumes[nodes.a], scbs_b->volumes[nodes.b], placed) !=
                             Stage::overlapping;
        }
    });
    return result;
}

}  // namespace scb
