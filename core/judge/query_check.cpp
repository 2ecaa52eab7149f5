#include "core/judge/query_check.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "core/geometry/triangle_distance.h"
#include "core/judge/division_check.h"
#include "core/judge/missed_pairs.h"
#include "core/judge/object_contacts.h"
#include "core/judge/self_pairs.h"
#include "core/judge/test_links.h"
#include "scb/triangle_overlap.h"

namespace scb {
namespace {

using Kind = EngineEvent::Kind;

bool has_items(const EngineQuery& query, IndexPair items) {
    const auto has = [](const EngineSide& side, std::uint32_t item) {
        return !side.mesh || item < side.mesh->triangles.size();
    };
    return has(query.sides[0], items.a) && has(query.sides[1], items.b);
}

/// Of items that there are.
bool are_finite(const EngineQuery& query, IndexPair items) {
    const auto finite = [](const EngineSide& side, std::uint32_t item) {
        return !side.mesh || has_finite_corners(*side.mesh, item);
    };
    return finite(query.sides[0], items.a) && finite(query.sides[1], items.b);
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
        const NodeVolume *a = volume_of_object(query.sides[0], items.a),
                         *b = volume_of_object(query.sides[1], items.b);
        // An object without a volume touches all, which claims nothing.
        const ContactCertificate found =
            a && b ? exact_verdict(*a, *b, b_to_a, query.tolerance) : ContactCertificate{};
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
    if (!have_meshes(query) || !has_items(query, items) || !are_finite(query, items))
        return std::nullopt;
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
        : query_(query), contacts_(contacts), links_(query) {
        if (!query.self || !have_meshes(query)) return;
        const Mesh& mesh = *query.sides[0].mesh;
        if (std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                        [](const Vec3& v) { return v.allFinite(); }))
            self_.emplace(mesh);
    }

    QueryJudgement judged() && {
        for (std::uint32_t i = 0; i < query_.events.size(); ++i) take(i);
        count_waste();
        if (query_.complete) result_.divisions = check_divisions(query_, result_.tests);
        // Without results there is nothing to compare.
        if (has_known_items(query_) && (query_.tells_pairs || query_.tells_items)) {
            if (query_.complete) find_missed();
            find_false();
        } else if (has_known_items(query_) && query_.complete) {
            result_.without_results = contacts_.size();
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
        item_tests_.try_emplace(pair_key(query_, event.a, event.b), ItemTest{i, led_by});
        item_parent_.push_back(led_by);
        if (have_meshes(query_) && !has_items(query_, items))
            result_.wrong_item_tests.push_back({i, led_by, 0, false, true});
        else if (const auto margin = error_of(query_, query_.b_to_a, event))
            result_.wrong_item_tests.push_back(
                {i, led_by, *margin, !result_.tests.empty() && !links_.tested_nodes_of(items)});
        else if (have_meshes(query_) && links_.strays(items))
            result_.stray_item_tests.push_back({i, led_by, 0, true});
        if (event.kind == Kind::items_meet) mark_above(led_by);
        if (event.kind == Kind::items_meet && !query_.tells_pairs) report(i, event);
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
        if (!reported_.insert(pair_key(query_, event.a, event.b)).second) {
            // Of a body against itself, a pair and the same the other way round are one.
            if (!query_.self || event.a == event.b ||
                !ordered_.insert(std::uint64_t{event.a} << 32 | event.b).second)
                twice_.push_back(i);
            return;
        }
        if (query_.self) ordered_.insert(std::uint64_t{event.a} << 32 | event.b);
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
        std::optional<MissedPairs> missed;
        for (const IndexPair contact : contacts_) {
            if (reported_.contains(pair_key(query_, contact.a, contact.b))) continue;
            if (looked == most_looked_into) {
                ++result_.not_looked_into;
                continue;
            }
            ++looked;
            if (contact_of(query_, query_.b_to_a, contact).grazing) {
                ++result_.grazing;
                continue;
            }
            if (!missed) missed.emplace(query_, result_.tests, item_tests_);
            result_.pairs.push_back(missed->cause_of(contact));
        }
        result_.exact = contacts_.size();
    }

    /// A broadphase may report objects by the boxes of its leaves, which are larger than theirs.
    bool leaves_meet(IndexPair items) const {
        if (!has_object_volumes(query_)) return false;
        const IndexPair leaves{query_.sides[0].shape->holder_of(items.a),
                               query_.sides[1].shape->holder_of(items.b)};
        return can_judge(query_, leaves) &&
               certificate_of(query_, query_.b_to_a, leaves).contact == Contact::overlapping;
    }

    void find_false() {
        for (const std::uint32_t i : order_) {
            const EngineEvent& event = query_.events[i];
            const IndexPair items{event.a, event.b};
            PairProblem problem{items, PairCause::unknown_item};
            problem.event = i;
            if (has_items(query_, items)) {
                if (!are_finite(query_, items)) {
                    ++result_.broken;
                    continue;
                }
                if (query_.self &&
                    (items.a == items.b || (self_ && self_->share_vertex(items.a, items.b)))) {
                    if (items.a != items.b &&
                        self_->may_meet_elsewhere(items.a, items.b, query_.triangle_tolerance))
                        continue;
                    problem.cause = PairCause::neighbours;
                    result_.pairs.push_back(problem);
                    continue;
                }
                const ItemContact contact = contact_of(query_, query_.b_to_a, items);
                if (contact.meet || leaves_meet(items)) continue;
                if (contact.grazing) {
                    ++result_.grazing;
                    continue;
                }
                const auto tested = item_tests_.find(pair_key(query_, items.a, items.b));
                problem.cause = PairCause::reported_untested;
                if (tested != item_tests_.end()) {
                    problem.event = tested->second.event;
                    problem.test = tested->second.test;
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
    std::optional<SelfPairs> self_;  ///< of triangles of a body against itself
    // By pair_key: lookups only.
    std::unordered_map<std::uint64_t, ItemTest> item_tests_;  ///< the first
    std::unordered_set<std::uint64_t> reported_;
    std::unordered_set<std::uint64_t> ordered_;  ///< of a body against itself: as reported
    std::vector<std::uint32_t> order_, twice_;   ///< reports
    /// Per test of items the test of volumes that led to it.
    std::vector<std::uint32_t> item_parent_;
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

bool has_finite_corners(const Mesh& mesh, std::uint32_t triangle) {
    const TriangleCorners of = corners(mesh, triangle);
    return std::all_of(of.begin(), of.end(), is_usable);
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
