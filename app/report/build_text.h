#pragma once

#include <string>
#include <vector>

#include "scb/hierarchy.h"

namespace scb::app {

/// The options that differ from the default: {"growth radius", "margin 0.1", "split by cost"}.
std::vector<std::string> build_parts(const BuildOptions& options);

/// The same for the end of a title: ", growth radius, split by cost"; empty if all are the default.
std::string build_text(const BuildOptions& options);

/// The same as a sentence: "Hierarchies: growth radius, split by cost."; or empty.
std::string build_sentence(const BuildOptions& options);

}  // namespace scb::app
