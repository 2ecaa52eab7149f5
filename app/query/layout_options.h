#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "scb/packed_layout.h"

namespace scb::app {

/// "float2, float4, ...": the values of --layout except the reference.
std::string layout_names(const std::string& separator = ", ");

/// All values of --layout.
std::vector<std::string> layout_words();

/// The layouts in a list for --layout, with at most `leaf_triangles` triangles in a leaf; nullopt
/// is the reference. Throws InputError if a name is unknown or repeated, or if `leaf_triangles` is
/// not 1 to 4.
std::vector<std::optional<PackedLayout>> layouts_of(const std::string& list, int leaf_triangles);

/// --leaf, for layouts_of.
void add_leaf_option(const Command& command, int& leaf_triangles);

/// --threads, for check_threads.
void add_threads_option(const Command& command, int& threads, const std::string& description);

/// Throws InputError, naming --threads, if the number is not 1 to 256.
void check_threads(int threads);

}  // namespace scb::app
