#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/attribution.h"
#include "scenes/recordings/own_contacts.h"
#include "scenes/recordings/recorded_bodies.h"

namespace scb::scenes {

/// Pairs that a query reported, or did not.
struct RecordedResults {
    std::uint64_t reported = 0, missed = 0, wrong = 0;
    std::uint64_t grazing = 0;  ///< within the tolerance: not judged
};

/// The queries of two bodies of a recording as traces have them, frame by frame, and what there is
/// of the bodies at each of these frames.
class RecordedTrace {
  public:
    /// `bodies` names two, "A,B", or is empty where the recording has queries of two only; `frames`
    /// is a list, see frames_among, or auto_frames: the first with the most pairs. Throws
    /// InputError.
    RecordedTrace(std::shared_ptr<const Recording> recording, const std::string& bodies,
                  const std::string& frames);
    RecordedTrace(const std::string& path, const std::string& bodies, const std::string& frames)
        : RecordedTrace(std::make_shared<const Recording>(read_recording(path)), bodies, frames) {}
    RecordedTrace(const RecordedTrace&) = delete;

    const Recording& recording() const { return *recording_; }
    const TraceHeader& header() const { return header_; }
    const Scene& scene() const { return recording_->scene; }
    /// Indices of Scene::bodies.
    const std::array<std::size_t, 2>& sides() const { return sides_; }
    /// Ascending.
    const std::vector<int>& frames() const { return frames_; }
    /// All that have a query of the two; those above are among them.
    const std::vector<int>& all_frames() const { return all_frames_; }
    /// One of the two at one of these frames.
    const BodyAtFrame& body(std::size_t side, int frame) const;
    /// Whether it tells of pairs, or of tests of items, anywhere.
    bool tells_results() const { return recording_->file->summary.tells_results(); }
    /// How many tests of volumes there are in it.
    std::uint64_t test_count(int frame) const { return test_counts_.at(frame); }
    /// The first query of them at one of these frames; valid until the next call. They must be
    /// asked for ascending.
    const TraceFrame& frame(int number);
    /// The same query as its engine tells of it; valid as long.
    const EngineQuery& query() const { return queries_->query(); }
    /// The frame that shows most of a test of these nodes, by their numbers: the first in which the
    /// test rejected volumes that overlap; else `usual`, if its query tested the nodes; else the
    /// first whose query did; else `usual`.
    int frame_of_test(IndexPair nodes, int usual) const;
    /// What the tests of that query are worth, by the exact verdict on the engine's own volumes;
    /// nothing where a body has no pose.
    Attribution attribution();
    /// What that query reported against the exact pairs, with the engine's rounding, as
    /// RecordingJudgement has it; nothing where a body has no pose.
    RecordedResults results();
    /// See query_overlaps.h.
    std::vector<std::size_t> level_overlaps(std::size_t most);

  private:
    bool is_wanted(const RecordedQueries& queries) const;
    /// Chooses bodies and frames.
    void choose(const std::string& bodies, const std::string& frames);
    /// Reads what there is of the bodies.
    void read_bodies();
    /// What is known of the engine when all is read.
    void take_engine(const RecordedQueries& queries);
    void take_stages(const RecordedQueries& queries);

    std::shared_ptr<const Recording> recording_;
    std::array<std::size_t, 2> sides_{};
    std::array<std::uint32_t, 2> numbers_{};  ///< of the bodies in the recording
    std::vector<int> frames_, all_frames_;
    TraceHeader header_;
    std::map<std::uint8_t, Stage> stages_;
    std::map<int, std::array<BodyAtFrame, 2>> bodies_;
    std::map<int, std::uint64_t> test_counts_;
    std::unique_ptr<RecordedQueries> queries_;
    TraceFrame frame_;
    OwnContacts own_;
};

}  // namespace scb::scenes
