#pragma once

#include <filesystem>
#include <functional>

#include "app/cli/console.h"
#include "app/golden/options.h"
#include "golden/compare/result.h"

namespace scb::app {

/// Writes a page of `scb view` into that folder for each case whose traces are kept there, as long
/// as `go_on` says so. A case whose page cannot be made, as where its scene cannot be opened from
/// here, has none. Throws OutputError.
void add_views(golden::SuiteResult& result, const std::filesystem::path& folder,
               const GoldenOptions& options, const Console& console,
               const std::function<bool()>& go_on);

}  // namespace scb::app
