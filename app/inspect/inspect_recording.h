#pragma once

#include "app/cli/console.h"
#include "app/inspect/inspect_options.h"

namespace scb::app {

/// Judges the recording that the scene names, and prints, and draws, what is wrong. Returns the
/// exit status. Throws InputError, OutputError.
int inspect_recording(InspectOptions& options, const Console& console);

}  // namespace scb::app
