#pragma once

#include <variant>

#include "scb/any_hierarchy.h"
#include "scb/error.h"

namespace scb {

/// Calls `use` with both hierarchies in their own type. Throws InputError if the types differ.
template <class Use>
auto with_both(const AnyHierarchy& a, const AnyHierarchy& b, Use&& use) {
    if (a.index() != b.index())
        throw InputError(
            "the two hierarchies have volumes of different types; build both with one.");
    return std::visit(
        [&]<class V>(const Hierarchy<V>& of_a) {
            return use(of_a, *std::get_if<Hierarchy<V>>(&b));
        },
        a);
}

}  // namespace scb
