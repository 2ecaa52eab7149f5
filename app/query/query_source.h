#pragma once

#include <array>
#include <memory>

#include "app/query/scene_query.h"
#include "scenes/recordings/recorded_trace.h"
#include "scenes/traces/trace_input.h"

namespace scb::app {

/// Queries with all their tests, frame by frame: made now, read from a trace, or from another
/// engine's recording. Whoever draws them cannot tell which.
class QuerySource {
  public:
    /// Of a scene; or, where the one name is that of a trace, of the scene that it names, which
    /// must still have the same meshes; or of a recording, where `recorded` says so, and else of
    /// its meshes and poses. Throws InputError.
    QuerySource(const SceneOptions& scene, const HierarchyOptions& hierarchy,
                const QueryOptions& query, const QueryLimits& limits, bool recorded);
    /// Of the bodies and frames of a recording that the options name. Throws InputError.
    QuerySource(std::shared_ptr<const scenes::Recording> recording, const QueryOptions& query);

    /// What this project builds and asks itself: not of a recording.
    const SceneQuery& query() const { return query_; }
    bool is_recording() const { return recorded_ != nullptr; }
    const TraceHeader& header() const { return recorded_ ? recorded_->header() : header_; }
    const scenes::Scene& scene() const { return recorded_ ? recorded_->scene() : query_.scene; }
    /// The body A (0) or B (1), as an index of Scene::bodies.
    std::size_t body_index(std::size_t side) const;
    /// What there is of it at one of the frames.
    scenes::BodyAtFrame body(std::size_t side, int frame) const;
    /// The frames that were asked for, ascending.
    const std::vector<int>& frames() const {
        return recorded_ ? recorded_->frames() : query_.frames;
    }
    /// All that the trace or the recording has of these bodies; of a scene those that were asked
    /// for.
    std::vector<int> all_frames() const;

    /// How many tests of volumes the query of a frame has; made, or read, for this alone.
    std::uint64_t test_count(int frame) const;

    /// The query of one of these frames; valid until the next call. They must be asked for
    /// ascending. Throws InputError where a trace says that the bodies were elsewhere.
    const TraceFrame& frame(int number);
    /// The verdicts on the tests of the query that was asked for last.
    Attribution attribution(const TraceFrame& frame);
    /// Of its two bodies, see core/analysis/level_overlaps.h: by the query's own test, or, of a
    /// recording, by the exact verdict on its volumes.
    std::vector<std::size_t> level_overlaps(const TraceFrame& frame, std::size_t most);

  private:
    void open_trace(const SceneOptions& scene, const std::string& frames);

    SceneQuery query_;
    TraceHeader header_;
    std::unique_ptr<scenes::TraceInput> trace_;  ///< null where queries are made now
    std::string trace_path_;
    TraceFrame made_;
    StepRecorder recorder_;
    /// Of the two bodies, where they were asked for.
    mutable std::array<std::shared_ptr<const Tree>, 2> trees_;
    std::unique_ptr<scenes::RecordedTrace> recorded_;  ///< null but of a recording
};

}  // namespace scb::app
