#pragma once

#include "app/cli/console.h"
#include "app/inspect/inspect_options.h"

namespace scb::app {

/// Judges the recording in the options; prints and draws the problems. Returns the exit status.
/// Throws InputError, OutputError.
int inspect_recording(InspectOptions& options, const Console& console);

}  // namespace scb::app
