#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/recordings/record.h"
#include "scenes/recordings/recording_block.h"

namespace scb::scenes {

/// The queries of a recording that a command reads: with this name, and with this tag. Empty: any.
struct QuerySelection {
    std::string name, tag;

    bool empty() const { return name.empty() && tag.empty(); }
    bool has(const RecordedQuery& query) const;
    /// "--query lift --tag grasp".
    std::string words() const;
    /// For titles: "\"lift\", tag grasp"; empty without a selection.
    std::string title() const;
};

/// Names of bodies of a whole recording; frames, stages and counts of the selected queries.
struct RecordingSummary {
    /// The recorded frames, ascending; of a selection, the frames of its queries. Only 0 if there
    /// is none.
    std::vector<int> frames;
    std::set<std::uint8_t> stages;  ///< stages at which tests rejected
    std::uint64_t queries = 0, volume_tests = 0, item_tests = 0, pairs = 0;
    std::uint64_t measures = 0;  ///< queries of distances
    std::uint64_t answers = 0;   ///< distances that queries found
    /// Whether the setting `results` announces recorded pairs, though there may be none.
    bool has_pairs = false;
    /// Whether it has pairs, distances, or tests of items, anywhere.
    bool has_results() const { return has_pairs || pairs + answers + item_tests > 0; }
    /// By number. Names differ from each other, and have no comma, which separates two names.
    std::map<std::uint32_t, std::string> body_names;
};

/// Reads the whole recording once. Throws InputError as RecordingReader does, and if a selection
/// has no query.
RecordingSummary summary_of(const RecordingBytes& bytes, std::string_view name,
                            const QuerySelection& selection = {});

/// The bytes of a recording with its summary, shared by all that read the recording.
struct RecordingFile {
    std::string path;  ///< begins each error
    RecordingBytes bytes;
    QuerySelection selection;
    RecordingSummary summary;

    /// Reads the file. Throws InputError as recording_bytes and summary_of do.
    explicit RecordingFile(const std::string& name, QuerySelection selected = {});
    RecordingFile(std::string of_file, std::string name, QuerySelection selected = {})
        : RecordingFile(RecordingBytes(std::move(of_file)), std::move(name), std::move(selected)) {}
    RecordingFile(RecordingBytes of_file, std::string name, QuerySelection selected = {});
    /// The path, and the selection if there is one, for messages.
    std::string title() const;
};

/// Text of a recording as reports show it: printable, and not longer than 500 characters.
std::string shown(std::string text);

}  // namespace scb::scenes
