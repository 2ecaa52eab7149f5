#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/view/view_columns.h"
#include "app/view/view_page.h"

namespace scb::app {

/// The commands that draw the modes of a page without a browser, but for what is chosen there; of a
/// mode that needs several there are several. None of a scene that was given in memory.
std::map<std::string, std::vector<std::string>> view_commands(const ViewOptions& options,
                                                              const ViewSubject& subject);

/// The command that explains a test of the column, but for frame and nodes; empty of another
/// engine's.
std::string explain_command(const ViewOptions& options, const ViewColumn& column);

}  // namespace scb::app
