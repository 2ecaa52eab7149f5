#include "app/inspect/inspect_summary.h"

#include <algorithm>

#include "app/inspect/inspect_findings.h"
#include "app/inspect/inspect_triangles.h"
#include "app/report/wrapped_text.h"
#include "app/timing/tune_layout_report.h"
#include "core/base/text_format.h"
#include "core/platform/utf8.h"
#include "render/figures/reason_words.h"

namespace scb::app {
namespace {

constexpr std::size_t most_triangles = 3, most_frames = 3, most_pairs = 2;

/// Each sentence on lines of its own.
std::string sentences_text(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) text += wrapped_text(sentence, 2) + "\n";
    return text;
}

/// A command on several lines that a shell joins again.
std::string command_lines(const std::string& command) {
    std::string text = "  ";
    std::size_t width = text.size();
    const bool is_quoted = command.find_first_of("'\"\\") != std::string::npos;
    for (std::size_t begin = 0; begin < command.size();) {
        std::size_t end = is_quoted ? std::string::npos : command.find(" --", begin + 1);
        end = std::min(end, command.size());
        std::string part = command.substr(begin, end - begin);
        if (begin > 0 && width + part.size() + 2 > report_width) {
            text += " \\\n     ";
            width = 5;
        }
        // A list goes on at the beginning of a line: blanks there would end the word.
        while (!is_quoted && width + part.size() > report_width) {
            const std::size_t comma = part.rfind(',', report_width - width - 2);
            if (comma == std::string::npos) break;
            text += part.substr(0, comma + 1) + "\\\n";
            part.erase(0, comma + 1);
            width = 0;
        }
        text += part;
        width += part.size();
        begin = end;
    }
    return text + "\n";
}

std::string advice_text(const InspectReport& report) {
    std::string text = sentences_text(advice_findings(report));
    if (has_advice(report)) {
        const SceneTuning& tuning = report.settings->tuning;
        const TuneLayout* const layout = tuning.cheapest_layout();
        text += command_lines(layout ? report.settings->layout_command : report.settings->command);
        text += "  C++: " +
                (layout ? layout_code(tuning, *layout)
                        : setting_code(tuning, tuning.rows[tuning.recommended()].setting)) +
                "\n";
    }
    if (report.distance_advice)
        text += command_lines(report.distance_advice->command) +
                command_lines(report.distance_advice->timing);
    text += sentences_text(mesh_sentences(report));
    for (const std::string& command : mesh_commands(report)) text += command_lines(command);
    return text.empty() ? text : text + "\n";
}

std::string costly_text(const InspectReport& report) {
    const Table table = triangles_table(report, most_triangles);
    if (table.size() == 0) return "";
    return triangles_heading + table.text() + "\n";
}

std::string pairs_text(const InspectReport& report) {
    const std::size_t width = is_of_distance(report.header.kind) ? 16 : 13;
    Table table({{.title = "worst pairs", .width = width, .align = Align::left},
                 {.title = "frame", .width = 6, .before = 1},
                 {.title = "nodes", .width = 15, .before = 2},
                 {.title = "depths", .width = 7, .before = 2},
                 {.title = "wasted N_v", .width = 10, .before = 2},
                 {.title = "wasted N_p", .width = 10, .before = 2}});
    const auto add = [&](const char* reason, const std::vector<FalsePair>& pairs) {
        for (std::size_t i = 0; i < std::min(most_pairs, pairs.size()); ++i) {
            const FalsePair& p = pairs[i];
            table.add({reason, p.frame, format("%u,%u", p.test.nodes.a, p.test.nodes.b),
                       format("%d,%d", p.test.depth_a, p.test.depth_b),
                       count_text(p.pair.below.volume_tests),
                       count_text(p.pair.below.triangle_tests)});
        }
    };
    for (const WorstOfReason& worst : report.worst)
        add(render::words_of(worst.reason, report.header.kind).title, worst.pairs);
    return table.size() == 0 ? "" : table.text();
}

}  // namespace

std::string inspect_summary(const InspectReport& report) {
    std::string text = sentences_text(alarm_findings(report)) +
                       sentences_text(certified_findings(report)) + advice_text(report) +
                       sentences_text(waste_findings(report)) + "\n";
    text += inspect_rejections_text(report, most_pairs);
    // The judgement of a recording has a table of frames, and is long.
    if (!report.recording)
        text += costly_text(report) + inspect_frames_text(report, most_frames) + pairs_text(report);
    return text + "--full prints all tables.\n";
}

}  // namespace scb::app
