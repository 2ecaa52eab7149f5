#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/traverse/step_numbers.h"

namespace scb {

/// A pair of nodes whose volumes overlap, to be divided.
template <class O>
struct Pending {
    NodePair pair;
    [[no_unique_address]] StepNumber<O> step;
};

/// Divides the pair first that was added last. Each division leaves at most one pair behind on the
/// way down, so the stack is at most as long as both depths together.
template <class O>
class DepthFirst {
  public:
    DepthFirst() { pending_.reserve(256); }

    bool empty() const { return pending_.empty(); }
    void push(const Pending<O>& pair) { pending_.push_back(pair); }
    Pending<O> pop() {
        const Pending<O> last = pending_.back();
        pending_.pop_back();
        return last;
    }

  private:
    std::vector<Pending<O>> pending_;
};

/// Traverses pairs of nodes as the policy decides, and passes each test to the observer. A policy
/// has:
///
///     optional<NodePair> next_root()      a pair that no other pair leads to; nothing: no more
///     Stage test(pair)                    tests the volumes of a pair
///     bool is_end(pair)                   whether a pair that overlaps is not divided
///     void end(pair, report)              tests the items of such a pair, and calls
///                                         report(items, hit, neighbors) for each test
///     array<NodePair, 2> divide(pair)     the children of a pair, in their order
///     bool is_done()                      whether the query ends before all pairs are divided
template <template <class> class Order = DepthFirst, class Policy, class O>
void traverse(Policy& policy, O& observer) {
    Order<O> pending;
    // The steps are an argument, since a capture would be stored even without an observer.
    const auto visit = [&](StepsArgument<O> steps, const NodePair& pair, StepNumber<O> parent) {
        const Stage stage = policy.test(pair);
        StepNumber<O> step{};
        if constexpr (observed<O>) step = steps.volume_test(pair, stage, parent);
        if (stage != Stage::overlapping) return;
        if (!policy.is_end(pair)) return pending.push({pair, step});
        policy.end(pair, ItemReport<O>{steps, step});
    };
    StepNumbers<O> steps(observer);
    StepNumber<O> none{};
    if constexpr (observed<O>) none = no_step;
    for (std::optional<NodePair> root = policy.next_root(); root; root = policy.next_root()) {
        visit(steps, *root, none);
        while (!pending.empty() && !policy.is_done()) {
            const Pending<O> next = pending.pop();
            const std::array<NodePair, 2> children = policy.divide(next.pair);
            visit(steps, children[0], next.step);
            if (!policy.is_done()) visit(steps, children[1], next.step);
        }
    }
}

}  // namespace scb
