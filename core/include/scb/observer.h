#pragma once

#include <compare>
#include <cstdint>

#include "scb/stage.h"

namespace scb {

/// Two triangles, or two nodes, by their indices in A and in B.
struct IndexPair {
    std::uint32_t a = 0,  ///< index in A
        b = 0;            ///< index in B
    /// By `a`, then by `b`.
    friend auto operator<=>(const IndexPair&, const IndexPair&) = default;
};

/// An observer is told of every test of a query, in order. `volume_test` gets the nodes, their
/// depths and the stage of a volume test. `triangle_test` follows the test of two leaves that
/// overlap; it gets the triangles and whether they intersect.
template <class O>
concept Observer = requires(O& observer, IndexPair pair, int depth, Stage stage, bool intersect) {
    observer.volume_test(pair, depth, depth, stage);
    observer.triangle_test(pair, intersect);
};

/// An observer of any type as three pointers, for a traversal that was compiled without it. Both
/// functions must be set.
struct ObserverCalls {
    /// What both functions get first.
    void* observer = nullptr;
    /// Is told of a test of two volumes.
    void (*volume_test)(void* observer, IndexPair nodes, int depth_a, int depth_b,
                        Stage stage) = nullptr;
    /// Is told of a test of two triangles.
    void (*triangle_test)(void* observer, IndexPair triangles, bool intersect) = nullptr;
};

/// The calls of this observer, which must live as long as they do.
template <Observer O>
ObserverCalls calls_of(O& observer) {
    return {&observer,
            [](void* self, IndexPair nodes, int depth_a, int depth_b, Stage stage) {
                static_cast<O*>(self)->volume_test(nodes, depth_a, depth_b, stage);
            },
            [](void* self, IndexPair triangles, bool intersect) {
                static_cast<O*>(self)->triangle_test(triangles, intersect);
            }};
}

}  // namespace scb
