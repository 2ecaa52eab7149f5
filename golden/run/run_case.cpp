#include "golden/run/run_case.h"

#include <nlohmann/json.hpp>

#include "core/base/exit_status.h"
#include "core/platform/file_bytes.h"
#include "core/platform/json_reader.h"
#include "core/platform/output_file.h"
#include "golden/run/command_process.h"
#include "golden/run/command_workers.h"
#include "golden/suite/baseline.h"
#include "golden/suite/case_command.h"
#include "golden/suite/case_counts.h"
#include "golden/suite/case_record.h"
#include "scb/error.h"
#include "scenes/recordings/recording_input.h"
#include "scenes/scene/builtin.h"

namespace scb::golden {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;

/// A worker runs the command; if there is a runner, a process of its own.
CommandEnd run_command(const GoldenRunSettings& settings, const std::vector<std::string>& command) {
    std::vector<std::string> words = {"--quiet", "--no-config", "--tell-inputs"};
    words.insert(words.end(), command.begin(), command.end());
    if (settings.runner.empty()) return settings.workers->run(settings, words);
    std::vector<std::string> program = settings.runner;
    program.push_back(settings.program);
    program.insert(program.end(), words.begin(), words.end());
    return run_process(settings, program);
}

std::string ended_with(int status) { return "It ended with status " + std::to_string(status); }

/// Why the command failed; empty if it did not. `inspect` ends with 1 if it has found wrong
/// rejections, which may be the purpose of the case.
std::string trouble(const CommandEnd& child, const GoldenRunSettings& settings, bool is_inspect) {
    if (child.stopped) return "It was interrupted.";
    if (!child.end)
        return "It took longer than " + std::to_string(settings.patience.count()) +
               " seconds and was ended.";
    if (child.end->by_signal)
        return "It was ended by signal " + std::to_string(child.end->code) + ".";
    const int status = child.end->code;
    if (status == exit_done || (status == exit_different && is_inspect)) return "";
    constexpr std::string_view start = "scb: error: ";
    std::string said = child.last_line;
    if (said.starts_with(start)) said.erase(0, start.size());
    return said.empty() ? ended_with(status) + "." : said;
}

/// Whether the scene is a built-in one whose meshes are not here.
bool lacks_meshes(const GoldenCase& golden, const GoldenRunSettings& settings) {
    const scenes::BuiltinScene* scene = scenes::find_builtin(golden.scene[0]);
    return scene != nullptr && !scenes::missing_mesh_file(*scene, settings.models).empty();
}

void move_file(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::rename(from, to, error);
    if (error)
        throw OutputError(to.string() + ": cannot be written (" + error.message() +
                          "); see that the disk has room.");
}

/// The picture of a case among those that index.json has: for `inspect` the summary, which is
/// followed by pictures of pairs of nodes; for others there must be only one.
const Json& only_picture(const GoldenCase& golden, const Json& index) {
    const Json& drawn = index.at("files");
    if (golden.run == GoldenRun::inspect) return drawn.at(0);
    if (drawn.size() != 1)
        throw InputError("It draws " + std::to_string(drawn.size()) +
                         " pictures, but a case has one; write one case for each picture. Give " +
                         (golden.run == GoldenRun::levels
                              ? "one frame, one volume, and one level with `--levels`."
                              : "one frame and one volume, and no option that adds pictures."));
    return drawn.at(0);
}

/// Whether it is about another engine's tests, for which this program records no trace.
bool of_recording(const GoldenCase& golden) {
    return !golden.command.empty() ||
           (golden.scene.size() == 1 && scenes::names_recording(golden.scene[0]));
}

/// Takes over the files that the command has left in `made`.
void take_over(const GoldenCase& golden, const CommandEnd& child, const fs::path& made,
               const fs::path& folder) {
    const CaseFiles files = case_files(folder, golden.name);
    Json document;
    if (has_picture(golden.run)) {
        const fs::path index = made / "index.json";
        if (!is_there(index))
            throw InputError(ended_with(child.end->code) + " and has made no index.json.");
        document = parse_json(read_text_file(index.string()), index.string());
        const Json& drawn = only_picture(golden, document);
        move_file(made / drawn.at("file").get<std::string>(), files.image);
        if (golden.ids) move_file(made / drawn.at("ids").get<std::string>(), files.ids);
        move_file(index, folder / (golden.name + ".index.json"));
    } else {
        document = parse_json(child.printed, "the output of the case");
    }
    write_file_whole(files.counts, case_counts(golden.run, document).dump(2) + "\n");
    const std::string command = typed(in_own_folder(golden), "DIR");
    write_file_whole(files.meta, record_json(command, document).dump(2) + "\n");
}

/// The option must win over SCB_MODELS, which a run would find in its environment.
void add_models(std::vector<std::string>& command, const GoldenRunSettings& settings) {
    if (!settings.models.empty()) command.insert(command.end(), {"--models", settings.models});
}

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

GoldenRunEnd run_case(const GoldenCase& golden, const GoldenRunSettings& settings,
                      const fs::path& folder) {
    const Clock::time_point start = Clock::now();
    GoldenRunEnd result;
    if (lacks_meshes(golden, settings)) {
        result.skipped = true;
        result.message = "The meshes of " + golden.scene[0] +
                         " are not here; name their folder with --models or SCB_MODELS.";
        return result;
    }
    const fs::path made = fs::absolute(folder) / (golden.name + ".made"),
                   recording = fs::absolute(folder) / (golden.name + ".scbrec");
    try {
        GoldenCase in_folder = in_own_folder(golden);
        if (!golden.command.empty()) {
            std::error_code none;
            fs::remove(recording, none);  // of a run that was killed
            const CommandEnd maker = run_process(settings, maker_of(golden, recording));
            std::string why = trouble(maker, settings, false);
            if (why.empty() && !is_there(recording))
                why = "It has not written the file that " + std::string(recording_here) +
                      " stands for.";
            if (!why.empty())
                throw InputError("Its command " + shell_word(golden.command[0]) + ": " + why);
            in_folder.scene = {recording.string()};
        }
        std::vector<std::string> command = command_of(in_folder, made);
        add_models(command, settings);
        if (has_picture(golden.run)) command.insert(command.end(), {"--gl", settings.gl});
        if (has_picture(golden.run) || !settings.mutation.of_pictures)
            command.insert(command.end(), settings.mutation.words.begin(),
                           settings.mutation.words.end());
        const CommandEnd child = run_command(settings, command);
        result.message = trouble(child, settings, golden.run == GoldenRun::inspect);
        result.stopped = child.stopped;
        result.lacked_gl = child.end == ProcessEnd{false, exit_no_gl};
        if (result.message.empty()) take_over(golden, child, made, folder);
        result.ran = result.message.empty();
    } catch (const InputError& error) {
        result.message = error.what();
    } catch (const Json::exception& error) {
        result.message = (has_picture(golden.run) ? "Its index.json is not as it should be: "
                                                  : "Unexpected output: ") +
                         std::string(error.what());
    }
    std::error_code ignored;
    fs::remove_all(made, ignored);
    if (!golden.command.empty()) fs::remove(recording, ignored);
    result.seconds = seconds_since(start);
    return result;
}

std::string record_trace(const GoldenCase& golden, const GoldenRunSettings& settings,
                         const fs::path& folder) {
    if (golden.run == GoldenRun::levels || of_recording(golden)) return "";
    const CaseFiles files = case_files(folder, golden.name);
    const std::string counts = files.counts.string(),
                      frame = only_frame(parse_json(read_text_file(counts), counts));
    if (frame.empty()) return "";
    std::vector<std::string> command =
        trace_command_of(in_own_folder(golden), frame, fs::absolute(files.trace));
    add_models(command, settings);
    return trouble(run_command(settings, command), settings, false);
}

std::string typed(const std::vector<std::string>& command) {
    std::string text = "scb";
    for (const std::string& word : command) text += " " + shell_word(word);
    return text;
}

std::string typed_maker(const GoldenCase& golden) {
    if (golden.command.empty()) return "";
    const fs::path recording = golden.scene[0];
    std::string maker;
    for (const std::string& word : maker_of(golden, recording.filename()))
        maker += (maker.empty() ? "" : " ") + shell_word(word);
    const std::string where = recording.parent_path().string();
    return (where.empty() ? maker : "(cd " + shell_word(where) + " && " + maker + ")") + " && ";
}

std::string typed(const GoldenCase& golden, const fs::path& folder) {
    return typed_maker(golden) + typed(command_of(golden, folder));
}

}  // namespace scb::golden
