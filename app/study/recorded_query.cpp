#include "app/study/recorded_query.h"

#include <utility>

namespace scb::app {

scenes::TraceRecording recording_of(const SceneOptions& scene, const SceneQuery& query,
                                    const std::string& layout) {
    const auto traced = [&query](std::size_t body) {
        const std::size_t mesh = query.scene.bodies[body].mesh;
        return scenes::TracedBody{&query.mesh(body), &query.hierarchy(body),
                                  query.packed_trees.empty() ? nullptr : &query.packed_trees[mesh]};
    };
    return {trace_header(scene, query), {traced(query.a), traced(query.b)}, layout};
}

QueryTrace traced_query(const SceneQuery& query, int frame) {
    QueryTrace traced;
    query.trace(frame, traced);
    return traced;
}

}  // namespace scb::app
