#pragma once

#include <optional>
#include <string>

#include "app/inspect/inspect_report.h"

namespace scb::app {

/// The judgement of a recording, as tables and sentences. `settings`: the work of this project's
/// hierarchies, if it was counted.
std::string recording_text(const InspectedRecording& recording,
                           const std::optional<InspectSettings>& settings);

}  // namespace scb::app
