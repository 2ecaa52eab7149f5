#include "app/inspect/inspect_page.h"

#include <array>
#include <cassert>
#include <kainjow/mustache.hpp>

#include "app/cli/console.h"
#include "app/cli/version.h"
#include "app/inspect/inspect_findings.h"
#include "app/inspect/inspect_triangles.h"
#include "app/inspect/recording_report.h"
#include "app/inspect/settings_page.h"
#include "app/query/recording_verdict.h"
#include "app/report/scene_report.h"
#include "app/report/table.h"
#include "app/timing/tune_report.h"
#include "core/base/text_format.h"
#include "core/platform/utf8.h"
#include "render/figures/figure_words.h"
#include "render/figures/inspect_figure.h"
#include "render/figures/reason_words.h"
#include "render/gl/embedded.h"
#include "render/overlay/figure_layout.h"

SCB_DECLARE_EMBEDDED(inspect_html)

namespace scb::app {
namespace {

using kainjow::mustache::data;
using kainjow::mustache::mustache;

std::string percents(std::uint64_t part, std::uint64_t whole) {
    return format("%.2f",
                  whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole));
}

/// The name of the reason's color in the style sheet.
std::string page_color(PassReason reason) {
    constexpr std::array<const char*, pass_reason_count> colors = {"test", "fit", "neutral",
                                                                   "early", "unjudged"};
    return colors[static_cast<std::size_t>(reason)];
}

data text_rows(const char* key, const std::vector<std::string>& texts) {
    data rows(data::type::list);
    for (const std::string& text : texts) {
        data row;
        row[key] = text;
        rows << row;
    }
    return rows;
}

data frame_data(const InspectReport& report, const std::string& name, const Inspection& found,
                double distance) {
    const PassCounts& counts = found.counts;
    const std::uint64_t all = counts.all.volume_tests, wasted = counts.wasted().volume_tests;
    data row;
    row["frame"] = name;
    row["pairs"] = report.header.kind != QueryKind::distance ? render::count_text(found.pairs)
                   : distance < 0                            ? ""
                                                             : format("%.6g", distance);
    row["n_v"] = render::count_text(all);
    row["passed"] = render::count_text(counts.passed());
    data passed(data::type::list), bars(data::type::list);
    for (const render::ReasonWords& words :
         render::reason_words(report.header.kind, report.sum.counts)) {
        data cell, bar;
        cell["count"] = render::count_text(counts.passed(words.reason));
        passed << cell;
        bar["color"] = page_color(words.reason);
        bar["part"] = percents(words.reason == PassReason::triangles_meet
                                   ? all - wasted
                                   : counts.wasted_by(words.reason).volume_tests,
                               all);
        bars << bar;
    }
    row.set("of_reasons", passed);
    row.set("bars", bars);
    row["wasted"] = render::count_text(wasted);
    const std::uint64_t n_p = counts.wasted().triangle_tests;
    row["wasted_n_p"] = render::count_text(n_p);
    row["share_n_p"] = share(n_p, counts.all.triangle_tests);
    row["wrong"] = render::count_text(counts.wrongly_rejected);
    row["missed"] = render::count_text(counts.missed);
    row["share"] = share(wasted, all);
    return row;
}

data frame_rows(const InspectReport& report) {
    data rows(data::type::list);
    for (std::size_t i = 0; i < report.frames.size() && i < most_frame_rows; ++i) {
        data row = frame_data(report, std::to_string(report.frames[i].frame),
                              report.frames[i].found, report.frames[i].distance);
        row["sum"] = flag(false);
        rows << row;
    }
    if (report.frames.size() > 1) {
        data row = frame_data(report, "sum", report.sum, -1);
        row["sum"] = flag(true);
        rows << row;
    }
    return rows;
}

data reason_rows(const InspectReport& report) {
    const PassCounts& counts = report.sum.counts;
    data rows(data::type::list);
    for (const render::ReasonWords& words : render::reason_words(report.header.kind, counts)) {
        const auto r = static_cast<std::size_t>(words.reason);
        const bool is_waste = words.reason != PassReason::triangles_meet;
        const Work wasted = counts.wasted_by(words.reason);
        data row;
        row["because"] = words.title;
        row["color"] = page_color(words.reason);
        row["inner"] = render::count_text(counts.inner[r]);
        row["leaves"] = render::count_text(counts.leaves[r]);
        row["n_v"] = is_waste ? render::count_text(wasted.volume_tests) : "";
        row["n_p"] = is_waste ? render::count_text(wasted.triangle_tests) : "";
        row["operations"] = is_waste ? operations_text(report, wasted.operations) : "";
        rows << row;
    }
    return rows;
}

/// The columns of the table of frames.
data reason_columns(const InspectReport& report) {
    data columns(data::type::list);
    for (const render::ReasonWords& words :
         render::reason_words(report.header.kind, report.sum.counts)) {
        data column;
        column["color"] = page_color(words.reason);
        column["column"] = words.column;
        columns << column;
    }
    return columns;
}

/// "not wasted, fit, test": the parts of a bar of the table of frames.
std::string bar_words(const InspectReport& report) {
    std::string words = "not wasted";
    const std::vector<render::ReasonWords> all =
        render::reason_words(report.header.kind, report.sum.counts);
    for (std::size_t i = 1; i < all.size(); ++i) words += std::string(", ") + all[i].column;
    return words;
}

data other_rows(const InspectReport& report) {
    const Work& all = report.sum.counts.all;
    data rows(data::type::list);
    for (const AlternativeTest& other : report.others) {
        data row;
        row["test"] = overlap_title(other.overlap);
        row["caught"] = render::count_text(other.caught);
        set_changes(row, all, other.all);
        rows << row;
    }
    return rows;
}

/// The problems with their pictures.
data problem_rows(const InspectedRecording& recording) {
    data rows(data::type::list);
    for (const ProblemPicture& picture : recording.pictures) {
        data row;
        row["what"] = printable(picture.what);
        row["file"] = picture.file;
        rows << row;
    }
    return rows;
}

/// The judgement of a recording: verdict, trees, tests by the stage at which they ended.
void set_judgement(data& values, const InspectedRecording& recording,
                   const std::optional<InspectSettings>& settings) {
    const scenes::RecordingJudgement& judged = recording.judged;
    data verdict(data::type::list);
    for (const std::string& line : verdict_lines(judged)) {
        data row;
        row["text"] = printable(line);
        row["alarm"] = flag(verdict.is_empty_list() && judged.wrong());
        verdict << row;
    }
    values.set("verdict", verdict);
    values["is_wrong"] = flag(judged.wrong());
    values["problems"] = problem_rows(recording);
    values["has_problems"] = flag(!recording.pictures.empty());
    Table trees({{.title = "tree", .align = Align::left},
                 {.title = "name", .align = Align::left},
                 {.title = "nodes"},
                 {.title = "depth"},
                 {.title = "problems"}});
    for (const scenes::TreeJudgement& tree : judged.trees)
        trees.add({tree.number, printable(tree.name), render::count_text(tree.nodes), tree.depth,
                   render::count_text(tree.problems.size())});
    values["trees"] = trees.html();
    Table stages({{.title = "stage", .align = Align::left},
                  {.title = "tests"},
                  {.title = "passed disjoint volumes"},
                  {.title = "rejected overlapping volumes"}});
    for (const scenes::StageJudgement& stage : judged.stages)
        stages.add({printable(stage.name), render::count_text(stage.tests),
                    render::count_text(stage.false_positives), render::count_text(stage.wrong)});
    values["has_stages"] = flag(!judged.stages.empty());
    values["stages"] = stages.html();
    values["report"] = recording_text(recording, settings);
}

/// The close-ups of one list of pairs.
class Group {
  public:
    Group(const InspectReport& report, const InspectPage& page, const char* id, const char* color,
          const char* heading, const char* words)
        : report_(report), page_(page) {
        group_["id"] = id;
        group_["color"] = color;
        group_["heading"] = heading;
        group_["words"] = words;
    }

    void add(int frame, const Step& test, const std::string& detail) {
        const auto& bodies = report_.header.bodies;
        const std::string nodes = std::to_string(test.nodes.a) + "," + std::to_string(test.nodes.b);
        data pair;
        pair["file"] = file_of(report_, frame, test);
        pair["caption"] = printable(bodies[0].name) + " " + std::to_string(test.nodes.a) + ", " +
                          printable(bodies[1].name) + " " + std::to_string(test.nodes.b);
        pair["detail"] =
            format("frame %d, depths %d and %d: ", frame, test.depth_a, test.depth_b) + detail;
        // The page of a recording has one frame.
        const bool in_view = !report_.recording || frame == report_.frames.front().frame;
        // Set in any case: a template takes a missing value from the page.
        pair["view"] = flag(false);
        if (!page_.view.empty() && in_view)
            pair["view"] = page_.view + "#frame=" + std::to_string(frame) + "&nodes=" + nodes;
        pair["command"] = page_.explain + " --frames " + std::to_string(frame) + " --pair " + nodes;
        pairs_ << pair;
        empty_ = false;
    }

    void append_to(data& groups) {
        if (empty_) return;
        group_.set("pairs", pairs_);
        groups << group_;
    }

  private:
    const InspectReport& report_;
    const InspectPage& page_;
    data group_, pairs_{data::type::list};
    bool empty_ = true;
};

std::string wasted_words(const Work& below) {
    return render::count_text(below.volume_tests) + " volume and " +
           render::count_text(below.triangle_tests) +
           (below.triangle_tests == 1 ? " triangle test wasted" : " triangle tests wasted");
}

data groups_of(const InspectReport& report, const InspectPage& page) {
    data groups(data::type::list);
    Group wrong(report, page, "rejected-wrongly", "alarm", "Rejected wrongly",
                "The volumes meet, and the test says that they do not: an error of the test. "
                "The worst first.");
    for (const WronglyRejectedPair& w : report.wrong)
        wrong.add(w.frame, w.test,
                  "rejected at " + stage_words(report.header, w.test.stage) + ", " +
                      missed_words(w.rejection));
    wrong.append_to(groups);
    for (const WorstOfReason& worst : report.worst) {
        const bool is_weak = worst.reason == PassReason::weak_test;
        Group group(report, page, is_weak ? "test-too-weak" : "fit-too-loose",
                    is_weak ? "test" : "fit",
                    is_weak ? "Test too weak, the worst first" : "Fit too loose, the worst first",
                    is_weak ? "The volumes are disjoint, and the test did not see it: a stronger "
                              "one would have."
                            : "The volumes overlap, but no triangles below them intersect: no "
                              "overlap test could have rejected them; tighter volumes or other "
                              "splits could have.");
        for (const FalsePair& p : worst.pairs)
            group.add(p.frame, p.test,
                      wasted_words(p.pair.below) +
                          (is_weak ? ", " + render::number_text(p.margin) + " apart" : ""));
        group.append_to(groups);
    }
    return groups;
}

/// The worst pairs of queries of distances. Each has a link into the page of `scb view`.
data worst_rows(const InspectReport& report, const InspectPage& page) {
    data rows(data::type::list);
    for (const WorstOfReason& worst : report.worst)
        for (const FalsePair& p : worst.pairs) {
            const render::ReasonWords words = render::words_of(worst.reason, report.header.kind);
            data row;
            row["because"] = words.title;
            row["color"] = page_color(words.reason);
            row["frame"] = std::to_string(p.frame);
            row["nodes"] = format("%u, %u", p.test.nodes.a, p.test.nodes.b);
            row["depths"] = format("%d, %d", p.test.depth_a, p.test.depth_b);
            row["n_v"] = render::count_text(p.pair.below.volume_tests);
            row["n_p"] = render::count_text(p.pair.below.triangle_tests);
            row["beyond"] =
                p.pair.exact == Contact::disjoint ? render::number_text(p.pair.gap) : "–";
            row["view"] = flag(false);
            if (!page.view.empty())
                row["view"] = page.view + format("#frame=%d&nodes=%u,%u", p.frame, p.test.nodes.a,
                                                 p.test.nodes.b);
            rows << row;
        }
    return rows;
}

}  // namespace

std::string inspect_title(const InspectReport& report) {
    const TraceHeader& header = report.header;
    const char* const of_kind = header.kind == QueryKind::distance ? "distance · "
                                : header.kind == QueryKind::within ? "within a tolerance · "
                                                                   : "";
    return scene_title(header) + " · " + printable(render::volume_title(header)) + " · " + of_kind +
           "inspect";
}

std::string inspect_subtitle(const InspectReport& report) {
    const TraceHeader& header = report.header;
    // The text is cut if there is no room, so it begins with what distinguishes pictures of a
    // scene.
    std::vector<int> frames;
    for (const InspectedFrame& frame : report.frames) frames.push_back(frame.frame);
    if (frames.empty() && report.recording)
        for (const scenes::FrameJudgement& frame : report.recording->judged.frames)
            frames.push_back(frame.frame);
    std::string text = frames.size() == 1 ? "frame " + std::to_string(frames[0])
                                          : std::to_string(frames.size()) + " frames";
    if (!report.has_waste) return text;
    if (!header.engine && header.volume == VolumeKind::scb)
        text += ", test " + overlap_title(header.options.overlap);
    // If the scene is two meshes, the title has their names.
    if (header.source.size() == 2) return text;
    return text + ", " + bodies_text(header);
}

namespace {

/// The findings on waste, with tables and close-ups.
void set_waste(data& values, const InspectReport& report, const InspectPage& page) {
    data findings(data::type::list);
    for (const std::string& sentence : inspect_findings(report)) {
        data finding;
        finding["text"] = sentence;
        const bool alarm = findings.is_empty_list() && report.sum.counts.wrongly_rejected > 0;
        finding["alarm"] = flag(alarm);
        findings << finding;
    }
    values.set("findings", findings);
    values["summary"] = page.summary;
    values["bodies"] = page.bodies;
    values["has_bodies"] = flag(!page.bodies.empty());
    const Table triangles = triangles_table(report);
    values["has_triangles"] = flag(triangles.size() > 0);
    values["triangles"] = triangles.html();
    values.set("mesh_commands", text_rows("command", mesh_commands(report)));
    values["worst_frame"] = report.frames.empty() ? "" : std::to_string(report.frames[0].frame);
    const bool is_distance = is_of_distance(report.header.kind);
    values["is_distance"] = flag(is_distance);
    values["found"] = report.header.kind == QueryKind::distance ? "distance" : "pairs";
    values["reasons"] = reason_rows(report);
    values.set("columns", reason_columns(report));
    values["bar_words"] = bar_words(report);
    if (is_distance) values.set("worst_pairs", worst_rows(report, page));
    values["frames"] = frame_rows(report);
    if (report.frames.size() > most_frame_rows)
        values["more_frames"] = "The worst " + std::to_string(most_frame_rows) + " of " +
                                render::count_text(report.frames.size()) + " frames; " +
                                report.files + "_frames.csv has all of them.";
    values["has_wrong"] = flag(report.sum.counts.wrongly_rejected > 0);
    values["has_others"] = flag(!report.others.empty());
    values["others"] = other_rows(report);
    values["weak"] = render::count_text(report.sum.counts.passed(PassReason::weak_test));
    if (!is_distance) values["groups"] = groups_of(report, page);
}

}  // namespace

std::string inspect_html(const InspectReport& report, const InspectPage& page) {
    data values;
    values["title"] = inspect_title(report);
    values["subtitle"] = inspect_subtitle(report);
    values["width"] = std::to_string(page.width);
    values["height"] = std::to_string(page.height);
    values["light"] = flag(page.light);
    values["has_judgement"] = flag(report.recording.has_value());
    if (report.recording) set_judgement(values, *report.recording, report.settings);
    values["has_waste"] = flag(report.has_waste);
    if (report.has_waste) set_waste(values, report, page);
    set_settings(values, report);
    if (!page.view.empty()) {
        values["view"] = page.view + "#show=verdicts";
        values["view_frames"] = report.recording
                                    ? "in frame " + std::to_string(report.frames.front().frame)
                                    : "in the frames of the worst pairs";
    }
    values["files"] = report.files;
    values["version"] = SCB_VERSION;
    values["command"] = page.command;
    mustache html{std::string(SCB_EMBEDDED(inspect_html))};
    assert(html.is_valid() && "the template is part of the program");
    return as_utf8(html.render(values));
}

}  // namespace scb::app
