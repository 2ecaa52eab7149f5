#include <algorithm>

#include "scb/triangle_overlap.h"
#include "tests/fuzz/fuzz_input.h"

using namespace scb;

// The answer knows no order of corners, no order of triangles, and no scale.
SCB_FUZZ(input) {
    fuzz::Numbers numbers(input);
    TriangleCorners a, b;
    for (Vec3& corner : a) corner = numbers.point();
    for (Vec3& corner : b) corner = numbers.below(4) == 0 ? a[numbers.below(3)] : numbers.point();
    const bool overlap = triangles_overlap(a, b);
    std::array<int, 3> order_a = {0, 1, 2};
    do {
        std::array<int, 3> order_b = {0, 1, 2};
        do {
            TriangleCorners turned_a, turned_b;
            for (std::size_t i = 0; i < 3; ++i) {
                turned_a[i] = a[static_cast<std::size_t>(order_a[i])];
                turned_b[i] = b[static_cast<std::size_t>(order_b[i])];
            }
            fuzz::require(triangles_overlap(turned_a, turned_b) == overlap, "corners in any order");
            fuzz::require(triangles_overlap(turned_b, turned_a) == overlap, "in both orders");
        } while (std::next_permutation(order_b.begin(), order_b.end()));
    } while (std::next_permutation(order_a.begin(), order_a.end()));
    for (const int exponent : {-200, -20, 20, 200}) {
        const double scale = std::ldexp(1.0, exponent);
        TriangleCorners scaled_a = a, scaled_b = b;
        bool exact = true;  // not where a coordinate is too small for it
        for (TriangleCorners* t : {&scaled_a, &scaled_b})
            for (Vec3& corner : *t) {
                const Vec3 before = corner;
                corner *= scale;
                exact = exact && corner / scale == before;
            }
        fuzz::require(!exact || triangles_overlap(scaled_a, scaled_b) == overlap, "at any scale");
    }
}
