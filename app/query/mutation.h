#pragma once

#include "core/base/enum_names.h"
#include "scb/any_collide.h"

namespace scb::app {

/// An error on purpose. With it `scb golden selftest` shows that a suite can fail. The program
/// makes it, from what the core library takes or returns; the library knows nothing of it.
enum class Mutation {
    none,
    drop_node,        ///< a node's volume is gone
    nudge_radius,     ///< a node's volume is wider by a thousandth of its radius
    flip_comparison,  ///< for `symmetric`, Figure 8 as printed, which compares with the wrong
                      ///< radius
    swap_stages,      ///< rejections by A's slab are said to be by B's slab, and the reverse
};

inline constexpr EnumNames<Mutation, 5> mutation_names = {"none", "drop-node", "nudge-radius",
                                                          "flip-comparison", "swap-stages"};

// What the mutation makes of each; nothing where it is one of something else.
void mutate(Mutation mutation, AnyHierarchy& hierarchy);
void mutate(Mutation mutation, OverlapOptions& options);
void mutate(Mutation mutation, Collision& found, VolumeKind kind, const OverlapOptions& options);
void mutate(Mutation mutation, Steps& steps);

}  // namespace scb::app
