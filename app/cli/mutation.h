#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "render/view/picture.h"
#include "scb/any_hierarchy.h"
#include "scb/overlap_options.h"

namespace scb {

/// An error put into the program on purpose, by which `scb golden selftest` proves that a suite can
/// fail. For the whole process, by the hidden option --mutation; there is none otherwise.
enum class Mutation {
    none,
    drop_node,        ///< a node's volume is gone
    nudge_radius,     ///< a node's volume is wider by a thousandth of its radius
    flip_comparison,  ///< the test `symmetric` compares B's ball with A's slab the wrong way round
    swap_stages,      ///< it tests B's slab before A's
    shift_color,      ///< volumes and meshes have one more of 255 in a channel
};

/// All but none.
std::span<const Mutation> all_mutations();
/// "drop-node", ...
std::string_view mutation_name(Mutation mutation);
std::optional<Mutation> mutation_of(std::string_view name);

/// Before anything else is done.
void set_mutation(Mutation mutation);

/// What the mutation makes of these; nothing where it is of something else.
void mutate(AnyHierarchy& hierarchy);
void mutate(OverlapOptions& options);
Picture mutated(Picture picture);

/// Whether mutated() does anything.
bool mutates_pictures();

}  // namespace scb
