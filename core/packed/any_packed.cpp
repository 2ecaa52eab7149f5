#include "scb/any_packed.h"

#include "scb/error.h"

namespace scb {

namespace {

// What `make` returns for the codec of the layout.
template <class Make>
AnyPacked of_codec(const PackedLayout& layout, const Make& make) {
    const bool floats = layout.numbers == PackedLayout::Numbers::floats;
    switch (layout.width) {
        case 2:
            return floats ? make.template operator()<FloatCodec<2>>()
                          : make.template operator()<QuantizedCodec<2>>();
        case 4:
            return floats ? make.template operator()<FloatCodec<4>>()
                          : make.template operator()<QuantizedCodec<4>>();
        case 8:
            return floats ? make.template operator()<FloatCodec<8>>()
                          : make.template operator()<QuantizedCodec<8>>();
        default:
            throw InputError("a packed layout has nodes of 2, 4 or 8 children.");
    }
}

}  // namespace

AnyPacked pack_any(const PackedLayout& layout, const Hierarchy<Scb>& hierarchy, const Mesh& mesh,
                   std::string_view name, int threads) {
    return of_codec(layout, [&]<class Codec>() -> AnyPacked {
        return pack<Codec>(hierarchy, mesh, layout.leaf_triangles, layout.corners, name, threads);
    });
}

AnyPacked build_packed_any(const PackedLayout& layout, const Mesh& mesh,
                           const BuildOptions& options, std::string_view name) {
    return of_codec(layout, [&]<class Codec>() -> AnyPacked {
        return build_packed<Codec>(mesh, options, layout.leaf_triangles, layout.corners, name);
    });
}

PackedCollision collide_packed(const AnyPacked& a, const Mesh& mesh_a, const AnyPacked& b,
                               const Mesh& mesh_b, const Pose& b_to_a, const PackedOptions& options,
                               PackedWorkspace* workspace, PackedFront* front) {
    if (a.index() != b.index())
        throw InputError("the two packed hierarchies have different layouts; pack both to one.");
    return std::visit(
        [&]<class Codec>(const PackedHierarchy<Codec>& of_a) {
            return collide_packed<Codec>({of_a, mesh_a},
                                         {*std::get_if<PackedHierarchy<Codec>>(&b), mesh_b}, b_to_a,
                                         options, workspace, front);
        },
        a);
}

std::string validate(const AnyPacked& packed, const Mesh& mesh) {
    return std::visit([&](const auto& some) { return validate(some, mesh); }, packed);
}

std::size_t bytes_of(const AnyPacked& packed) {
    return std::visit([](const auto& some) { return some.bytes(); }, packed);
}

}  // namespace scb
