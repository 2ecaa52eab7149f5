#include "core/judge/query_check.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "core/geometry/triangle_distance.h"
#include "core/judge/division_check.h"
#include "core/judge/object_contacts.h"
#include "core/judge/test_links.h"
#include "scb/triangle_overlap.h"

namespace scb {
namespace {

using Kind = EngineEvent::Kind;

std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    return static_cast<std::uint64_t>(a) << 32 | b;
}

bool has_items(const EngineQuery& query, IndexPair items) {
    const auto has = [](const EngineSide& side, std::uint32_t item) {
        return !side.mesh || item < side.mesh->triangles.size();
    };
    return has(query.sides[0], items.a) && has(query.sides[1], items.b);
}

/// Two triangles of the query: whether they intersect, and whether that is within the tolerance.
struct ItemContact {
    bool meet = false, grazing = false;
    double margin = 0;  ///< gap or depth; of volumes, at least
};

/// In the frame of A.
std::array<TriangleCorners, 2> triangles_of(const EngineQuery& query, const Pose& b_to_a,
                                            IndexPair items) {
    return {corners(*query.sides[0].mesh, items.a),
            transform_corners(b_to_a, corners(*query.sides[1].mesh, items.b))};
}

ItemContact contact_of(const EngineQuery& query, const Pose& b_to_a, IndexPair items) {
    if (has_object_volumes(query)) {
        // That of the leaves' volumes, of which one touches nothing where it is not known.
        const auto volume_of = [](const EngineSide& side, std::uint32_t object) {
            const std::uint32_t node = side.shape->holder_of(object);
            return node == no_index ? NodeVolume{} : (*side.tree)[node].volume;
        };
        const ContactCertificate found =
            exact_verdict(volume_of(query.sides[0], items.a), volume_of(query.sides[1], items.b),
                          b_to_a, query.tolerance);
        return {found.contact == Contact::overlapping, found.contact == Contact::touching,
                found.margin};
    }
    const auto [a, b] = triangles_of(query, b_to_a, items);
    const bool meet = triangles_overlap(a, b);
    const double margin = meet ? triangle_depth(a, b) : triangle_gap(a, b);
    return {meet, margin <= query.triangle_tolerance, margin};
}

bool have_meshes(const EngineQuery& query) { return query.sides[0].mesh && query.sides[1].mesh; }

/// The gap or depth of two triangles whose test erred, and not just within the tolerance.
std::optional<double> error_of(const EngineQuery& query, const Pose& b_to_a,
                               const EngineEvent& event) {
    const IndexPair items{event.a, event.b};
    if (!have_meshes(query) || !has_items(query, items)) return std::nullopt;
    const auto [a, b] = triangles_of(query, b_to_a, items);
    if (triangles_overlap(a, b) == (event.kind == Kind::items_meet)) return std::nullopt;
    const ItemContact contact = contact_of(query, b_to_a, items);
    return contact.grazing ? std::nullopt : std::optional(contact.margin);
}

TestVerdict verdict_of(const ContactCertificate& certificate, std::uint8_t stage) {
    if (certificate.contact == Contact::disjoint)
        return stage == 0 ? TestVerdict::false_positive : TestVerdict::right;
    if (certificate.contact == Contact::overlapping)
        return stage == 0 ? TestVerdict::right : TestVerdict::wrong;
    return TestVerdict::right;
}

bool can_judge(const EngineQuery& query, IndexPair nodes) {
    return nodes.a != no_index && nodes.b != no_index &&
           has_volume((*query.sides[0].tree)[nodes.a].volume) &&
           has_volume((*query.sides[1].tree)[nodes.b].volume);
}

ContactCertificate certificate_of(const EngineQuery& query, const Pose& b_to_a, IndexPair nodes) {
    return exact_verdict((*query.sides[0].tree)[nodes.a].volume,
                         (*query.sides[1].tree)[nodes.b].volume, b_to_a, query.tolerance);
}

/// Of more pairs of a query that were not reported nobody asks why: each takes microseconds, and a
/// query that reports nothing misses millions.
constexpr std::size_t most_looked_into = 100'000;

class Judge {
  public:
    Judge(const EngineQuery& query, std::span<const IndexPair> contacts)
        : query_(query), contacts_(contacts), links_(query) {}

    QueryJudgement judged() && {
        for (std::uint32_t i = 0; i < query_.events.size(); ++i) take(i);
        count_waste();
        if (query_.complete) result_.divisions = check_divisions(query_, result_.tests);
        // Without results there is nothing to compare.
        if (has_known_items(query_) && !query_.self && (query_.tells_pairs || query_.tells_items)) {
            if (query_.complete) find_missed();
            find_false();
        }
        return std::move(result_);
    }

  private:
    void take(std::uint32_t i) {
        const EngineEvent& event = query_.events[i];
        switch (event.kind) {
            case Kind::volumes:
                return take_test(i, event);
            case Kind::items_apart:
            case Kind::items_meet:
                return take_items(i, event);
            case Kind::pair:
                // Where no tests of items are told, as of objects, nothing but this tells it.
                if (!have_meshes(query_) || !query_.tells_items)
                    mark_above(links_.led_to_items({event.a, event.b}));
                return report(i, event);
        }
    }

    void take_items(std::uint32_t i, const EngineEvent& event) {
        const IndexPair items{event.a, event.b};
        const std::uint32_t led_by = links_.led_to_items(items);
        ++result_.item_tests;
        item_tests_.try_emplace(key(event.a, event.b), item_parent_.size());
        item_event_.push_back(i);
        item_parent_.push_back(led_by);
        if (have_meshes(query_) && !has_items(query_, items))
            result_.wrong_item_tests.push_back({i, led_by, 0, false, true});
        else if (const auto margin = error_of(query_, query_.b_to_a, event))
            result_.wrong_item_tests.push_back(
                {i, led_by, *margin, !links_.tested_nodes_of(items)});
        else if (have_meshes(query_) && links_.strays(items))
            result_.stray_item_tests.push_back({i, led_by, 0, true});
        if (event.kind == Kind::items_meet) mark_above(led_by);
        if (event.kind == Kind::items_meet && !query_.tells_pairs) report(i, event);
    }

    /// A problem that a test of items is the cause of.
    void blame(PairProblem& problem, std::size_t item_test) const {
        problem.event = item_event_[item_test];
        problem.test = item_parent_[item_test];
    }

    /// There is a pair below this test.
    void mark_above(std::uint32_t test) {
        for (; test != no_index && !result_.tests[test].meets; test = result_.tests[test].parent)
            result_.tests[test].meets = true;
    }

    void take_test(std::uint32_t i, const EngineEvent& event) {
        JudgedTest test{i, nodes_of(query_, event)};
        if (can_judge(query_, test.nodes)) {
            const ContactCertificate found = certificate_of(query_, query_.b_to_a, test.nodes);
            test.verdict = verdict_of(found, event.stage);
            test.margin = found.margin;
        }
        const TestLinks::Link link = links_.take_volumes(test.nodes, event.stage == 0);
        test.parent = link.led_by;
        test.repeated = link.repeated;
        result_.tests.push_back(test);
    }

    void report(std::uint32_t i, const EngineEvent& event) {
        if (!reported_.try_emplace(key(event.a, event.b), i).second) return twice_.push_back(i);
        ++result_.reported;
        order_.push_back(i);
    }

    void count_waste() {
        // 1: below a pair that passed because of a weak test; 2: below one of loose volumes.
        std::vector<std::uint8_t> within(result_.tests.size(), 0);
        const auto of = [&](std::uint32_t led) -> std::uint8_t {
            if (led == no_index) return 0;
            const JudgedTest& test = result_.tests[led];
            if (test.verdict == TestVerdict::false_positive) return 1;
            if (within[led] != 0) return within[led];
            return test.meets ? 0 : 2;
        };
        const auto add = [&](std::uint8_t kind) {
            result_.wasted_weak += kind == 1;
            result_.wasted_loose += kind == 2;
        };
        for (std::size_t i = 0; i < result_.tests.size(); ++i)
            add(within[i] = of(result_.tests[i].parent));
        for (const std::uint32_t led : item_parent_) add(of(led));
    }

    void find_missed() {
        std::size_t looked = 0;
        for (const IndexPair contact : contacts_) {
            if (reported_.count(key(contact.a, contact.b)) > 0) continue;
            if (looked == most_looked_into) {
                ++result_.not_looked_into;
                continue;
            }
            ++looked;
            if (contact_of(query_, query_.b_to_a, contact).grazing)
                ++result_.grazing;
            else
                result_.pairs.push_back(cause_of(contact));
        }
        result_.exact = contacts_.size();
    }

    PairProblem cause_of(IndexPair items) const {
        PairProblem problem{items};
        const std::uint32_t leaves[2] = {query_.sides[0].shape->holder[items.a],
                                         query_.sides[1].shape->holder[items.b]};
        for (std::uint32_t side = 0; side < 2; ++side)
            if (leaves[side] == no_index) {
                problem.cause = PairCause::in_no_leaf;
                problem.side = side;
                return problem;
            }
        const NodeTree &tree_a = *query_.sides[0].tree, &tree_b = *query_.sides[1].tree;
        if (const auto tested = item_tests_.find(key(items.a, items.b));
            tested != item_tests_.end()) {
            blame(problem, tested->second);
            const bool meet = query_.events[problem.event].kind == Kind::items_meet;
            problem.cause = meet ? PairCause::not_reported : PairCause::items_apart;
            problem.nodes = {tree_a[leaves[0]].number, tree_b[leaves[1]].number};
            return problem;
        }
        // The first rejection on the way to the pair, else how far the query came.
        std::uint32_t rejected = no_index, deepest = no_index, most = 0;
        for (std::uint32_t a = leaves[0]; a != no_index; a = query_.sides[0].shape->parents[a])
            for (std::uint32_t b = leaves[1]; b != no_index;
                 b = query_.sides[1].shape->parents[b]) {
                const std::optional<std::uint32_t> found = links_.test_of({a, b});
                if (!found) continue;
                const JudgedTest& test = result_.tests[*found];
                const std::uint32_t depth =
                    query_.sides[0].shape->depths[a] + query_.sides[1].shape->depths[b];
                if (query_.events[test.event].stage != 0)
                    rejected = std::min(rejected, *found);
                else if (deepest == no_index || depth > most) {
                    deepest = *found;
                    most = depth;
                }
            }
        const std::uint32_t at = rejected != no_index ? rejected : deepest;
        if (at == no_index) {
            problem.cause = PairCause::never_tested;
            return problem;
        }
        const JudgedTest& test = result_.tests[at];
        problem.event = test.event;
        problem.test = at;
        problem.nodes = {tree_a[test.nodes.a].number, tree_b[test.nodes.b].number};
        if (rejected == no_index) {
            const bool leaf_pair = test.nodes.a == leaves[0] && test.nodes.b == leaves[1];
            problem.cause = leaf_pair ? PairCause::items_not_tested : PairCause::never_visited;
            problem.next = {next_number(0, test.nodes.a, leaves[0]),
                            next_number(1, test.nodes.b, leaves[1])};
            return problem;
        }
        problem.cause = PairCause::rejected;
        for (std::uint32_t side = 0; side < 2; ++side) {
            const std::uint32_t item = side == 0 ? items.a : items.b,
                                node = side == 0 ? test.nodes.a : test.nodes.b;
            const EngineSide& of = query_.sides[side];
            if (!of.mesh) continue;
            for (const Vec3& corner : corners(*of.mesh, item)) {
                const double amount = excess((*of.tree)[node].volume, corner);
                if (!(amount > query_.tolerance) || !(amount > problem.amount)) continue;
                problem.cause = PairCause::not_contained;
                problem.side = side;
                problem.amount = amount;
            }
        }
        return problem;
    }

    /// The number of the child of `node` that has `leaf` below it; no_index of the leaf itself.
    std::uint32_t next_number(std::size_t side, std::uint32_t node, std::uint32_t leaf) const {
        const EngineSide& of = query_.sides[side];
        std::uint32_t next = no_index;
        for (std::uint32_t i = leaf; i != node && i != no_index; i = of.shape->parents[i]) next = i;
        return next == no_index ? no_index : (*of.tree)[next].number;
    }

    void find_false() {
        for (const std::uint32_t i : order_) {
            const EngineEvent& event = query_.events[i];
            const IndexPair items{event.a, event.b};
            PairProblem problem{items, PairCause::unknown_item};
            problem.event = i;
            if (has_items(query_, items)) {
                const ItemContact contact = contact_of(query_, query_.b_to_a, items);
                if (contact.meet) continue;
                if (contact.grazing) {
                    ++result_.grazing;
                    continue;
                }
                const auto tested = item_tests_.find(key(items.a, items.b));
                problem.cause = PairCause::reported_untested;
                if (tested != item_tests_.end()) {
                    blame(problem, tested->second);
                    problem.cause = query_.events[problem.event].kind == Kind::items_meet
                                        ? PairCause::items_meet
                                        : PairCause::reported_in_spite;
                }
            }
            result_.pairs.push_back(problem);
        }
        for (const std::uint32_t i : twice_) {
            PairProblem problem{{query_.events[i].a, query_.events[i].b},
                                PairCause::reported_twice};
            problem.event = i;
            result_.pairs.push_back(problem);
        }
    }

    const EngineQuery& query_;
    std::span<const IndexPair> contacts_;
    QueryJudgement result_;
    TestLinks links_;
    // By items: lookups only.
    std::unordered_map<std::uint64_t, std::size_t> item_tests_;  ///< the first, as a place below
    std::unordered_map<std::uint64_t, std::uint32_t> reported_;
    std::vector<std::uint32_t> order_, twice_;  ///< reports
    /// Per test of items: the event, and the test of volumes that led to it.
    std::vector<std::uint32_t> item_event_, item_parent_;
};

}  // namespace

std::uint64_t QueryJudgement::count(TestVerdict verdict) const {
    return static_cast<std::uint64_t>(
        std::count_if(tests.begin(), tests.end(),
                      [&](const JudgedTest& test) { return test.verdict == verdict; }));
}

std::uint64_t QueryJudgement::repeated() const {
    return static_cast<std::uint64_t>(std::count_if(
        tests.begin(), tests.end(), [](const JudgedTest& test) { return test.repeated; }));
}

bool has_known_items(const EngineQuery& query) {
    return have_meshes(query) || has_object_volumes(query);
}

QueryJudgement judge_query(const EngineQuery& query, std::span<const IndexPair> contacts) {
    return Judge(query, contacts).judged();
}

PoseFit fit_of_pose(const EngineQuery& query, const Pose& b_to_a) {
    PoseFit fit;
    for (const EngineEvent& event : query.events) {
        if (event.kind == Kind::pair) continue;
        if (event.kind != Kind::volumes) {
            fit.wrong_items += error_of(query, b_to_a, event).has_value();
            continue;
        }
        const IndexPair nodes = nodes_of(query, event);
        if (!can_judge(query, nodes)) continue;
        const TestVerdict verdict = verdict_of(certificate_of(query, b_to_a, nodes), event.stage);
        fit.wrong += verdict == TestVerdict::wrong;
        fit.false_positive += verdict == TestVerdict::false_positive;
    }
    return fit;
}

}  // namespace scb
