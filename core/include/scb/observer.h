#pragma once

#include "scb/step.h"

namespace scb {

/// An observer receives every test of a query, in order: `volume_test` each test of two volumes,
/// `item_test` each test of two triangles, after the step that led to it.
template <class O>
concept Observer = requires(O& observer, const Step& step, const ItemStep& items) {
    observer.volume_test(step);
    observer.item_test(items);
};

/// An observer of any type as three pointers, for a traversal that was compiled without it. Both
/// functions must be set.
struct ObserverCalls {
    /// First argument of both functions.
    void* observer = nullptr;
    /// Receives a test of two volumes.
    void (*volume_test)(void* observer, const Step& step) = nullptr;
    /// Receives a test of two triangles.
    void (*item_test)(void* observer, const ItemStep& items) = nullptr;
};

/// The calls of this observer, which must live as long as they do.
template <Observer O>
ObserverCalls calls_of(O& observer) {
    return {
        &observer,
        [](void* self, const Step& step) { static_cast<O*>(self)->volume_test(step); },
        [](void* self, const ItemStep& items) { static_cast<O*>(self)->item_test(items); },
    };
}

}  // namespace scb
