#pragma once

#include <kainjow/mustache.hpp>

#include "app/inspect/inspect_report.h"

namespace scb::app {

/// A value of a template: true or false.
kainjow::mustache::data flag(bool is_set);

/// The work of a query, and its change from other work.
void set_changes(kainjow::mustache::data& row, const Work& from, const Work& to);

/// The part "What would have helped" of the page, for queries of overlap and of distances.
void set_settings(kainjow::mustache::data& values, const InspectReport& report);

}  // namespace scb::app
