#include "core/collide/dual_traversal.h"

#if defined(SCB_OBSERVER_NEVER_CALLED) != defined(SCB_NO_CALLS)
#error "not the header that was asked for"
#endif

// The traversal of a query, compiled three times for observer_is_free: with SCB_OBSERVER
// NoObserver, the same with a header that never calls the observer, and with CountingObserver.
namespace scb {

struct CountingObserver {
    std::uint64_t volume_tests = 0, intersections = 0;
    void volume_test(const Step&) { ++volume_tests; }
    void item_test(const ItemStep& items) { intersections += items.hit; }
};

using Policy = CollidePolicy<DescentRule::radius, Scb, ScbTest<OverlapOptions{}.test>>;
template void traverse<DepthFirst, Policy>(Policy&, SCB_OBSERVER&);

}  // namespace scb
