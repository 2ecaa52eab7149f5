#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "app/cli/console.h"

namespace scb {

/// What the chosen command does, once the whole command line has been read; returns the exit
/// status.
using Action = std::function<int()>;

// Each adds one command to the program. When it is chosen, it sets `action`.
void add_render_levels(CLI::App& render, const Console& console, Action& action);
void add_render_pairs(CLI::App& render, const Console& console, Action& action);
void add_render_rejections(CLI::App& render, const Console& console, Action& action);
void add_render_traversal(CLI::App& render, const Console& console, Action& action);
void add_bench(CLI::App& program, const Console& console, Action& action);
void add_collide(CLI::App& program, const Console& console, Action& action);
void add_inspect(CLI::App& program, const Console& console, Action& action);
void add_trace(CLI::App& program, const Console& console, Action& action);
void add_tune(CLI::App& program, const Console& console, Action& action);
void add_diff(CLI::App& program, Action& action);
void add_explain(CLI::App& program, const Console& console, Action& action);
void add_golden(CLI::App& program, const Console& console, Action& action);
/// The commands of `scb golden`.
void add_golden_check(CLI::App& golden, const Console& console, Action& action);
void add_golden_update(CLI::App& golden, const Console& console, Action& action);
void add_golden_list(CLI::App& golden, Action& action);
void add_golden_report(CLI::App& golden, const Console& console, Action& action);
void add_golden_selftest(CLI::App& golden, const Console& console, Action& action);
void add_stats(CLI::App& program, const Console& console, Action& action);
void add_export(CLI::App& program, const Console& console, Action& action);
void add_scenes(CLI::App& program, Action& action);

}  // namespace scb
