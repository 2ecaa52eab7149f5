#pragma once

#include <string>

#include "app/reference/command_reference.h"

namespace scb::app {

/// One page of Markdown with every command and its options, without a version: the same description
/// gives the same bytes.
std::string markdown_page(const ReferenceCommand& program);

}  // namespace scb::app
