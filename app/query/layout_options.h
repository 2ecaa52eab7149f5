#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "scb/packed_layout.h"

namespace scb::app {

/// "float2, float4, ...": what --layout knows besides the reference.
std::string layout_names(const std::string& separator = ", ");

/// All that --layout knows.
std::vector<std::string> layout_words();

/// Those of a list for --layout, with at most so many triangles in a leaf; nothing stands for the
/// reference. Throws InputError for a name that is unknown or
/// repeated, or another number than 1 to 4.
std::vector<std::optional<PackedLayout>> layouts_of(const std::string& list, int leaf_triangles);

/// --leaf, for layouts_of.
void add_leaf_option(const Command& command, int& leaf_triangles);

/// --threads, for check_threads.
void add_threads_option(const Command& command, int& threads, const std::string& description);

/// Throws InputError, naming --threads, where it is not 1 to 256.
void check_threads(int threads);

}  // namespace scb::app
