#include "scb/packed_collide.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <optional>
#include <utility>

#include "core/base/parallel_for.h"
#include "core/collide/index_pairs.h"
#include "core/packed/each_codec.h"
#include "core/packed/grown_slab.h"
#include "core/packed/packed_query.h"
#include "core/packed/packed_steps.h"
#include "core/packed/query_sides.h"

namespace scb {

namespace {

/// The memory of one thread.
struct Work {
    PackedLists lists;
    OpenPairs open;
    PackedFindings found;
    RefPairs batch;                  ///< of first_pair: pairs of leaves to test
    std::vector<IndexPair> waiting;  ///< of first_pair: pairs of triangles to decide

    /// Also clears the remains of a query that ran out of memory.
    void clear() {
        lists.clear();
        open.count = 0;
        found.clear();
        batch.clear();
        waiting.clear();
    }
};

/// A query, independent of the types of its hierarchies.
struct AnyQuery {
    AnyPackedQuery nodes;
    LeafQuery leaves;
    const Mesh &a, &b;
    const Pose& b_to_a;
    SimdLevel level;
    PackedSteps* steps = nullptr;  ///< null without an observer
};

/// The number of pairs that all threads have found, and its limit.
struct PairLimit {
    std::size_t most;
    std::atomic<std::size_t> found{0};

    bool is_passed() const { return found.load(std::memory_order_relaxed) > most; }
};

void decide_undecided(const AnyQuery& query, PackedFindings& found) {
    found.n_exact += found.undecided.size();
    decide_in_doubles(query.a, query.b, query.b_to_a, query.level, found);
    found.n_after_doubles += found.undecided.size();
    for (const IndexPair& pair : found.undecided)
        if (triangles_meet(query.a, query.b, query.b_to_a, pair)) found.pairs.push_back(pair);
    found.undecided.clear();
}

/// Traverses the pairs of the lists, and decides every pair of triangles. Ends early if there are
/// too many pairs.
void finish(const AnyQuery& query, Work& work, PairLimit& limit) {
    // Pairs are counted, and undecided pairs are stored, only this many at a time: all might be too
    // many.
    constexpr std::size_t many = 4096;
    auto& [lists, open, found, batch, waiting] = work;
    std::size_t counted = 0;
    const auto count = [&, &pairs = found.pairs] {
        limit.found.fetch_add(pairs.size() - counted, std::memory_order_relaxed);
        counted = pairs.size();
    };
    while (!lists.empty() && !limit.is_passed()) {
        if (query.steps == nullptr)
            divide_nodes(query.nodes, query.level, {}, lists, found);
        else
            divide_nodes(query.nodes, *query.steps, lists, found);
        test_leaves(query.leaves, query.level, lists.leaf_leaf, open, found);
        if (found.undecided.size() >= many) decide_undecided(query, found);
        if (found.pairs.size() >= counted + many) count();
    }
    decide_open(query.leaves, query.level, open, found);
    decide_undecided(query, found);
    count();
}

/// Decides undecided pairs, a few at a time in sorted order, until some intersect.
void decide_first(const AnyQuery& query, Work& work) {
    constexpr std::size_t few = 8;
    std::vector<IndexPair>& undecided = work.found.undecided;
    std::sort(undecided.begin(), undecided.end());
    work.waiting.swap(undecided);
    for (std::size_t i = 0; i < work.waiting.size() && work.found.pairs.empty(); i += few) {
        const auto first = work.waiting.begin() + static_cast<std::ptrdiff_t>(i);
        undecided.assign(
            first, first + static_cast<std::ptrdiff_t>(std::min(few, work.waiting.size() - i)));
        decide_undecided(query, work.found);
    }
    undecided.clear();
}

/// Traverses the pairs of the lists up to the first triangles that intersect. The traversal goes
/// straight to the nearest leaves: where bodies overlap, their triangles often intersect. Then
/// batches are small, so that little work is done beyond the first pair, and grow, so that a query
/// without a pair takes little longer than one for all pairs. Of several pairs of a batch, the
/// first counts in sorted order.
std::optional<IndexPair> first_pair(const AnyQuery& query, Work& work) {
    constexpr PackedPace least{.nodes = 2, .leaves = 1, .nearest = 16}, most{};
    auto& [lists, open, found, batch, waiting] = work;
    for (PackedPace pace = least; !lists.empty();
         pace = {.nodes = std::min(2 * pace.nodes, most.nodes),
                .leaves = std::min(2 * pace.leaves, most.leaves)}) {
        divide_nodes(query.nodes, query.level, pace, lists, found);
        batch.move_last(lists.leaf_leaf, pace.leaves);  // a front may have many
        test_leaves(query.leaves, query.level, batch, open, found);
        decide_open(query.leaves, query.level, open, found);
        if (found.pairs.empty()) decide_first(query, work);
        if (!found.pairs.empty()) return *std::min_element(found.pairs.begin(), found.pairs.end());
    }
    return std::nullopt;
}

/// The share of `list` that is chunk `i` of `count`.
void append_share(RefPairs& to, const RefPairs& list, std::size_t i, std::size_t count) {
    const std::size_t first = list.size() * i / count, end = list.size() * (i + 1) / count;
    to.append(list, first, end - first);
}

/// Divides the lists of `work` among threads if they are long enough, and gathers the results,
/// which do not depend on the order.
void finish_in_threads(const AnyQuery& query, Work& work, std::vector<Work>& chunks, int threads,
                       PairLimit& limit) {
    // A chunk has enough pairs of nodes for some ten microseconds. There are enough chunks that
    // threads end at about the same time.
    constexpr std::size_t pairs_of_chunk = 32, chunks_of_thread = 8;
    const std::size_t most = chunks_of_thread * static_cast<std::size_t>(threads);
    while (work.lists.inner_size() != 0 && work.lists.size() < pairs_of_chunk * most)
        divide_once(query.nodes, query.level, work.lists, work.found);
    const std::size_t count = work.lists.size() / pairs_of_chunk;
    if (count < 2) return finish(query, work, limit);
    chunks.resize(std::max(chunks.size(), std::min(count, most)));
    const std::size_t used = std::min(count, most);
    parallel_for(threads, used, [&](std::size_t i) {
        Work& chunk = chunks[i];
        chunk.clear();
        append_share(chunk.lists.inner_inner, work.lists.inner_inner, i, used);
        append_share(chunk.lists.inner_leaf, work.lists.inner_leaf, i, used);
        append_share(chunk.lists.leaf_inner, work.lists.leaf_inner, i, used);
        append_share(chunk.lists.leaf_leaf, work.lists.leaf_leaf, i, used);
        finish(query, chunk, limit);
    });
    work.lists.clear();
    for (std::size_t i = 0; i < used; ++i) work.found.add(chunks[i].found);
}

void run(const AnyQuery& query, Work& work, std::vector<Work>& chunks, int threads,
         PairLimit& limit) {
    if (threads > 1)
        finish_in_threads(query, work, chunks, threads, limit);
    else
        finish(query, work, limit);
}

/// A query, which makes a front if the skin is more than 0.
template <class Codec>
AnyQuery query_of(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                  const Placement& placed, SimdLevel level, float skin) {
    // Pairs of nodes that are small relative to the skin are kept undivided. If divided further, so
    // many pairs that are apart would be kept that testing them again is cheaper.
    constexpr float skins_of_kept = 8;
    return {PackedQuery<Codec>{&a.hierarchy, &b.hierarchy, &placed, skin, skins_of_kept * skin},
            {leaves_of(a), leaves_of(b), &placed, skin},
            a.mesh,
            b.mesh,
            placed.b_to_a,
            level};
}

template <class Codec>
Ball root_ball(const PackedHierarchy<Codec>& hierarchy) {
    const PackedRef root = hierarchy.root;
    const auto own = root.is_leaf() ? hierarchy.leaf(root).template own<typename Codec::Decoded>()
                                    : hierarchy.nodes[root.index()].own;
    // Volumes contain their points up to the rounding of doubles.
    return {center(own), static_cast<double>(own.r) * (1 + 0x1p-40)};
}

/// The number of volume tests of a query of bodies that are far apart: the first step, in which all
/// children of a root are rejected. No value if the bodies may be near each other, or if both roots
/// are leaves.
template <class Codec>
std::optional<std::uint64_t> volume_tests_if_far(const PackedCollider<Codec>& a,
                                                 const PackedCollider<Codec>& b,
                                                 const Pose& b_to_a) {
    const PackedRef i = a.hierarchy.root, j = b.hierarchy.root;
    if (i.is_leaf() && j.is_leaf()) return std::nullopt;
    const Ball ball_a = root_ball(a.hierarchy), ball_b = root_ball(b.hierarchy);
    const PackedNode<Codec>& divided =
        j.is_leaf() ? a.hierarchy.nodes[i.index()] : b.hierarchy.nodes[j.index()];
    const double radii =
        static_cast<double>(divided.reach) + (j.is_leaf() ? ball_b.radius : ball_a.radius);
    const Vec3 between = transform_point(b_to_a, ball_b.center) - ball_a.center;
    // The second term is more than the margin of the kernel in floats, which is at most 2.3e-5 of
    // these lengths and of the reach of the other root, some 1.5 of its radii. The third is for a
    // pose that is rigid to 1e-9. Squares of lengths beyond `most` overflow in floats.
    constexpr double most = 1e17;
    const double near =
        1.0001 * radii + 1e-4 * between.lpNorm<1>() +
        1e-7 * (a.hierarchy.reach + b.hierarchy.reach + b_to_a.translation.lpNorm<1>());
    const double squared = squared_norm(between);
    if (squared > near * near && squared < most * most) return divided.count;
    return std::nullopt;
}

/// The result of the work. `room`: memory to sort with.
PackedCollision result_of(PackedFindings& found, const PairLimit& limit, bool sorted,
                          std::vector<IndexPair>& room) {
    const bool complete = !limit.is_passed();
    if (!complete) found.pairs.clear();
    if (sorted) sort_pairs(found.pairs, room);
    return {found.pairs, found.n_v, found.n_p, found.n_exact, found.n_after_doubles, complete};
}

}  // namespace

struct PackedWorkspace::Parts {
    Work work;
    std::vector<Work> chunks;  // one per thread
    std::vector<IndexPair> room;
};

PackedWorkspace::PackedWorkspace() : parts_(std::make_unique<Parts>()) {}
PackedWorkspace::~PackedWorkspace() = default;
PackedWorkspace::PackedWorkspace(PackedWorkspace&&) noexcept = default;
PackedWorkspace& PackedWorkspace::operator=(PackedWorkspace&&) noexcept = default;

namespace {

/// Fills the lists with the pairs at which a query begins: the front's, if it is valid, or the
/// roots. Makes a front first if that is due.
template <class Codec>
void begin(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b, const Placement& placed,
           const PackedOptions& options, PackedWorkspace::Parts& memory, PackedFront* front) {
    auto& [work, chunks, room] = memory;
    const Pose& b_to_a = placed.b_to_a;
    bool from_front = false;
    if (front != nullptr) {
        auto& [schedule, pairs, met] = front->parts();
        const FrontBodies bodies = {root_ball(a.hierarchy), root_ball(b.hierarchy),
                                    a.hierarchy.leaf_radius + b.hierarchy.leaf_radius};
        if (const auto plan = schedule.next(bodies, b_to_a, placed.margin)) {
            try {
                const Placement there = placement_of(a, b, plan->b_to_a);
                work.lists.add(a.hierarchy.root, b.hierarchy.root);
                PairLimit none{PackedOptions{}.give_up_after};
                run(query_of(a, b, there, options.level, float_above(plan->skin)), work, chunks,
                    options.threads, none);
            } catch (...) {
                front->clear();  // it would have pairs of another pose
                throw;
            }
            std::swap(pairs, work.found.kept);
            work.found.kept.clear();
        }
        from_front = schedule.is_good();
        if (from_front) work.lists.append(pairs);
    }
    if (!from_front) work.lists.add(a.hierarchy.root, b.hierarchy.root);
}

}  // namespace

template <class Codec>
PackedCollision collide_packed(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                               const Pose& b_to_a, const PackedOptions& options,
                               PackedWorkspace* workspace, PackedFront* front) {
    assert(options.threads >= 1 && "somebody has to do it");
    if (front == nullptr)
        if (const auto tests = volume_tests_if_far(a, b, b_to_a))
            return {.pairs = {}, .n_v = *tests};
    if (workspace == nullptr) {
        PackedWorkspace own;
        return collide_packed(a, b, b_to_a, options, &own, front);
    }
    auto& [work, chunks, room] = workspace->parts();
    work.clear();
    const Placement placed = placement_of(a, b, b_to_a);
    begin(a, b, placed, options, workspace->parts(), front);
    PairLimit limit{options.give_up_after};
    run(query_of(a, b, placed, options.level, 0), work, chunks, options.threads, limit);
    return result_of(work.found, limit, options.sorted, room);
}

template <class Codec>
PackedTouch touches(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                    const Pose& b_to_a, const PackedOptions& options, PackedWorkspace* workspace,
                    PackedFront* front) {
    if (front == nullptr)
        if (const auto tests = volume_tests_if_far(a, b, b_to_a))
            return {.pair = {}, .n_v = *tests};
    if (workspace == nullptr) {
        PackedWorkspace own;
        return touches(a, b, b_to_a, options, &own, front);
    }
    std::optional<IndexPair>* const met = front == nullptr ? nullptr : &front->parts().met;
    PackedTouch result;
    if (met != nullptr && *met) {
        ++result.n_p;
        ++result.n_exact;
        if (triangles_meet(a.mesh, b.mesh, b_to_a, **met)) {
            ++front->parts().schedule.used;
            result.pair = *met;
            return result;
        }
    }
    PackedOptions alone = options;
    alone.threads = 1;
    Work& work = workspace->parts().work;
    work.clear();
    const Placement placed = placement_of(a, b, b_to_a);
    // A front has all pairs that are near. While bodies meet, making it costs more than it saves.
    begin(a, b, placed, alone, workspace->parts(), met != nullptr && *met ? nullptr : front);
    result.pair = first_pair(query_of(a, b, placed, options.level, 0), work);
    if (met != nullptr) *met = result.pair;
    result.n_v = work.found.n_v;
    result.n_p += work.found.n_p;
    result.n_exact += work.found.n_exact;
    return result;
}

template <class Codec>
PackedCollision collide_packed(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                               const Pose& b_to_a, const PackedOptions& options,
                               const ObserverCalls& calls) {
    const Placement placed = placement_of(a, b, b_to_a);
    AnyQuery query = query_of(a, b, placed, options.level, 0);
    CalledObserver observer{calls};
    PackedSteps steps(observer, query.leaves, a.mesh, b.mesh);
    query.steps = &steps;
    steps.begin({a.hierarchy.root, b.hierarchy.root});
    Work work;
    work.lists.add(a.hierarchy.root, b.hierarchy.root);
    PairLimit limit{options.give_up_after};
    finish(query, work, limit);
    std::vector<IndexPair> room;
    return result_of(work.found, limit, options.sorted, room);
}

#define SCB_COLLIDE(...)                                                                           \
    template PackedCollision collide_packed(const PackedCollider<__VA_ARGS__>&,                    \
                                            const PackedCollider<__VA_ARGS__>&, const Pose&,       \
                                            const PackedOptions&, PackedWorkspace*, PackedFront*); \
    template PackedCollision collide_packed(const PackedCollider<__VA_ARGS__>&,                    \
                                            const PackedCollider<__VA_ARGS__>&, const Pose&,       \
                                            const PackedOptions&, const ObserverCalls&);           \
    template PackedTouch touches(const PackedCollider<__VA_ARGS__>&,                               \
                                 const PackedCollider<__VA_ARGS__>&, const Pose&,                  \
                                 const PackedOptions&, PackedWorkspace*, PackedFront*);
SCB_FOR_EACH_CODEC(SCB_COLLIDE)
#undef SCB_COLLIDE

}  // namespace scb
