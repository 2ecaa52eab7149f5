#pragma once

#include <string>
#include <vector>

#include "scb/hierarchy.h"

namespace scb::app {

/// What of the options is not as by default: {"growth radius", "margin 0.1", "split by cost"}.
std::vector<std::string> build_parts(const BuildOptions& options);

/// The same to be added to a title: ", growth radius, split by cost"; nothing where all is as by
/// default.
std::string build_text(const BuildOptions& options);

/// As a sentence: "Hierarchies: growth radius, split by cost."; or nothing.
std::string build_sentence(const BuildOptions& options);

}  // namespace scb::app
