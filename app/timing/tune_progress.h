#pragma once

#include "app/cli/console.h"
#include "app/cli/interrupt.h"
#include "app/study/tune_run.h"

namespace scb::app {

/// Shows each part of the run as a bar, and ends the run if it is interrupted. Both arguments must
/// outlive the result.
TuneProgress tune_progress(const Console& console, const InterruptWatch& watch);

}  // namespace scb::app
