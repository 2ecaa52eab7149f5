#pragma once

#include <string_view>
#include <vector>

#include "scb/any_hierarchy.h"
#include "scb/overlap_options.h"

namespace scb::render {

/// The symbols in the formulas of a test beyond the paper's, in lines for a terminal.
std::vector<std::string_view> symbol_lines(VolumeKind kind, const OverlapOptions& options);

}  // namespace scb::render
