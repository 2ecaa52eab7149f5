#pragma once

#include "app/cli/console.h"
#include "app/explain/explain_options.h"

namespace scb::app {

/// Explains the pairs of --pairs, one after the other: text or JSON, and pictures if asked for.
/// Returns the exit status.
int explain_volumes(const ExplainOptions& options, const Console& console);

}  // namespace scb::app
