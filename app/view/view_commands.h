#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/view/view_columns.h"
#include "app/view/view_page.h"

namespace scb::app {

/// The commands that draw the modes of a page without a browser, without the user's choices in the
/// page. A mode may need several commands. Empty for a scene that was given in memory.
std::map<std::string, std::vector<std::string>> view_commands(const ViewOptions& options,
                                                              const ViewSubject& subject);

/// The command that explains a test of the column, without frame and nodes; empty for another
/// engine's column.
std::string explain_command(const ViewOptions& options, const ViewColumn& column);

}  // namespace scb::app
