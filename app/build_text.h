#pragma once

#include <string>

#include "core/build_options.h"

namespace scb {

/// What of the options is not as by default, to be added to a title: ", growth radius, margin 0.1,
/// split by cost"; nothing where all is.
std::string build_text(const BuildOptions& options);

}  // namespace scb
