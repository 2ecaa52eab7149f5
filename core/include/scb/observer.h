#pragma once

#include <concepts>
#include <type_traits>

#include "core/collide/collision.h"

namespace scb {

/// An observer is told of every test of a query, in order. It is called with the nodes, their
/// depths and the stage of each volume test, and after it, where both nodes are leaves that
/// overlap, with the triangles and whether they intersect.
struct NoObserver {
    void volume_test(IndexPair, int, int, Stage) {}
    void triangle_test(IndexPair, bool) {}
};

namespace detail {

/// Whether there is anybody to tell: calls that do nothing still change how a compiler orders its
/// instructions.
template <class Observer>
inline constexpr bool observed = !std::same_as<Observer, NoObserver>;

/// How an observer is handed on. NoObserver goes by value, which takes no instruction.
template <class Observer>
using Told = std::conditional_t<observed<Observer>, Observer&, NoObserver>;

}  // namespace detail
}  // namespace scb
