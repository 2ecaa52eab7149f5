#pragma once

#include "core/base/enum_names.h"
#include "scb/any_collide.h"

namespace scb::app {

/// A deliberate error, with which `scb golden selftest` shows that a suite can fail. The program
/// applies it to inputs or results of the core library; the library does not know it.
enum class Mutation {
    none,
    drop_node,        ///< a node's volume is gone
    nudge_radius,     ///< a node's volume is wider by a thousandth of its radius
    flip_comparison,  ///< `symmetric` is Figure 8 as printed, which compares with the wrong radius
    swap_stages,  ///< rejections by A's slab are reported as rejections by B's slab, and vice versa
};

inline constexpr EnumNames<Mutation, 5> mutation_names = {"none", "drop-node", "nudge-radius",
                                                          "flip-comparison", "swap-stages"};

// Each applies the mutation, if it concerns that argument.
void mutate(Mutation mutation, AnyHierarchy& hierarchy);
void mutate(Mutation mutation, OverlapOptions& options);
void mutate(Mutation mutation, Collision& found, VolumeKind kind, const OverlapOptions& options);
void mutate(Mutation mutation, Steps& steps);

}  // namespace scb::app
