#pragma once

#include <string>

#include "app/reference/command_reference.h"

namespace scb::app {

/// "scb-render-levels"
std::string man_page_name(const ReferenceCommand& command);

/// The manual page of a command in the language man(7), without a date: the same description gives
/// the same bytes.
std::string man_page(const ReferenceCommand& command, const ReferenceCommand& program,
                     const std::string& version);

}  // namespace scb::app
