#include "app/study/query_setup.h"

#include <algorithm>

#include "core/base/text_format.h"
#include "core/platform/near_word.h"
#include "core/platform/number_list.h"
#include "scb/error.h"

namespace scb::app {

DistanceOptions DistanceQuery::up_to_first() const {
    DistanceOptions first = limits;
    first.order = DistanceOrder::depth_first;
    first.enough = first.limit = *within;
    return first;
}

std::vector<OverlapTest> QueryOptions::tests() const {
    std::vector<OverlapTest> tests;
    std::vector<std::string> known;
    for (const OverlapTest one : all_overlap_tests()) known.emplace_back(overlap_test_name(one));
    for (const std::string& name : split_list(test)) {
        const std::optional<OverlapTest> found = overlap_test_of(name);
        if (!found)
            throw InputError("--test " + test + ": '" + name + "' is not an overlap test" +
                             did_you_mean(name, known) + "; give one of " + name_list(known) + ".");
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
                 const Note& note) {
    const QueryOptions defaults;
    const std::vector<OverlapTest> tests = options.tests();
    const bool has_scb = std::find(kinds.begin(), kinds.end(), VolumeKind::scb) != kinds.end();
    const bool asks_test = options.test != defaults.test,
               asks_threshold = options.threshold != defaults.threshold;
    if (!has_scb && (asks_test || asks_threshold))
        note("scb: " +
             std::string(asks_test && asks_threshold
                             ? "--test and --threshold have no effect: they are"
                         : asks_test ? "--test has no effect: it is"
                                     : "--threshold has no effect: it is") +
             " for slab cut balls with one slab (scb).");
    else if (asks_threshold && std::none_of(tests.begin(), tests.end(), has_threshold))
        note("scb: --threshold has no effect on --test " + options.test + ".");
    if (has_scb && std::find(tests.begin(), tests.end(), OverlapTest::printed) != tests.end())
        note("scb: the test 'printed' rejects some volumes that meet, so pairs may be missing.");
}

bool asks_for_recorded(const std::vector<std::string>& given) {
    return std::all_of(given.begin(), given.end(),
                       [](const std::string& option) { return option == "--bodies"; });
}

}  // namespace scb::app
