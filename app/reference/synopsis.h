#pragma once

#include <string>

#include "app/reference/command_reference.h"

namespace scb::app {

/// How a word is set: in a face of a manual page, as code.
using Face = std::string (*)(const std::string& word);

/// "-o, --output DIR": `typed` sets words that are typed as they are, `value` those that stand for
/// something else.
std::string option_heading(const ReferenceOption& option, Face typed, Face value);

/// "scb collide [OPTION...] SCENE [SCENE]", set in the same way.
std::string synopsis(const ReferenceCommand& command, Face typed, Face value);

}  // namespace scb::app
