#pragma once

#include <array>
#include <memory>

#include "app/study/scene_query.h"
#include "scenes/recordings/test_input.h"

namespace scb::app {

/// Queries with all their tests, frame by frame: made now, read from a trace, or from another
/// engine's recording. Pictures treat all three alike.
class QuerySource {
  public:
    /// The queries of a scene. If its one name is a trace: of the scene that the trace names, which
    /// must still have the same meshes. If it is a recording: the recorded queries if `recorded`,
    /// else queries of its meshes and poses. Throws InputError.
    QuerySource(const SceneOptions& scene, const HierarchyOptions& hierarchy,
                const QueryOptions& query, const QueryLimits& limits, bool recorded);
    /// The recorded queries of the bodies and frames in the options. Throws InputError.
    QuerySource(std::shared_ptr<const scenes::Recording> recording, const QueryOptions& query);

    /// The query that this project makes; not for recordings.
    const SceneQuery& query() const { return query_; }
    bool is_recording() const { return recorded() != nullptr; }
    /// Whether it makes its queries itself: no trace, no recorded queries.
    bool makes_queries() const { return input_ == nullptr; }
    /// The recorded queries; null for other sources.
    scenes::RecordedTrace* recorded() const { return input_ ? input_->recorded() : nullptr; }
    const TraceHeader& header() const { return input_ ? input_->header() : header_; }
    const scenes::Scene& scene() const {
        return is_recording() ? recorded()->scene() : query_.scene;
    }
    /// The body A (0) or B (1), as an index of Scene::bodies.
    std::size_t body_index(std::size_t side) const;
    /// The body at one of the frames.
    BodyAtFrame body(std::size_t side, int frame) const;
    /// The frames to show, ascending.
    const std::vector<int>& frames() const {
        return is_recording() ? recorded()->frames() : query_.frames;
    }
    /// All frames that the trace or recording has of these bodies; for a scene, frames().
    const std::vector<int>& all_frames() const {
        return input_ ? input_->all_frames() : query_.frames;
    }

    /// Throws InputError for a trace or a recording of distances, of commands that would take its
    /// queries for queries of overlap.
    void refuse_distances() const;

    /// The number of volume tests in the query of a frame; makes or reads the query.
    std::uint64_t test_count(int frame) const;

    /// The query of one of these frames; valid until the next call. Ask for frames in ascending
    /// order. Throws InputError if the bodies of a trace had other poses.
    const QueryTrace& frame(int number);
    /// The query of a frame, in any order of frames: makes or reads the query again.
    QueryTrace frame_again(int number) const;
    /// The verdicts on the tests of a query; of a recording, only of the latest frame().
    Attribution attribution(const QueryTrace& frame) const;
    /// Of the two bodies, see core/analysis/level_overlaps.h: by the query's own test; in a
    /// recording, by the exact verdict on its volumes.
    std::vector<std::size_t> level_overlaps(const QueryTrace& frame, std::size_t most) const;

  private:
    void open_trace(const SceneOptions& scene, const std::string& frames);

    SceneQuery query_;
    TraceHeader header_;                        ///< of queries made now
    std::unique_ptr<scenes::TestInput> input_;  ///< null if queries are made now
    std::string trace_path_;
    QueryTrace made_;
    /// Of the two bodies, built on demand.
    mutable std::array<std::shared_ptr<const Tree>, 2> trees_;
};

/// Throws InputError for recorded queries of distances, of commands that would take them for
/// queries of overlap. Of other headers, does nothing.
void refuse_recorded_distances(const TraceHeader& header);

/// Notes the queries of a recording that are left out, since they are not the first of their frame.
void note_left_out(const scenes::RecordedTrace& recorded, const Note& note);

}  // namespace scb::app
