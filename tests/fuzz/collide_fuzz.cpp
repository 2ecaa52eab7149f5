#include "scb/any_hierarchy.h"
#include "scb/any_packed.h"
#include "scb/collide.h"
#include "tests/core/collide/brute_force.h"
#include "tests/fuzz/fuzz_input.h"

using namespace scb;

namespace {

template <class All>
auto one_of(const All& all, fuzz::Numbers& numbers) {
    return all[numbers.below(static_cast<std::uint32_t>(all.size()))];
}

/// A variant of a query that must not miss a pair.
struct Way {
    std::uint32_t volume;
    bool is_packed;
    BuildOptions build;
    CollideOptions reference;
    PackedLayout layout;

    explicit Way(fuzz::Numbers& numbers)
        : volume(numbers.below(4)),
          is_packed(numbers.below(2) == 0),
          layout(one_of(all_packed_layouts(), numbers)) {
        layout.leaf_triangles = 1 + static_cast<int>(numbers.below(most_leaf_triangles));
        build.threads = 1;
        build.split = numbers.below(2) == 0 ? SplitMethod::section_3 : SplitMethod::cost;
        reference.overlap.test = one_of(all_overlap_tests(), numbers);
        if (!is_sound(reference.overlap.test)) reference.overlap.test = OverlapTest::symmetric;
    }
};

struct Bodies {
    Mesh a, b;
    Pose pose;
    std::vector<IndexPair> pairs;  ///< by brute force
};

template <Volume V>
void expect_packed(const Bodies& bodies, const Hierarchy<V>& a, const Hierarchy<V>& b,
                   const PackedLayout& layout) {
    try {
        check_packable(bodies.a, "a");
        check_packable(bodies.b, "b");
    } catch (const InputError&) {
        return;
    }
    const AnyPacked packed_a = pack_any(layout, a, bodies.a),
                    packed_b = pack_any(layout, b, bodies.b);
    fuzz::require(validate(packed_a, bodies.a).empty() && validate(packed_b, bodies.b).empty(),
                  "packed hierarchies are valid");
    fuzz::require(
        collide_packed(packed_a, bodies.a, packed_b, bodies.b, bodies.pose).pairs == bodies.pairs,
        "a packed query finds the pairs");
}

template <Volume V>
void expect_pairs(const Bodies& bodies, const Way& way) {
    const auto a = build_hierarchy<V>(bodies.a, way.build),
               b = build_hierarchy<V>(bodies.b, way.build);
    fuzz::require(validate(a, bodies.a).empty() && validate(b, bodies.b).empty(),
                  "hierarchies are valid");
    if constexpr (std::is_same_v<V, Scb> || std::is_same_v<V, Scb2>) {
        if (way.is_packed) return expect_packed(bodies, a, b, way.layout);
    }
    fuzz::require(
        collide<V>({a, bodies.a}, {b, bodies.b}, bodies.pose, way.reference).pairs == bodies.pairs,
        "a query finds the pairs");
}

}  // namespace

SCB_FUZZ(input) {
    fuzz::Numbers numbers(input);
    const Way way(numbers);
    Bodies bodies;
    bodies.pose = numbers.pose();
    bodies.a = numbers.mesh(12);
    bodies.b = numbers.mesh(12);
    try {
        check_mesh(bodies.a, "a");
        check_mesh(bodies.b, "b");
    } catch (const InputError&) {
        return;
    }
    bodies.pairs = brute_force(bodies.a, bodies.b, bodies.pose);
    if (way.volume == 0)
        expect_pairs<Ball>(bodies, way);
    else if (way.volume == 1)
        expect_pairs<Obb>(bodies, way);
    else if (way.volume == 2)
        expect_pairs<Scb2>(bodies, way);
    else
        expect_pairs<Scb>(bodies, way);
}
