#include "app/query/query_options.h"

#include "app/cli/choice.h"
#include "app/cli/validators.h"
#include "app/query/level_list.h"

#include <algorithm>

#include "core/base/text_format.h"
#include "core/platform/number_list.h"
#include "scb/error.h"

namespace scb::app {
namespace {

std::string test_names() { return name_list(all_overlap_tests(), overlap_test_name); }

std::vector<std::string> test_words() {
    return words_of(choices_of(all_overlap_tests(), overlap_test_name));
}

}  // namespace

std::vector<OverlapTest> QueryOptions::tests() const {
    std::vector<OverlapTest> tests;
    for (const std::string& name : split_list(test)) {
        const std::optional<OverlapTest> found = overlap_test_of(name);
        if (!found)
            throw InputError("--test " + test + ": '" + name +
                             "' is not an overlap test; give one of " + test_names() + ".");
        if (std::find(tests.begin(), tests.end(), *found) == tests.end()) tests.push_back(*found);
    }
    return tests;
}

OverlapOptions QueryOptions::overlap() const {
    const std::vector<OverlapTest> all = tests();
    if (all.size() != 1)
        throw InputError("--test " + test + ": this command takes one overlap test at a time.");
    if (!(threshold >= 0 && threshold <= 1))
        throw InputError(format("--threshold %g: give a cosine from 0 to 1.", threshold));
    OverlapOptions options{all[0], threshold + 0.0};  // -0 is 0
    return options;
}

CollideOptions QueryOptions::collide() const {
    CollideOptions options;
    options.overlap = overlap();
    options.descent = descent;
    return options;
}

void QueryLimits::apply(CollideOptions& options, int deepest_level) const {
    if (max_pairs < 1)
        throw InputError("--max-pairs " + std::to_string(max_pairs) + ": give at least 1.");
    options.max_pairs = static_cast<std::size_t>(max_pairs);
    options.stop_level = -1;
    if (levels.empty()) return;
    const int level = parse_level(levels, deepest_level);
    // No node is deeper than this level: only leaves are left.
    options.stop_level = level == leaf_level ? deepest_level : level;
}

void note_doubts(const QueryOptions& options, const std::vector<VolumeKind>& kinds,
                 const Console& console) {
    const QueryOptions defaults;
    const std::vector<OverlapTest> tests = options.tests();
    const bool has_scb = std::find(kinds.begin(), kinds.end(), VolumeKind::scb) != kinds.end();
    const bool asks_test = options.test != defaults.test,
               asks_threshold = options.threshold != defaults.threshold;
    if (!has_scb && (asks_test || asks_threshold))
        console.note("scb: " +
                     std::string(asks_test && asks_threshold
                                     ? "--test and --threshold have no effect: they are"
                                 : asks_test ? "--test has no effect: it is"
                                             : "--threshold has no effect: it is") +
                     " for slab cut balls with one slab (scb).");
    else if (asks_threshold && std::none_of(tests.begin(), tests.end(), has_threshold))
        console.note("scb: --threshold has no effect on --test " + options.test + ".");
    if (has_scb && std::find(tests.begin(), tests.end(), OverlapTest::printed) != tests.end())
        console.note(
            "scb: the test 'printed' rejects some volumes that meet, so pairs may be missing.");
}

void add_overlap_options(const Command& command, QueryOptions& options, bool several_tests) {
    const Option test =
        command
            .add_option("--test", options.test,
                        std::string(several_tests
                                        ? "Overlap tests for slab cut balls with one slab: some of "
                                        : "Overlap test for slab cut balls with one slab: ") +
                            test_names() + " (printed misses collisions)")
            .type_name(several_tests ? "LIST" : "TEST")
            .show_default();
    if (several_tests)
        test.offer_list(test_words());
    else
        test.offer(test_words());
    test.shareable().only_typed(std::string(overlap_test_name(OverlapTest::printed)),
                                "it misses collisions");
    command
        .add_option("--threshold", options.threshold,
                    "Threshold a of the paper, for corrected, line8 and printed: a slab is tested "
                    "against a cylinder if |n0.n1| > a")
        .check(real_number)
        .type_name("A")
        .show_default()
        .shareable();
}

std::vector<std::string> compared_words() {
    std::vector<std::string> words = test_words();
    for (const VolumeKind kind : all_volume_kinds()) words.emplace_back(volume_kind_name(kind));
    return words;
}

void add_bodies_option(const Command& command, QueryOptions& options) {
    command
        .add_option("--bodies", options.bodies,
                    "Names of two bodies, if the scene has more than two")
        .type_name("A,B")
        .shareable();
}

void add_query_options(const Command& command, QueryOptions& options, bool several_tests) {
    add_overlap_options(command, options, several_tests);
    const std::vector<Choice<DescentRule>> rules =
        choices_of(all_descent_rules(), descent_rule_name);
    add_choice(command, "--descent", options.descent, rules,
               "Which of two nodes is divided: the larger by radius, area or volume, or A's and "
               "B's in turn: " +
                   offered(rules))
        .type_name("RULE")
        .shareable();
    command
        .add_option("--frames,--frame", options.frames, "Frames: 0,250 or FIRST:LAST[:STEP] or all")
        .type_name("LIST")
        .offer({"all"})
        .show_default()
        .shareable();
    add_bodies_option(command, options);
}

void add_query_limits(const Command& command, QueryLimits& limits) {
    command.add_option("--max-pairs", limits.max_pairs, "End a query at this many pairs")
        .check(decimal_number)
        .type_name("K")
        .show_default()
        .shareable();
    command
        .add_option(
            "--levels,--level", limits.levels,
            "Stop at this level: one number, or 'leaves'; finds pairs of nodes, tests no triangles")
        .type_name("K")
        .offer({"leaves"})
        .shareable();
}

std::vector<std::string> given_hierarchy_options(const Command& command) {
    std::vector<std::string> given;
    for (const char* option : {"--pose", "--volume", "--growth", "--margin", "--split"})
        if (command.count(option) > 0) given.emplace_back(option);
    return given;
}

const std::vector<std::string>& recording_options() {
    static const std::vector<std::string> options = {
        "--pose",      "--volume",  "--growth", "--margin",    "--split", "--test",
        "--threshold", "--descent", "--bodies", "--max-pairs", "--levels"};
    return options;
}

std::vector<std::string> given_recording_options(const Command& command) {
    std::vector<std::string> given;
    for (const std::string& option : recording_options())
        if (command.count(option) > 0) given.push_back(option);
    return given;
}

void refuse_for_trace(const std::vector<std::string>& given, const std::string& trace) {
    if (given.empty()) return;
    throw InputError(
        given[0] + ": " + trace +
        " is recorded, and has what it was recorded with; give a scene, or leave out " + given[0] +
        ".");
}

bool asks_for_recorded(const std::vector<std::string>& given) {
    return std::all_of(given.begin(), given.end(),
                       [](const std::string& option) { return option == "--bodies"; });
}

}  // namespace scb::app
