#include "app/cli/commands.h"

namespace scb::app {

void add_golden(const Command& program, const Console& console, Action& action) {
    const Command golden = program.add_subcommand(
        "golden",
        "Keep counts and pictures as baselines: init, check, update, list, report, selftest");
    golden.require_subcommand();
    golden.footer(
        "A suite is a file of cases, each a command of scb; its baselines are files beside it. See "
        "golden/README.md.\n\n"
        "Examples:\n"
        "  scb golden init my-scene.json\n"
        "  scb golden check --report out/\n"
        "  scb golden update levels-spheres-scb");
    add_golden_init(golden, action);
    add_golden_check(golden, console, action);
    add_golden_update(golden, console, action);
    add_golden_list(golden, action);
    add_golden_report(golden, console, action);
    add_golden_selftest(golden, console, action);
}

}  // namespace scb::app
