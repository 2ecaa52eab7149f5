#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/analysis/trace.h"

namespace scb::app {

/// Unusual settings that two queries, or one and itself, have in common, for subtitles. `common`:
/// whether both have the same value of a field of fields_of.
std::vector<std::string> settings_in_common(const TraceHeader& header, const TraceHeader& other,
                                            const std::function<bool(const char*)>& common);

}  // namespace scb::app
