#include "core/judge/query_check.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "core/analysis/trace.h"
#include "core/base/parallel_for.h"
#include "core/judge/division_check.h"
#include "core/judge/item_contact.h"
#include "core/judge/left_out_tests.h"
#include "core/judge/missed_pairs.h"
#include "core/judge/query_contacts.h"
#include "core/judge/self_pairs.h"
#include "core/judge/test_links.h"

namespace scb {
namespace {

using Kind = EngineEvent::Kind;

/// The number of unreported pairs to examine. Each takes microseconds, and a query that reports
/// nothing misses millions.
constexpr std::size_t most_looked_into = 100'000;

/// The number of events whose certificates are found ahead: few, so that an interrupt need not
/// wait, and shared in blocks, since a certificate takes microseconds and more.
constexpr std::size_t events_at_once = 1 << 11, events_in_block = 128;

/// The distance below which nodes must not be left out. If the recorded answer is too small, that
/// is the fault, and not each test that follows from it.
double reach_of(const EngineQuery& query, const QueryTruth& truth) {
    if (query.kind == QueryKind::within) return query.limit;
    if (query.kind != QueryKind::distance) return 0;
    double least = std::min(truth.distance, query.limit);
    if (query.answer) least = std::min(least, query.answer->distance);
    least /= 1 + query.relative_error;
    return least >= 0 && std::isfinite(least) ? least : 0;
}

class Judge {
  public:
    Judge(const EngineQuery& query, const QueryTruth& truth, const std::function<bool()>& go_on)
        : query_(query),
          truth_(truth),
          contacts_(truth.pairs),
          go_on_(go_on),
          links_(query),
          reach_(reach_of(query, truth)),
          judges_left_out_(query.kind == QueryKind::collide ||
                           (have_meshes(query) && !query.self &&
                            (query.kind == QueryKind::within || reach_ > 0))),
          left_out_(left_out_tests(query)) {
        if (!query.self || !have_meshes(query)) return;
        const EngineSide& side = query.sides[0];
        self_.emplace(*side.mesh, side.rest ? *side.rest : *side.mesh);
    }

    QueryJudgement judged() && {
        for (std::uint32_t i = 0; i < query_.events.size(); ++i) {
            if (i % events_at_once == 0) find_certificates(i);
            take(i);
            if (is_interrupted(i)) return std::move(result_);
        }
        mark_nearest();
        count_waste();
        count_objects();
        if (query_.complete) result_.divisions = check_divisions(query_, result_.tests, reach_);
        if (query_.kind != QueryKind::collide && (!have_meshes(query_) || query_.self)) {
            result_.answer = AnswerState::not_of_triangles;
            return std::move(result_);
        }
        if (query_.kind == QueryKind::distance) {
            judge_answer();
            return std::move(result_);
        }
        // Without results there is nothing to compare.
        if (has_known_items(query_) && (query_.has_pairs || query_.has_item_tests)) {
            result_.exact = contacts_.size();
            if (query_.complete) find_missed();
            find_false();
        } else if (has_known_items(query_) && query_.complete) {
            result_.without_results = contacts_.size();
        }
        return std::move(result_);
    }

  private:
    bool is_interrupted(std::size_t done) {
        constexpr std::size_t every = 256;
        if ((done + 1) % every == 0 && go_on_ && !go_on_()) result_.interrupted = true;
        return result_.interrupted;
    }

    /// Finds the certificates of the tests of volumes among the next events, which take most of the
    /// time of a judgement, in all threads.
    void find_certificates(std::size_t first) {
        const std::size_t count = std::min(query_.events.size() - first, events_at_once);
        certificates_.assign(count, std::nullopt);
        of_bounds_.assign(query_.kind == QueryKind::collide ? 0 : count, std::nullopt);
        parallel_blocks(
            processor_count(), count,
            [&](std::size_t from, std::size_t end) {
                for (std::size_t i = from; i < end; ++i) {
                    const EngineEvent& event = query_.events[first + i];
                    if (event.kind == Kind::volumes) find_certificate(i, event);
                }
            },
            events_in_block);
    }

    /// The certificate of a test, and of its recorded bound if that may be wrong.
    void find_certificate(std::size_t i, const EngineEvent& event) {
        const IndexPair nodes = nodes_of(query_, event);
        certificates_[i] = certificate_of(query_, query_.b_to_a, nodes, reach_);
        if (!event.has_length || query_.kind == QueryKind::collide) return;
        const bool is_apart = certificates_[i] && certificates_[i]->contact == Contact::disjoint;
        // A bound up to the reach is right for volumes that are farther apart than the reach.
        if (!(event.length > 0) || std::isinf(event.length) || (event.length <= reach_ && is_apart))
            return;
        of_bounds_[i] = certificate_of(query_, query_.b_to_a, nodes, event.length);
    }

    /// Counts the objects that have neither an extent nor a leaf with a volume.
    void count_objects() {
        if (!has_object_volumes(query_)) return;
        for (const EngineSide& side : query_.sides)
            for (std::uint32_t object = 0; object < side.shape->holder.size(); ++object) {
                const NodeVolume* volume = volume_of_object(side, object);
                if (!volume) continue;
                ++result_.objects;
                result_.unknown_objects += !has_volume(*volume);
            }
    }

    void take(std::uint32_t i) {
        const EngineEvent& event = query_.events[i];
        switch (event.kind) {
            case Kind::volumes:
                return take_test(i, event);
            case Kind::items_apart:
            case Kind::items_meet:
                return take_items(i, event);
            case Kind::pair:
                // Without tests of triangles, only the reported pair shows that items below meet.
                if (!have_meshes(query_) || !query_.has_item_tests)
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
        if (!has_items(query_, items)) {
            result_.wrong_item_tests.push_back({i, led_by, 0, false, true});
        } else if (!are_neighbours(items)) {
            if (const auto margin = error_of(query_, query_.b_to_a, event))
                result_.wrong_item_tests.push_back(
                    {i, led_by, *margin, !result_.tests.empty() && !links_.tested_nodes_of(items)});
            else if (have_meshes(query_) && links_.strays(items) && !in_one_leaf(items))
                result_.stray_item_tests.push_back({i, led_by, 0, true});
        }
        if (event.kind == Kind::items_meet) mark_above(led_by);
        if (event.kind == Kind::items_meet && !query_.has_pairs) report(i, event);
    }

    /// Engines test the triangles of a leaf with each other, without a test of the leaf with
    /// itself.
    bool in_one_leaf(IndexPair items) const {
        if (!query_.self) return false;
        const std::vector<std::uint32_t> of_a = query_.sides[0].shape->holders_of(items.a),
                                         of_b = query_.sides[0].shape->holders_of(items.b);
        return std::any_of(of_a.begin(), of_a.end(), [&](std::uint32_t leaf) {
            return std::find(of_b.begin(), of_b.end(), leaf) != of_b.end();
        });
    }

    /// Triangles of one mesh that share a vertex are never a pair, regardless of their test.
    bool are_neighbours(IndexPair items) const {
        return self_ && self_->share_vertex(items.a, items.b);
    }

    /// Whether vertices are too close for the engine's numbers to tell apart, so that the engine
    /// may have joined them.
    bool may_be_neighbours(IndexPair items) const {
        const double unit = query_.single ? 0x1p-22 : 0x1p-51;
        return self_ && self_->may_share_vertex(
                            items.a, items.b,
                            std::max(query_.triangle_tolerance,
                                     unit * query_.sides[0].stretch * query_.sides[0].mesh_reach));
    }

    /// Marks a test, and the tests above it, since a pair was found below.
    void mark_above(std::uint32_t test) {
        for (; test != no_index && !result_.tests[test].meets; test = result_.tests[test].parent)
            result_.tests[test].meets = true;
    }

    void take_test(std::uint32_t i, const EngineEvent& event) {
        JudgedTest test{i, nodes_of(query_, event)};
        const std::optional<ContactCertificate>& found = certificates_[i % events_at_once];
        test.left_out = !left_out_.empty() && left_out_[result_.tests.size()];
        const bool passed = event.stage == 0 && !test.left_out;
        test.verdict = verdict_of(found, passed);
        if (!passed && !judges_left_out_) test.verdict = TestVerdict::right;
        if (found) test.margin = found->margin;
        test.early = query_.kind == QueryKind::distance && event.has_length &&
                     test.verdict == TestVerdict::false_positive && event.length > reach_;
        if (event.has_length && query_.kind != QueryKind::collide) take_bound(i, event.length);
        const TestLinks::Link link =
            links_.take_volumes(test.nodes, event.stage == 0, event.parent);
        test.parent = link.led_by;
        test.repeated = link.repeated;
        result_.tests.push_back(test);
    }

    /// Notes a bound that the distance of the volumes contradicts. An infinite bound says that the
    /// engine gave up, since the pair is too far away to matter.
    void take_bound(std::uint32_t event, double bound) {
        const auto number = static_cast<std::uint32_t>(result_.tests.size());
        if (std::isnan(bound)) {
            result_.wrong_bounds.push_back({number, bound, HUGE_VAL});
            return;
        }
        const std::optional<ContactCertificate>& found = of_bounds_[event % events_at_once];
        if (found && found->contact == Contact::overlapping)
            result_.wrong_bounds.push_back({number, bound, found->margin});
    }

    /// Judges the distance that the query found, and finds out why a nearer pair was missed.
    void judge_answer() {
        if (!query_.answer && !query_.has_answers)
            result_.answer = AnswerState::not_recorded;
        else if (!truth_.certified)
            result_.answer = AnswerState::not_certified;
        if (result_.answer != AnswerState::judged) return;
        result_.exact = 1;
        result_.reported = query_.answer.has_value();
        result_.answer_problems = check_answer(query_, truth_);
        const bool is_missed =
            std::any_of(result_.answer_problems.begin(), result_.answer_problems.end(),
                        [](const AnswerProblem& problem) {
                            return problem.cause == AnswerCause::unknown &&
                                   (problem.fault == AnswerFault::too_large ||
                                    problem.fault == AnswerFault::none);
                        });
        if (is_missed && query_.complete && truth_.closest)
            result_.pairs.push_back(
                MissedPairs(query_, result_.tests, item_tests_).cause_of(*truth_.closest));
    }

    void report(std::uint32_t i, const EngineEvent& event) {
        if (!reported_.insert(pair_key(query_, event.a, event.b)).second) {
            // In a self query, both orders of a pair are one pair.
            // A triangle in several leaves may be tested once per leaf.
            if (!query_.has_pairs) return;
            if (!query_.self || event.a == event.b ||
                !ordered_.insert(std::uint64_t{event.a} << 32 | event.b).second)
                twice_.push_back(i);
            return;
        }
        if (query_.self) ordered_.insert(std::uint64_t{event.a} << 32 | event.b);
        ++result_.reported;
        order_.push_back(i);
    }

    /// In a query of distances, marks the tests above all pairs that are as near as the closest: an
    /// engine finds one of them.
    void mark_nearest() {
        if (query_.kind != QueryKind::distance) return;
        for (const IndexPair pair : contacts_)
            if (links_.tested_nodes_of(pair)) mark_above(links_.led_to_items(pair));
    }

    void count_waste() {
        const auto own_reason = [this](const JudgedTest& test) {
            if (test.meets) return PassReason::triangles_meet;
            if (test.early) return PassReason::early;
            if (!test.is_proven(query_.kind)) return PassReason::unjudged;
            return test.verdict == TestVerdict::false_positive ? PassReason::weak_test
                                                               : PassReason::loose_fit;
        };
        std::vector<PassReason> within(result_.tests.size(), PassReason::triangles_meet);
        const auto below = [&](std::uint32_t led) {
            return led == no_index ? PassReason::triangles_meet
                                   : governing_reason(within[led], own_reason(result_.tests[led]));
        };
        for (std::size_t i = 0; i < result_.tests.size(); ++i)
            result_.wasted.add(within[i] = below(result_.tests[i].parent));
        for (const std::uint32_t led : item_parent_) result_.wasted.add(below(led));
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
            if (is_interrupted(looked)) return;
            // Overlapping extents do not prove that the test of two objects was wrong.
            if (has_object_volumes(query_))
                if (const auto tested = item_tests_.find(pair_key(query_, contact.a, contact.b));
                    tested != item_tests_.end() &&
                    query_.events[tested->second.event].kind == Kind::items_apart)
                    continue;
            const ItemContact exact = contact_of(query_, query_.b_to_a, contact);
            // object_contacts uses the tolerance of the largest volumes.
            if (has_object_volumes(query_) && !exact.meet && !exact.grazing) continue;
            if (is_hidden(contact) || exact.grazing) {
                ++result_.grazing;
                if (result_.grazing_missed++ == 0) result_.first_grazing = contact;
                continue;
            }
            if (!missed) missed.emplace(query_, result_.tests, item_tests_);
            result_.pairs.push_back(missed->cause_of(contact));
        }
    }

    /// Whether a triangle has no area and no leaf, or the engine may take the two for neighbours.
    bool is_hidden(IndexPair contact) const {
        if (!have_meshes(query_)) return false;
        const auto dropped = [](const EngineSide& side, std::uint32_t item) {
            return side.shape->size() > 0 && side.shape->holder_of(item) == no_index &&
                   has_no_area(*side.mesh, item);
        };
        return dropped(query_.sides[0], contact.a) || dropped(query_.sides[1], contact.b) ||
               may_be_neighbours(contact);
    }

    /// A broadphase may report objects by the boxes of their leaves, which exceed the objects.
    bool leaves_meet(IndexPair items) const {
        if (!has_object_volumes(query_)) return false;
        const IndexPair leaves{query_.sides[0].shape->holder_of(items.a),
                               query_.sides[1].shape->holder_of(items.b)};
        const auto found = certificate_of(query_, query_.b_to_a, leaves, reach_);
        return found && found->contact == Contact::overlapping;
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
                if (query_.self && (items.a == items.b || are_neighbours(items))) {
                    if (items.a != items.b &&
                        self_->may_meet_elsewhere(items.a, items.b, query_.triangle_tolerance))
                        continue;
                    problem.cause = PairCause::neighbours;
                    result_.pairs.push_back(problem);
                    continue;
                }
                const ItemContact contact = contact_of(query_, query_.b_to_a, items);
                if (contact.meet || leaves_meet(items)) continue;
                if (contact.grazing || may_be_neighbours(items)) {
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
    const QueryTruth& truth_;
    std::span<const IndexPair> contacts_;
    const std::function<bool()>& go_on_;
    QueryJudgement result_;
    TestLinks links_;
    const double reach_;  ///< see reach_of
    /// Whether nodes that were left out are judged. Once triangles meet, no nodes can be nearer. Of
    /// objects and of one body, the distance is not known.
    const bool judges_left_out_;
    const std::vector<bool> left_out_;  ///< per test of volumes, see left_out_tests; or empty
    /// See find_certificates: of tests of volumes, and of their recorded bounds.
    std::vector<std::optional<ContactCertificate>> certificates_, of_bounds_;
    std::optional<SelfPairs> self_;  ///< set in a self query of triangles
    // By pair_key: lookups only.
    std::unordered_map<std::uint64_t, ItemTest> item_tests_;  ///< the first test of each pair
    std::unordered_set<std::uint64_t> reported_;
    std::unordered_set<std::uint64_t> ordered_;  ///< in a self query: as reported
    std::vector<std::uint32_t> order_, twice_;   ///< events: first reports, repeated reports
    /// Per test of items, the test of volumes that led to it.
    std::vector<std::uint32_t> item_parent_;
};

}  // namespace

bool JudgedTest::is_proven(QueryKind kind) const {
    return verdict != TestVerdict::unjudged && (margin > 0 || !is_of_distance(kind));
}

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

QueryJudgement judge_query(const EngineQuery& query, const QueryTruth& truth,
                           const std::function<bool()>& go_on) {
    return Judge(query, truth, go_on).judged();
}

}  // namespace scb
