#include "core/analysis/test_sizes.h"

namespace scb {

std::vector<std::uint32_t> test_sizes(const TestTree& tree) {
    std::vector<std::uint32_t> sizes(tree.parents.size(), 1);
    // Parents come before their children.
    for (std::size_t i = sizes.size(); i-- > 0;)
        if (tree.parents[i] != TestTree::no_parent) sizes[tree.parents[i]] += sizes[i];
    return sizes;
}

}  // namespace scb
