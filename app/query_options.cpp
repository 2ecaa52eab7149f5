#include "app/query_options.h"

#include <algorithm>

#include "core/error.h"

namespace scb {

std::vector<OverlapTest> QueryOptions::tests() const {
    std::vector<OverlapTest> tests;
    for (const std::string& name : split_list(test)) {
        const std::optional<OverlapTest> found = overlap_test_of(name);
        if (!found)
            throw InputError("--test " + test + ": '" + name +
                             "' is no overlap test; give symmetric, corrected, extents, line8 or "
                             "printed.");
        if (std::find(tests.begin(), tests.end(), *found) == tests.end()) tests.push_back(*found);
    }
    return tests;
}

CollideOptions QueryOptions::collide() const {
    CollideOptions options;
    const std::vector<OverlapTest> all = tests();
    if (all.size() != 1)
        throw InputError("--test " + test + ": this command takes one overlap test at a time.");
    options.overlap.test = all[0];
    if (!(threshold >= 0 && threshold <= 1))
        throw InputError("--threshold " + std::to_string(threshold) +
                         ": give a cosine from 0 to 1.");
    options.overlap.threshold = threshold;
    const std::optional<DescentRule> rule = descent_rule_of(descent);
    if (!rule)
        throw InputError("--descent " + descent +
                         ": unknown rule; give radius, area, volume or alternating.");
    options.descent = *rule;
    return options;
}

void warn_of_printed(const QueryOptions& options, const Console& console) {
    const std::vector<OverlapTest> all = options.tests();
    if (std::find(all.begin(), all.end(), OverlapTest::printed) != all.end())
        console.note(
            "scb: the test 'printed' rejects some volumes that meet, so pairs may be missing.");
}

void add_query_options(CLI::App& command, QueryOptions& options, bool several_tests) {
    command
        .add_option("--test", options.test,
                    std::string(several_tests ? "Overlap tests for slab cut balls: some of "
                                              : "Overlap test for slab cut balls: ") +
                        "symmetric, corrected, extents, line8, printed (which misses collisions)")
        ->type_name(several_tests ? "LIST" : "TEST")
        ->capture_default_str();
    command
        .add_option("--threshold", options.threshold,
                    "The paper's a, of corrected, line8 and printed: cylinders are tested where "
                    "|n0.n1| is above it")
        ->type_name("A")
        ->capture_default_str();
    command
        .add_option("--descent", options.descent,
                    "Which of two nodes is divided: the larger by radius, area or volume, or "
                    "alternating")
        ->type_name("RULE")
        ->capture_default_str();
    command.add_option("--frames", options.frames, "Frames: 0,250 or FIRST:LAST[:STEP] or all")
        ->type_name("LIST")
        ->capture_default_str();
    command
        .add_option("--bodies", options.bodies,
                    "Names of the two bodies, where the scene has more than two")
        ->type_name("A,B");
}

}  // namespace scb
