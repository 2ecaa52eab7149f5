#pragma once

#include <string_view>
#include <vector>

#include "scb/any_hierarchy.h"
#include "scb/overlap_options.h"

namespace scb::render {

/// What the formulas of a test have beyond the paper's symbols, in lines for a terminal.
std::vector<std::string_view> symbol_lines(VolumeKind kind, const OverlapOptions& options);

}  // namespace scb::render
