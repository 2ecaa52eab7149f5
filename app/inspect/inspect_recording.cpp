#include "app/inspect/inspect_recording.h"

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/cli/command_text.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/explain/explain_report.h"
#include "app/inspect/judgement_json.h"
#include "app/inspect/recording_pictures.h"
#include "app/inspect/recording_report.h"
#include "app/inspect/recording_settings.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "scb/error.h"
#include "scenes/text/input_files.h"
#include "scenes/text/number_list.h"

namespace scb::app {
namespace {

/// The command that explains the first faulty test; empty if there is none.
std::string explain_command(const scenes::RecordingJudgement& judged, const std::string& path) {
    for (const auto* groups : {&judged.test_problems, &judged.missed})
        for (const scenes::ProblemGroup& group : *groups) {
            const scenes::ProblemCase& first = group.cases.front();
            if (first.nodes.a == no_index || first.nodes.b == no_index) continue;
            const bool several = judged.summary.body_names.size() > 2;
            return "scb explain " + file_word(path) +
                   (several ? " --bodies " + file_word(first.query.a + "," + first.query.b) : "") +
                   " --frames " + std::to_string(first.query.frame) +
                   format(" --pair %u,%u", first.nodes.a, first.nodes.b);
        }
    return {};
}

}  // namespace

int inspect_recording(InspectOptions& options, const Console& console) {
    const std::string& path = options.scene.names[0];
    options.check();
    const auto file = std::make_shared<const scenes::RecordingFile>(path);
    const std::vector<int> frames = scenes::frames_among(file->summary.frames, options.query.frames,
                                                         path, "a recording may have");
    const InterruptWatch watch;
    Progress progress(console, frames.size());
    const scenes::RecordingJudgement judged = scenes::judge_recording(
        *file, [&](int frame) { return std::binary_search(frames.begin(), frames.end(), frame); },
        [&](bool frame) {
            if (frame) progress.step("frames");
            return watch.signal() == 0;
        });
    if (judged.trees.empty() && judged.summary.queries == 0)
        throw InputError(path + ": it has no trees and no queries, so there is nothing to judge." +
                         (judged.damage.empty() ? "" : " " + judged.damage));
    if (options.time) console.note("scb: --time has no effect on the recording of another engine.");
    std::shared_ptr<const scenes::Recording> recording;
    const auto contents = [&] {
        if (!recording)
            recording = std::make_shared<const scenes::Recording>(scenes::read_recording(file));
        return recording;
    };
    // Not if the recording is wrong: other settings cannot be compared with queries that miss
    // contacts.
    std::optional<RecordingSettings> settings;
    std::string no_settings;
    if (watch.signal() == 0 && !judged.wrong()) {
        try {
            settings = recording_settings(contents(), options.query.bodies, options.query.frames,
                                          console, watch);
        } catch (const InputError& error) {
            no_settings = error.what();
        }
    }
    std::vector<ProblemPicture> drawn;
    std::optional<PictureRun> pictures;
    if (options.draws() && watch.signal() == 0) {
        pictures.emplace(options.picture, scenes::file_name_of(judged.engine));
        drawn = draw_problems(*pictures, options.picture, *contents(), judged);
        for (ProblemPicture& picture :
             draw_waste(*pictures, options.picture, contents(), options.query.bodies, judged))
            drawn.push_back(std::move(picture));
    }
    std::string text;
    if (options.picture.json) {
        nlohmann::ordered_json json = recording_json(judged, path);
        if (settings) json["settings"] = recording_settings_json(*settings);
        text = json_text(json, 2) + "\n";
    } else {
        const auto top = static_cast<std::size_t>(options.top);
        text = recording_text(judged, settings, path, top, options.asks_top ? top : 1);
        if (settings) text += recording_settings_text(*settings);
        if (!drawn.empty()) text += "\nPictures\n";
        for (const ProblemPicture& picture : drawn)
            text += "  " + picture.file + ": " + picture.what + "\n";
    }
    if (pictures) {
        if (options.picture.json)
            pictures->print_instead(text);
        else
            pictures->say(text);
        pictures->finish({{"command", "inspect"}, {"recording", path}}, console);
    } else {
        print_result(text);
    }
    if (!no_settings.empty())
        console.note("scb: there is no comparison with this project's hierarchies: " + no_settings);
    if (judged.wrong() && !pictures)
        console.note("scb: `scb inspect " + file_word(path) +
                     " -o out` draws the first of each kind of what is wrong.");
    if (const std::string next = explain_command(judged, path); !next.empty())
        console.note("scb: `" + next + "` explains the first test at fault, step by step.");
    if (watch.signal() != 0) {
        console.note("scb: interrupted; " + std::to_string(frames.size() - judged.frames_left) +
                     " of " + std::to_string(frames.size()) + " frames were inspected.");
        return exit_interrupted(watch.signal());
    }
    switch (judged.verdict()) {
        case scenes::Verdict::sound:
            return exit_done;
        case scenes::Verdict::partly_judged:
            return exit_partly_judged;
        case scenes::Verdict::wrong:
            break;
    }
    return exit_different;
}

}  // namespace scb::app
