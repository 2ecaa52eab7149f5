#pragma once

#include <memory>

#include "app/query/scene_query.h"
#include "scenes/traces/trace_input.h"

namespace scb::app {

/// Queries with all their tests, frame by frame: made now, or read from a trace. Whoever draws them
/// cannot tell which.
class QuerySource {
  public:
    /// Of a scene; or, where the one name is that of a trace, of the scene that it names, which
    /// must still have the same meshes. Throws InputError.
    QuerySource(const SceneOptions& scene, const HierarchyOptions& hierarchy,
                const QueryOptions& query, const QueryLimits& limits);

    const SceneQuery& query() const { return query_; }
    const TraceHeader& header() const { return header_; }
    /// The frames that were asked for, ascending.
    const std::vector<int>& frames() const { return query_.frames; }

    /// The query of one of these frames; valid until the next call. They must be asked for
    /// ascending. Throws InputError where a trace says that the bodies were elsewhere.
    const TraceFrame& frame(int number);

  private:
    void open_trace(const SceneOptions& scene, const std::string& frames);

    SceneQuery query_;
    TraceHeader header_;
    std::unique_ptr<scenes::TraceInput> trace_;  ///< null where queries are made now
    std::string trace_path_;
    TraceFrame made_;
    EventRecorder recorder_;
};

}  // namespace scb::app
