#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "core/traverse/step_numbers.h"

namespace scb {

/// A pair of nodes that waits for its division. Pairs with lesser keys come first.
template <class O, class Key>
struct KeyedPair {
    NodePair pair;
    Key key;
    [[no_unique_address]] StepNumber<O> step;

    /// By key, then by the nodes, so that the order is the same with every library.
    friend bool operator<(const KeyedPair& x, const KeyedPair& y) {
        return std::tie(x.key, x.pair.a, x.pair.b) < std::tie(y.key, y.pair.a, y.pair.b);
    }
};

// The two orders below hold items with operator<, such as KeyedPair.

/// Divides the pair first that was added last; of the pairs of a division, the least.
template <class Item>
class KeyedDepthFirst {
  public:
    bool empty() const { return pending_.empty(); }
    /// The pairs that follow are children of one pair.
    void begin_division() { first_child_ = pending_.size(); }
    void push(const Item& item) {
        pending_.push_back(item);
        for (std::size_t i = pending_.size() - 1; i > first_child_ && pending_[i - 1] < pending_[i];
             --i)
            std::swap(pending_[i - 1], pending_[i]);
    }
    Item pop() {
        const Item last = pending_.back();
        pending_.pop_back();
        return last;
    }
    /// The pair popped last needs no division.
    void skip() {}

  private:
    std::vector<Item> pending_;
    std::size_t first_child_ = 0;
};

/// Divides the least pair first, until `most` pairs wait; then each of them depth first.
template <class Item>
class LeastFirst {
  public:
    explicit LeastFirst(std::size_t most) : most_(most) {}

    bool empty() const { return !next_ && heap_.empty() && stack_.empty(); }
    void begin_division() { stack_.begin_division(); }
    void push(const Item& item) {
        if (heap_.size() + next_.has_value() >= most_) return stack_.push(item);
        if (!next_) {
            next_ = item;
        } else if (item < *next_) {
            add(*next_);
            next_ = item;
        } else {
            add(item);
        }
    }
    Item pop() {
        is_least_ = stack_.empty();
        if (!is_least_) return stack_.pop();
        if (next_ && (heap_.empty() || *next_ < heap_.front())) {
            const Item least = *next_;
            next_.reset();
            return least;
        }
        std::pop_heap(heap_.begin(), heap_.end(), follows);
        const Item least = heap_.back();
        heap_.pop_back();
        return least;
    }
    /// If the last popped pair was the least of all, no other pair needs a division.
    void skip() {
        if (!is_least_) return;
        next_.reset();
        heap_.clear();
    }

  private:
    // Not a function, which the heap would call through a pointer.
    static constexpr auto follows = [](const Item& x, const Item& y) { return y < x; };

    void add(const Item& item) {
        heap_.push_back(item);
        std::push_heap(heap_.begin(), heap_.end(), follows);
    }

    std::size_t most_;
    /// Often the next pair is a child of the pair before, and need not pass through the heap.
    std::optional<Item> next_;
    std::vector<Item> heap_;
    KeyedDepthFirst<Item> stack_;
    bool is_least_ = false;
};

/// The test of a pair that has a key: how it ended, and the key.
template <class Key>
struct KeyedTest {
    Stage stage;
    Key key;
};

/// traverse(), in the order of `pending`. Pairs of leaves wait for their turn as other pairs do.
/// The policy has the functions of traverse(), except that `test` returns a KeyedTest, and besides:
///
///     using Key = ...                     with a total order
///     bool is_open(key)                   whether a pair with this key is still to be divided; if
///                                         not, nor is a pair with a greater key
template <class Policy, class O, class Order>
void traverse_by_key(Policy& policy, O& observer, Order& pending) {
    StepNumbers<O> steps(observer);
    const auto visit = [&](const NodePair& pair, StepNumber<O> parent) {
        const auto tested = policy.test(pair);
        StepNumber<O> step{};
        if constexpr (observed<O>) step = steps.volume_test(pair, tested.stage, parent);
        if (tested.stage == Stage::overlapping) pending.push({pair, tested.key, step});
    };
    StepNumber<O> none{};
    if constexpr (observed<O>) none = no_step;
    for (std::optional<NodePair> root = policy.next_root(); root; root = policy.next_root()) {
        visit(*root, none);
        while (!pending.empty() && !policy.is_done()) {
            const auto next = pending.pop();
            if (!policy.is_open(next.key)) {
                pending.skip();
            } else if (policy.is_end(next.pair)) {
                policy.end(next.pair, ItemReport<O>{steps, next.step});
            } else {
                const std::array<NodePair, 2> children = policy.divide(next.pair);
                pending.begin_division();
                for (const NodePair& child : children) visit(child, next.step);
            }
        }
    }
}

}  // namespace scb
