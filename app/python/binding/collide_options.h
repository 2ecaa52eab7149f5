#pragma once

#include <optional>
#include <string>

#include "app/python/binding/hierarchy.h"
#include "scb/collide.h"

namespace scb::python {

/// What a query is asked, as Python's arguments have it.
struct CollideArguments {
    std::string test;
    double threshold;
    std::string descent;
    std::optional<std::int64_t> max_pairs, stop_level;

    /// For these two. Throws InputError.
    CollideOptions options(const BuiltHierarchy& a, const BuiltHierarchy& b) const;
};

}  // namespace scb::python
