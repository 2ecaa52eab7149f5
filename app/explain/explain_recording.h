#pragma once

#include "app/cli/console.h"
#include "app/explain/explain_options.h"

namespace scb::app {

/// Explains the test of two nodes that another engine recorded, with the engine's own volumes: text
/// or JSON, and a picture if asked for. Returns the exit status. Throws InputError.
int explain_recording(const ExplainOptions& options, const Console& console);

}  // namespace scb::app
