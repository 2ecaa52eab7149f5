#pragma once

#include <array>
#include <string>

#include "core/analysis/trace.h"
#include "scenes/recordings/recording_file.h"

namespace scb::scenes {

/// Writes queries of this project as a recording, as another engine would record its own: meshes,
/// hierarchies, and frame by frame poses, tests and pairs.
class TraceRecording {
  public:
    TraceRecording(const TraceHeader& header, std::array<const Mesh*, 2> meshes,
                   std::array<const AnyHierarchy*, 2> hierarchies);

    /// Frames must be added ascending. `poses`: the poses of A and B.
    void add(const QueryTrace& frame, const std::array<Pose, 2>& poses);
    /// The whole file. Nothing may be added after it.
    std::string finish();

  private:
    RecordingWriter writer_;
    bool tests_triangles_;
    std::uint32_t bodies_;  ///< one in a self query, else two
};

}  // namespace scb::scenes
