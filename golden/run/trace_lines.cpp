#include "golden/run/trace_lines.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "golden/suite/baseline.h"
#include "scenes/traces/trace_diff_text.h"
#include "scenes/traces/trace_input.h"

namespace scb::golden {
namespace {

using Json = nlohmann::json;

const TraceNames trace_names = {"baseline", "new run"};

/// Volume tests by the depth of the pair, frame by frame.
Json tests_by_depth(const std::filesystem::path& trace) {
    scenes::TraceInput input(trace.string());
    Json counts = Json::object();
    while (const TraceFrame* frame = input.reader.next()) {
        std::map<int, std::int64_t> tests;
        for (const Step& test : frame->steps.volumes) ++tests[test.depth_a + test.depth_b];
        for (const auto& [depth, count] : tests)
            counts["frames"][std::to_string(frame->frame)][std::string(tests_by_depth_key)]
                  [std::to_string(depth)] = count;
    }
    return counts;
}

/// The lines of a text joined to one.
std::string joined(const std::string& text) {
    std::string line;
    for (const char c : text)
        if (c != '\n')
            if (c != ' ' || !line.ends_with(' ')) line += c;
    return line;
}

std::vector<std::string> conclusions(const TraceDiff& d, const Cause& cause) {
    std::vector<std::string> lines;
    for (const FieldDifference& field : d.asked)
        if (field.name.starts_with("mesh of ") ? !cause.other_meshes : !cause.has_settings)
            lines.push_back("Another " + field.name + ": " + field.a + " before, " + field.b +
                            " now.");
    if (const std::string lost = scenes::lost_pairs_text(d, trace_names); !lost.empty())
        lines.push_back(lost + ".");
    if (d.first)
        lines.push_back("They part first at " + joined(words_of(*d.first, d.bodies, trace_names)));
    return lines;
}

/// The place of the first difference, for a page with both.
std::string place_of(const TraceDiff& d) {
    if (d.first) {
        const std::optional<TracedTest>& parted = d.first->a ? d.first->a : d.first->b;
        return "#frame=" + std::to_string(d.first->frame) +
               "&nodes=" + std::to_string(parted->test.nodes.a) + "," +
               std::to_string(parted->test.nodes.b) + (d.first->a ? "" : "&column=1");
    }
    return d.frames.empty() ? "" : "#show=pairs&frame=" + std::to_string(d.frames[0].frame);
}

}  // namespace

bool add_trace_lines(CaseResult& result, const ComparisonFolders& folders, const Cause& cause) {
    const std::filesystem::path before = case_files(folders.baselines, result.name).trace,
                                after = case_files(folders.candidates, result.name).trace;
    std::error_code ignored;
    if (!std::filesystem::exists(before, ignored) || !std::filesystem::exists(after, ignored))
        return true;
    scenes::TraceInput a(before.string()), b(after.string());
    const TraceDiff d = diff(
        a.reader.header(), [&] { return a.reader.next(); }, b.reader.header(),
        [&] { return b.reader.next(); });
    for (CountChange& change : counts_difference(tests_by_depth(before), tests_by_depth(after)))
        result.counts.push_back(std::move(change));
    if (d.equal()) return true;
    for (std::string& line : conclusions(d, cause)) result.lines.push_back(std::move(line));
    result.trace_difference = scenes::trace_diff_text(d, trace_names);
    result.view = place_of(d);
    return d.nodes_comparable;
}

}  // namespace scb::golden
