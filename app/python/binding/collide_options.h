#pragma once

#include <optional>
#include <string>

#include "app/python/binding/hierarchy.h"
#include "scb/collide.h"

namespace scb::python {

/// Parameters of a query, from Python's arguments.
struct CollideArguments {
    std::string test;
    double threshold;
    std::string descent;
    std::optional<std::int64_t> max_pairs, stop_level;

    /// The options for these two hierarchies. Throws InputError.
    CollideOptions options(const BuiltHierarchy& a, const BuiltHierarchy& b) const;
};

}  // namespace scb::python
