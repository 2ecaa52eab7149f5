#include "scb/any_packed.h"

#include "scb/error.h"

namespace scb {

namespace {

// The result of `make` for the codec of the layout and of V.
template <class V, class Make>
AnyPacked of_codec(const PackedLayout& layout, const Make& make) {
    const bool floats = layout.numbers == PackedLayout::Numbers::floats;
    switch (layout.width) {
        case 2:
            return floats ? make.template operator()<FloatCodec<2, V>>()
                          : make.template operator()<QuantizedCodec<2, V>>();
        case 4:
            return floats ? make.template operator()<FloatCodec<4, V>>()
                          : make.template operator()<QuantizedCodec<4, V>>();
        case 8:
            return floats ? make.template operator()<FloatCodec<8, V>>()
                          : make.template operator()<QuantizedCodec<8, V>>();
        default:
            throw InputError("a packed layout has nodes of 2, 4 or 8 children.");
    }
}

[[noreturn]] void refuse_volumes(std::string_view name) {
    throw InputError(std::string(name) +
                     ": packed layouts have slab cut balls alone, with one slab or two.");
}

}  // namespace

bool can_pack(VolumeKind kind) { return kind == VolumeKind::scb || kind == VolumeKind::scb2; }

template <class V>
AnyPacked pack_any(const PackedLayout& layout, const Hierarchy<V>& hierarchy, const Mesh& mesh,
                   std::string_view name, int threads) {
    return of_codec<V>(layout, [&]<class Codec>() -> AnyPacked {
        return pack<Codec>(hierarchy, mesh, layout.leaf_triangles, layout.corners, name, threads);
    });
}

template AnyPacked pack_any(const PackedLayout&, const Hierarchy<Scb>&, const Mesh&,
                            std::string_view, int);
template AnyPacked pack_any(const PackedLayout&, const Hierarchy<Scb2>&, const Mesh&,
                            std::string_view, int);

AnyPacked pack_any(const PackedLayout& layout, const AnyHierarchy& hierarchy, const Mesh& mesh,
                   std::string_view name, int threads) {
    if (const auto* two_slabs = std::get_if<Hierarchy<Scb2>>(&hierarchy))
        return pack_any(layout, *two_slabs, mesh, name, threads);
    if (const auto* one_slab = std::get_if<Hierarchy<Scb>>(&hierarchy))
        return pack_any(layout, *one_slab, mesh, name, threads);
    refuse_volumes(name);
}

AnyPacked build_packed_any(const PackedLayout& layout, VolumeKind kind, const Mesh& mesh,
                           const BuildOptions& options, std::string_view name) {
    if (!can_pack(kind)) refuse_volumes(name);
    const auto built = [&]<class Codec>() -> AnyPacked {
        return build_packed<Codec>(mesh, options, layout.leaf_triangles, layout.corners, name);
    };
    return kind == VolumeKind::scb2 ? of_codec<Scb2>(layout, built) : of_codec<Scb>(layout, built);
}

namespace {

/// Calls `query` with the two sides.
template <class Query>
auto of_sides(const AnyPacked& a, const Mesh& mesh_a, const AnyPacked& b, const Mesh& mesh_b,
              const Query& query) {
    if (a.index() != b.index())
        throw InputError(
            "the two packed hierarchies have different layouts or volumes; pack both to one.");
    return std::visit(
        [&]<class Codec>(const PackedHierarchy<Codec>& of_a) {
            return query(PackedCollider<Codec>{of_a, mesh_a},
                         PackedCollider<Codec>{*std::get_if<PackedHierarchy<Codec>>(&b), mesh_b});
        },
        a);
}

}  // namespace

PackedCollision collide_packed(const AnyPacked& a, const Mesh& mesh_a, const AnyPacked& b,
                               const Mesh& mesh_b, const Pose& b_to_a, const PackedOptions& options,
                               PackedWorkspace* workspace, PackedFront* front) {
    return of_sides(a, mesh_a, b, mesh_b, [&](const auto& side_a, const auto& side_b) {
        return collide_packed(side_a, side_b, b_to_a, options, workspace, front);
    });
}

PackedCollision collide_packed(const AnyPacked& a, const Mesh& mesh_a, const AnyPacked& b,
                               const Mesh& mesh_b, const Pose& b_to_a, const PackedOptions& options,
                               const ObserverCalls& calls) {
    return of_sides(a, mesh_a, b, mesh_b, [&](const auto& side_a, const auto& side_b) {
        return collide_packed(side_a, side_b, b_to_a, options, calls);
    });
}

PackedTouch touches(const AnyPacked& a, const Mesh& mesh_a, const AnyPacked& b, const Mesh& mesh_b,
                    const Pose& b_to_a, const PackedOptions& options, PackedWorkspace* workspace,
                    PackedFront* front) {
    return of_sides(a, mesh_a, b, mesh_b, [&](const auto& side_a, const auto& side_b) {
        return touches(side_a, side_b, b_to_a, options, workspace, front);
    });
}

PackedDistance distance_packed(const AnyPacked& a, const Mesh& mesh_a, const AnyPacked& b,
                               const Mesh& mesh_b, const Pose& b_to_a,
                               const DistanceOptions& options, SimdLevel level) {
    return of_sides(a, mesh_a, b, mesh_b, [&](const auto& side_a, const auto& side_b) {
        return distance_packed(side_a, side_b, b_to_a, options, level);
    });
}

PackedWithin within_packed(const AnyPacked& a, const Mesh& mesh_a, const AnyPacked& b,
                           const Mesh& mesh_b, const Pose& b_to_a, double tolerance,
                           SimdLevel level) {
    return of_sides(a, mesh_a, b, mesh_b, [&](const auto& side_a, const auto& side_b) {
        return within_packed(side_a, side_b, b_to_a, tolerance, level);
    });
}

std::string validate(const AnyPacked& packed, const Mesh& mesh) {
    return std::visit([&](const auto& some) { return validate(some, mesh); }, packed);
}

std::size_t bytes_of(const AnyPacked& packed) {
    return std::visit([](const auto& some) { return some.bytes(); }, packed);
}

}  // namespace scb
