#pragma once

#include <array>
#include <string>

#include "core/analysis/trace.h"
#include "core/model/packed_tree.h"
#include "scenes/recordings/recording_file.h"

namespace scb::scenes {

/// A body of the queries to record.
struct TracedBody {
    const Mesh* mesh = nullptr;
    const AnyHierarchy* hierarchy = nullptr;
    const PackedTree* packed = nullptr;  ///< null: queries run on the hierarchy itself
};

/// Writes queries of this project as a recording, as another engine would record its own: meshes,
/// hierarchies, and frame by frame poses, tests and pairs. Nodes of a packed hierarchy have the
/// numbers and volumes of the hierarchy that was packed. These volumes are inside of the packed
/// volumes, so a packed test never rejects two of them that meet.
class TraceRecording {
  public:
    /// `layout`: the name of the packed layout; empty: none.
    TraceRecording(const TraceHeader& header, const std::array<TracedBody, 2>& bodies,
                   const std::string& layout = "");

    /// Frames must be added ascending. Steps have the nodes of the hierarchies. `poses`: the poses
    /// of A and B.
    void add(const QueryTrace& frame, const std::array<Pose, 2>& poses);
    /// The whole file. Nothing may be added after it.
    std::string finish();

  private:
    RecordingWriter writer_;
    bool tests_triangles_;
    bool is_packed_;
    std::uint32_t bodies_;  ///< one in a self query, else two
};

}  // namespace scb::scenes
