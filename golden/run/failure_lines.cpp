#include "golden/run/failure_lines.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/text_format.h"
#include "golden/compare/cause.h"
#include "golden/run/pixel_owners.h"
#include "golden/suite/baseline.h"
#include "render/files/image_file.h"
#include "scb/error.h"
#include "scenes/recordings/test_input.h"
#include "scenes/recordings/trace_diff_text.h"

namespace scb::golden {
namespace {

/// More things do not help a reader.
constexpr std::size_t most_things = 10;

std::string pixels(std::size_t count) { return counted(count, "pixel", "pixels"); }

/// "Node 412 of A, level 7 (id 413),", as in the tables.
std::string subject(const std::string& name, std::uint32_t id) {
    if (name.empty()) return "Id " + std::to_string(id);
    std::string text = name;
    if (text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 32);
    return text + " (id " + std::to_string(id) + ")";
}

std::string line_of(const IdChange& change, const std::string& name) {
    const std::string who = subject(name, change.id);
    if (change.after == 0) return who + " is missing: " + pixels(change.before) + ".";
    if (change.before == 0) return who + " is new: " + pixels(change.after) + ".";
    // It has lost and gained equal numbers of pixels.
    if (change.before == change.after)
        return who + " has " + pixels(change.after) + " as before, " +
               count_text(change.moved / 2) + " of them elsewhere.";
    return who + " had " + pixels(change.before) + " and has " + count_text(change.after) + ".";
}

void add_id_lines(CaseResult& result, const Owners& owners) {
    for (const IdChange& change : result.ids->changes) {
        result.owners.push_back(owners.name(change.id));
        if (result.owners.size() <= most_things)
            result.lines.push_back(line_of(change, result.owners.back()));
    }
    if (result.owners.size() > most_things)
        result.lines.push_back(counted(result.owners.size() - most_things,
                                       "more thing has other pixels.",
                                       "more things have other pixels."));
}

/// Adds the things whose pixels have other colors although the ids are the same.
void add_color_lines(CaseResult& result, const ComparisonFolders& folders, const Owners& owners) {
    const CaseFiles made = case_files(folders.candidates, result.name);
    const std::vector<std::filesystem::path> accepted =
        accepted_images(folders.baselines, result.name);
    const render::Image before = render::read_png(
                            accepted[static_cast<std::size_t>(result.variant) - 1]),
                        after = render::read_png(made.image);
    const render::IdImage ids = render::unpack_ids(render::read_png(made.ids));
    if (ids.width != after.width || ids.height != after.height) return;
    std::map<std::uint32_t, std::size_t> changed;
    for (int y = 0; y < after.height; ++y)
        for (int x = 0; x < after.width; ++x)
            if (!(render::pixel(before, x, y) == render::pixel(after, x, y)))
                ++changed[render::pixel(ids, x, y)];
    std::vector<std::pair<std::uint32_t, std::size_t>> most(changed.begin(), changed.end());
    std::stable_sort(most.begin(), most.end(),
                     [](const auto& x, const auto& y) { return x.second > y.second; });
    for (std::size_t i = 0; i < most.size() && i < most_things; ++i)
        result.lines.push_back((most[i].first == 0
                                    ? "The background, or text and figures,"
                                    : subject(owners.name(most[i].first), most[i].first)) +
                               " has other colors: " + pixels(most[i].second) + ".");
    if (most.size() > most_things)
        result.lines.push_back(counted(most.size() - most_things, "more thing has other colors.",
                                       "more things have other colors."));
}

/// Checks that the record of the baseline can be read also if the case is the same: when the case
/// differs, an error would come too late.
void check_record(CaseResult& result, const ComparisonFolders& folders) {
    try {
        read_record(case_files(folders.baselines, result.name).meta);
    } catch (const InputError& error) {
        result.lines.push_back(
            std::string(error.what()) +
            " It is not compared, but a failure will have no cause; restore the file, or update "
            "the case by name.");
    }
}

/// Finds out why it may differ, from the records of both.
Cause find_cause(CaseResult& result, const ComparisonFolders& folders) {
    try {
        Cause cause = cause_of(read_record(case_files(folders.baselines, result.name).meta),
                               read_record(case_files(folders.candidates, result.name).meta));
        result.cause = cause.sentences;
        return cause;
    } catch (const InputError& error) {
        // An error of a file that is not compared does not hide the other lines.
        result.lines.push_back(error.what());
        return {};
    }
}

}  // namespace

namespace {

/// A sentence for each distance that differs.
void add_distance_lines(CaseResult& result, const GoldenCase& golden) {
    std::string scene;
    for (const std::string& name : golden.own_scene) scene += (scene.empty() ? "" : " ") + name;
    for (const CountChange& change : result.counts) {
        if (change.bound.empty()) continue;
        // "frames/3/distance" or "frames/3/queries/["A","B"]/distance".
        const std::size_t begin = change.place.find('/') + 1, end = change.place.find('/', begin),
                          bodies = change.place.find('[', end);
        std::string line = scene + ", frame " + change.place.substr(begin, end - begin);
        if (bodies != std::string::npos)
            line += ", " + change.place.substr(bodies, change.place.rfind('/') - bodies);
        result.lines.push_back(line + ": expected the distance " + change.before_text + ", got " +
                               change.after_text + "; they may differ by " + change.bound + ".");
    }
}

}  // namespace

void add_lines(CaseResult& result, const GoldenCase& golden, const GoldenRunSettings& settings,
               const ComparisonFolders& folders) {
    if (result.verdict == Verdict::same) check_record(result, folders);
    if (result.verdict != Verdict::different && result.verdict != Verdict::size_differs) return;
    const Cause cause = find_cause(result, folders);
    if (result.verdict != Verdict::different) return;
    add_distance_lines(result, golden);
    try {
        const bool same_meshes = add_trace_lines(result, folders, cause) && !cause.other_meshes;
        if (!result.ids && !(result.colors && golden.ids)) return;
        const Owners owners(golden, settings, folders.candidates / (result.name + ".index.json"),
                            same_meshes);
        if (result.ids) add_id_lines(result, owners);
        if (result.colors && golden.ids) add_color_lines(result, folders, owners);
    } catch (const InputError& error) {
        result.lines.push_back(error.what());
    }
}

namespace {

using Json = nlohmann::json;

const TraceNames trace_names = {"baseline", "new run"};

/// Volume tests by the depth of the pair, frame by frame.
Json tests_by_depth(const std::filesystem::path& trace) {
    scenes::TestInput input(trace.string(), "all");
    Json counts = Json::object();
    while (const QueryTrace* frame = input.next()) {
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
    for (const FrameDifference& frame : d.frames)
        if (const std::string answer = scenes::answer_text(frame, trace_names); !answer.empty())
            lines.push_back("In the traces, " + answer + ".");
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
    const std::filesystem::path before = trace_of(case_files(folders.baselines, result.name)),
                                after = trace_of(case_files(folders.candidates, result.name));
    if (before.empty() || after.empty()) return true;
    scenes::TestInput a(before.string(), "all"), b(after.string(), "all");
    const TraceDiff d = diff(
        a.header(), [&] { return a.next(); }, b.header(), [&] { return b.next(); });
    for (CountChange& change : counts_difference(tests_by_depth(before), tests_by_depth(after)))
        result.counts.push_back(std::move(change));
    if (d.equal()) return true;
    for (std::string& line : conclusions(d, cause)) result.lines.push_back(std::move(line));
    result.trace_difference = scenes::trace_diff_text(d, trace_names);
    result.view = place_of(d);
    return d.nodes_comparable;
}

}  // namespace scb::golden
