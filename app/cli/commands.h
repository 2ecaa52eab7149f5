#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/console.h"

namespace scb::app {

/// Runs the chosen command, after the whole command line was read; returns the exit status.
using Action = std::function<int()>;

/// Runs the program with other words after its name; returns the exit status.
using RunAgain = std::function<int(const std::vector<std::string>& words)>;

// Each adds one command to the program. When it is chosen, it sets `action`.
void add_render_distance(const Command& render, const Console& console, Action& action);
void add_render_levels(const Command& render, const Console& console, Action& action);
void add_render_pairs(const Command& render, const Console& console, Action& action);
void add_render_rejections(const Command& render, const Console& console, Action& action);
void add_render_traversal(const Command& render, const Console& console, Action& action);
void add_bench(const Command& program, const Console& console, Action& action);
void add_collide(const Command& program, const Console& console, Action& action);
void add_distance(const Command& program, const Console& console, Action& action);
void add_inside(const Command& program, const Console& console, Action& action);
void add_motion(const Command& program, const Console& console, Action& action);
void add_inspect(const Command& program, const Console& console, Action& action);
void add_trace(const Command& program, const Console& console, Action& action);
void add_tune(const Command& program, const Console& console, Action& action);
void add_diff(const Command& program, const Console& console, Action& action);
void add_explain(const Command& program, const Console& console, Action& action);
void add_golden(const Command& program, const Console& console, Action& action);
/// The commands of `scb golden`.
void add_golden_init(const Command& golden, Action& action);
void add_golden_check(const Command& golden, const Console& console, Action& action);
void add_golden_update(const Command& golden, const Console& console, Action& action);
void add_golden_list(const Command& golden, Action& action);
void add_golden_report(const Command& golden, const Console& console, Action& action);
void add_golden_selftest(const Command& golden, const Console& console, Action& action);
void add_stats(const Command& program, const Console& console, Action& action);
void add_convert(const Command& program, const Console& console, Action& action);
void add_export(const Command& program, const Console& console, Action& action);
void add_scenes(const Command& program, Action& action);
void add_doctor(const Command& program, Action& action);
void add_config(const Command& program, const bool& without_files, Action& action);
void add_completion(const Command& program, Action& action);
/// Hidden: used to install scb.
void add_man(const Command& program, Action& action);
/// Hidden: for the manual.
void add_reference(const Command& program, Action& action);
void add_merge(const Command& program, const Console& console, const RunAgain& run_again,
               Action& action);
void add_view(const Command& program, const Console& console, Action& action);

}  // namespace scb::app
