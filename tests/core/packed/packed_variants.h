#pragma once

#include <string>
#include <variant>
#include <vector>

#include "scb/any_packed.h"
#include "tests/core/hierarchy/built_mesh.h"

namespace scb {

/// A layout as a type for tests of all of them.
template <class Codec_>
struct LayoutOf {
    using Codec = Codec_;
};

/// Calls `each` with a LayoutOf for every layout, and its name.
template <class Each>
void for_each_layout(Each each) {
    each(LayoutOf<FloatCodec<2>>(), "float, 2 wide");
    each(LayoutOf<FloatCodec<4>>(), "float, 4 wide");
    each(LayoutOf<FloatCodec<8>>(), "float, 8 wide");
    each(LayoutOf<QuantizedCodec<2>>(), "quantized, 2 wide");
    each(LayoutOf<QuantizedCodec<4>>(), "quantized, 4 wide");
    each(LayoutOf<QuantizedCodec<8>>(), "quantized, 8 wide");
}

/// The reference hierarchy of slab cut balls.
inline const Hierarchy<Scb>& scb_of(const BuiltMesh& built) {
    for (const AnyHierarchy& hierarchy : built.hierarchies)
        if (const auto* scb = std::get_if<Hierarchy<Scb>>(&hierarchy)) return *scb;
    std::abort();
}

}  // namespace scb
