#pragma once

#include <filesystem>
#include <functional>

#include "app/cli/console.h"
#include "app/golden/options.h"
#include "golden/compare/result.h"

namespace scb::app {

/// Writes a page of `scb view` into the folder for each case whose traces are kept there, while
/// `go_on` is true. A case has no page if it cannot be made, for example because its scene cannot
/// be opened from here. Throws OutputError.
void add_views(golden::SuiteResult& result, const std::filesystem::path& folder,
               const GoldenOptions& options, const Console& console,
               const std::function<bool()>& go_on);

}  // namespace scb::app
