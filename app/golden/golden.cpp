#include "app/cli/commands.h"

namespace scb {

void add_golden(CLI::App& program, const Console& console, Action& action) {
    CLI::App* golden = program.add_subcommand(
        "golden", "Counts and pictures as baselines: check, update, list, report, selftest");
    golden->require_subcommand(1);
    golden->fallthrough();
    golden->footer(
        "A suite is a file of cases, each a command of scb; its baselines are files beside it. See "
        "golden/README.md.\n\n"
        "Examples:\n"
        "  scb golden check --report out/\n"
        "  scb golden update levels-spheres-scb");
    add_golden_check(*golden, console, action);
    add_golden_update(*golden, console, action);
    add_golden_list(*golden, action);
    add_golden_report(*golden, console, action);
    add_golden_selftest(*golden, console, action);
}

}  // namespace scb
