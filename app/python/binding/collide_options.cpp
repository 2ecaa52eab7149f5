#include "app/python/binding/collide_options.h"

#include <algorithm>

#include "app/python/binding/source.h"

namespace scb::python {

CollideOptions CollideArguments::options(const BuiltHierarchy& a, const BuiltHierarchy& b) const {
    if (a.kind != b.kind)
        refuse("a and b", "their volumes are " + std::string(volume_kind_name(a.kind)) + " and " +
                              std::string(volume_kind_name(b.kind)) + "; build both of one kind.");
    CollideOptions options = query_options(test, threshold, descent).collide();
    query_limits(max_pairs, stop_level)
        .apply(options, stop_level ? std::max(a.depth(), b.depth()) : 0);
    return options;
}

}  // namespace scb::python
