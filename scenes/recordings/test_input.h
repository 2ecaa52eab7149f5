#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scenes/recordings/recorded_trace.h"
#include "scenes/recordings/trace_file.h"
#include "scenes/scene/motion.h"

namespace scb::scenes {

/// Queries with all their tests from a file, frame after frame: of a trace, or of a recording.
class TestInput {
  public:
    /// `frames`: a list, see frames_among; auto_frames is a recording's frame with the most pairs,
    /// and all frames of a trace. `bodies`: as in RecordedTrace. Reads the whole file once, so that
    /// an invalid file gives no partial answer. Throws InputError.
    TestInput(const std::string& path, const std::string& frames, const std::string& bodies = {},
              const QuerySelection& selection = {});
    TestInput(std::shared_ptr<const Recording> recording, const std::string& frames,
              const std::string& bodies);
    TestInput(const TestInput&) = delete;
    TestInput& operator=(const TestInput&) = delete;

    const TraceHeader& header() const;
    /// The chosen frames, and all frames, ascending.
    const std::vector<int>& frames() const;
    const std::vector<int>& all_frames() const;
    /// The poses of B in A's frame at all frames of a trace.
    const std::vector<PoseKey>& poses() const { return poses_; }
    /// The query of a frame, valid until the next call. Frames must be requested in ascending
    /// order. Throws InputError if there is no such frame.
    const QueryTrace& frame(int number);
    /// The query of the next chosen frame; nullptr at the end.
    const QueryTrace* next();
    /// The recording; null if the file is a trace.
    RecordedTrace* recorded() const { return recorded_.get(); }

  private:
    std::string path_, bytes_;  ///< of a trace
    std::vector<int> frames_, all_frames_;
    std::vector<PoseKey> poses_;
    std::unique_ptr<TraceReader> trace_;
    std::unique_ptr<RecordedTrace> recorded_;  ///< only one of the two is set
    std::size_t next_ = 0;
};

}  // namespace scb::scenes
