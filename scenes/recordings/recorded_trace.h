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

/// Pairs that a query reported or missed.
struct RecordedResults {
    std::uint64_t reported = 0, missed = 0, wrong = 0;
    std::uint64_t grazing = 0;  ///< within the tolerance: not judged
};

/// The queries of two bodies of a recording as a trace, frame by frame, and the state of the bodies
/// at each of these frames.
class RecordedTrace {
  public:
    /// `bodies`: two names, "A,B"; may be empty if the recording has queries of one pair only.
    /// `frames`: a list, see frames_among, or auto_frames, the first frame with the most pairs.
    /// Throws InputError.
    RecordedTrace(std::shared_ptr<const Recording> recording, const std::string& bodies,
                  const std::string& frames);
    RecordedTrace(const std::string& path, const std::string& bodies, const std::string& frames,
                  const QuerySelection& selection = {})
        : RecordedTrace(std::make_shared<const Recording>(read_recording(path, selection)), bodies,
                        frames) {}
    /// The same queries, to be read again from the first frame.
    std::unique_ptr<RecordedTrace> rewound() const;

    const Recording& recording() const { return *recording_; }
    const TraceHeader& header() const { return header_; }
    const Scene& scene() const { return recording_->scene; }
    /// Indices into Scene::bodies.
    const std::array<std::size_t, 2>& sides() const { return sides_; }
    /// The chosen frames, ascending.
    const std::vector<int>& frames() const { return frames_; }
    /// All frames with a query of the two bodies.
    const std::vector<int>& all_frames() const { return all_frames_; }
    /// The body of a side at a chosen frame.
    const BodyAtFrame& body(std::size_t side, int frame) const;
    /// Whether the recording has pairs, or tests of items, anywhere.
    bool has_results() const { return recording_->file->summary.has_results(); }
    /// Whether the queries of distances at the chosen frames have the same limit and relative
    /// error.
    bool has_same_limits() const { return has_same_limits_; }
    /// The first chosen frame whose query ended early on purpose.
    std::optional<int> ended_early() const { return ended_early_; }
    /// The number of tests of volumes in the query of a chosen frame.
    std::uint64_t test_count(int frame) const { return test_counts_.at(frame); }
    /// The first query of the two bodies at a chosen frame; valid until another frame is requested.
    /// Frames must be requested in ascending order.
    const QueryTrace& frame(int number);
    /// The query that `queries` has read, if it is the first of the two bodies at a chosen frame;
    /// else null. Valid until the next call.
    const QueryTrace* frame_at(const RecordedQueries& queries);
    /// The query of the latest frame() as recorded; valid as long.
    const EngineQuery& query() const { return queries_->query(); }
    /// The best frame to show a test of two nodes, by their numbers: the first in which the test
    /// rejected overlapping volumes; else `usual`, if its query tested the nodes; else the first
    /// whose query did; else `usual`.
    int frame_of_test(IndexPair nodes, int usual) const;
    /// The attribution of that query's tests, by the exact verdict on the recorded volumes; empty
    /// if a pose is unusable.
    Attribution attribution();
    /// Compares the pairs reported by that query with the exact pairs, within the engine's
    /// tolerance, as RecordingJudgement does; empty if a pose is unusable.
    RecordedResults results();
    /// See level_overlaps of core/judge/query_contacts.h.
    std::vector<std::size_t> level_overlaps(std::size_t most);

  private:
    RecordedTrace(const RecordedTrace& other);
    bool is_wanted(const RecordedQueries& queries) const;
    const QueryTrace& set_frame(const EngineQuery& query);
    /// Chooses bodies and frames.
    void choose(const std::string& bodies, const std::string& frames);
    /// Reads the bodies at the chosen frames.
    void read_bodies();
    /// Sets the engine's data of the header, after all is read.
    void take_engine(const RecordedQueries& queries);
    void take_stages(const RecordedQueries& queries);
    /// Throws InputError if the chosen queries are not of one kind.
    void take_kind(const EngineQuery& query);

    std::shared_ptr<const Recording> recording_;
    std::array<std::size_t, 2> sides_{};
    std::array<std::uint32_t, 2> numbers_{};  ///< of the bodies in the recording
    std::vector<int> frames_, all_frames_;
    TraceHeader header_;
    std::map<std::uint8_t, Stage> stages_;
    std::map<int, std::array<BodyAtFrame, 2>> bodies_;
    std::map<int, std::uint64_t> test_counts_;
    bool has_same_limits_ = true;
    std::optional<int> ended_early_;
    std::unique_ptr<RecordedQueries> queries_;
    QueryTrace frame_;
    std::optional<int> latest_;   ///< the frame of the latest frame()
    std::optional<int> visited_;  ///< the frame of the latest frame_at() that was not null
    OwnContacts own_;
};

}  // namespace scb::scenes
