#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "scb/observer.h"

namespace scb {

/// Two nodes, and their depths.
struct NodePair {
    std::uint32_t a, b;
    int depth_a, depth_b;
};

/// No observer; its calls compile away.
struct NoObserver {};

/// Whether O is an observer. Calls that do nothing still change how a compiler orders instructions,
/// so without an observer there are no calls.
template <class O>
inline constexpr bool observed = !std::same_as<O, NoObserver>;

/// Calls an observer through its pointers.
struct CalledObserver {
    const ObserverCalls& calls;

    void volume_test(const Step& step) { calls.volume_test(calls.observer, step); }
    void item_test(const ItemStep& items) { calls.item_test(calls.observer, items); }
};

/// Passes the tests of one query to an observer, as numbered steps. Throws std::length_error if a
/// number or a depth does not fit into a step.
template <class O>
class StepNumbers {
  public:
    explicit StepNumbers(O& observer) : observer_(observer) {}

    /// Returns the number of the step.
    std::uint32_t volume_test(const NodePair& pair, Stage stage, std::uint32_t parent) {
        if ((pair.depth_a | pair.depth_b) > deepest || next_ == no_step) [[unlikely]]
            fail();
        observer_.volume_test(Step{{pair.a, pair.b},
                                   static_cast<std::uint16_t>(pair.depth_a),
                                   static_cast<std::uint16_t>(pair.depth_b),
                                   stage,
                                   parent});
        return next_++;
    }
    void item_test(const ItemStep& items) { observer_.item_test(items); }

  private:
    static constexpr int deepest = std::numeric_limits<std::uint16_t>::max();
    [[noreturn, gnu::cold, gnu::noinline]] static void fail() {
        throw std::length_error("a query too deep or too long to be observed");
    }

    O& observer_;
    std::uint32_t next_ = 0;
};

/// Empty without an observer.
template <>
class StepNumbers<NoObserver> {
  public:
    explicit StepNumbers(NoObserver&) {}
};

/// An argument of the traversal. Without an observer it goes by value, which takes no instruction.
template <class O>
using StepsArgument = std::conditional_t<observed<O>, StepNumbers<O>&, StepNumbers<NoObserver>>;

/// The number of a step; empty without an observer.
template <class O>
using StepNumber = std::conditional_t<observed<O>, std::uint32_t, NoObserver>;

/// Passes the item tests of a step to an observer.
template <class O>
struct ItemReport {
    StepNumbers<O>& steps;
    std::uint32_t step;

    void operator()(IndexPair items, bool hit, bool neighbors) const {
        steps.item_test({items, step, hit, neighbors});
    }
};

/// Does nothing without an observer.
template <>
struct ItemReport<NoObserver> {
    ItemReport() = default;
    ItemReport(StepNumbers<NoObserver>, NoObserver) {}

    void operator()(IndexPair, bool, bool) const {}
};

}  // namespace scb
