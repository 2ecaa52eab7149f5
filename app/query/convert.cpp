#include <memory>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/progress.h"
#include "app/query/output_guard.h"
#include "core/base/exit_status.h"
#include "core/platform/output_file.h"
#include "scb/error.h"
#include "scenes/recordings/join_recordings.h"
#include "scenes/recordings/recording_input.h"
#include "scenes/recordings/recording_json.h"

namespace scb::app {
namespace {

constexpr std::size_t kilobyte = 1024;

struct ConvertOptions {
    std::vector<std::string> inputs;
    std::string output;
};

/// Writes the joined recordings, and returns the number of bytes.
template <class Writer>
std::size_t write_joined(std::vector<scenes::RecordingReader>& readers, WholeFile& file,
                         Progress& progress) {
    Writer writer;
    std::size_t written = 0;
    const auto append = [&](const std::string& bytes) {
        file.append(bytes);
        written += bytes.size();
    };
    scenes::join_recordings(readers, [&](const scenes::Record& record) {
        writer.add(record);
        constexpr std::size_t many = 1 << 20;
        if (writer.size() >= many) append(writer.take());
        std::size_t read = 0;
        for (const scenes::RecordingReader& reader : readers) read += reader.bytes_read();
        progress.at("kilobytes", read / kilobyte);
    });
    append(writer.finish());
    return written;
}

int run(const ConvertOptions& options, const Console& console) {
    const bool json = options.output.ends_with(".jsonl");
    if (!json && !options.output.ends_with(".scbrec"))
        throw InputError("-o " + options.output +
                         ": the ending says what to write; name a file .scbrec or .jsonl.");
    check_output(options.output, "-o");
    std::vector<scenes::RecordingBytes> files;
    for (const std::string& input : options.inputs) files.push_back(scenes::recording_bytes(input));
    check_output(options.output, "-o");
    std::vector<scenes::RecordingReader> readers;
    for (std::size_t i = 0; i < files.size(); ++i)
        readers.emplace_back(files[i], options.inputs[i]);
    std::size_t size = 0;
    for (const scenes::RecordingBytes& file : files) size += file.size();
    Progress progress(console, size / kilobyte);
    WholeFile output(options.output);
    const std::size_t bytes =
        json ? write_joined<scenes::RecordingJsonWriter>(readers, output, progress)
             : write_joined<scenes::RecordingWriter>(readers, output, progress);
    output.finish();
    for (const scenes::RecordingReader& reader : readers)
        if (!reader.damage().empty()) console.alarm("scb: " + reader.damage());
    console.note(
        "scb: " + options.output + ": " + std::to_string(bytes) + " bytes" +
        (files.size() == 1 ? "." : ", of " + std::to_string(files.size()) + " recordings."));
    return exit_done;
}

}  // namespace

void add_convert(const Command& program, const Console& console, Action& action) {
    const Command command = program.add_subcommand(
        "convert", "Convert recordings to and from JSON Lines, or join those of several threads");
    const auto options = std::make_shared<ConvertOptions>();
    command
        .add_option("RECORDING", options->inputs,
                    "Recordings, as scb_record.h writes them, or their twins in JSON Lines")
        .required()
        .file({".scbrec", ".jsonl"})
        .type_name("");
    command.add_option("-o,--output", options->output, "The file: .scbrec or .jsonl")
        .required()
        .file({".scbrec", ".jsonl"})
        .only_typed();
    command.footer(
        "Records keep every bit. Several recordings must come from the threads of one program: "
        "records that they share are written\nonce, and their queries follow frame by frame, in "
        "the order of the files. A damaged file is converted up to its last whole block.\n\n"
        "Examples:\n"
        "  scb convert engine.scbrec -o engine.jsonl\n"
        "  scb convert thread-0.scbrec thread-1.scbrec -o engine.scbrec");
    command.callback([&action, &console, options] {
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
