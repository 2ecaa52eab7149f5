#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scenes/recordings/recorded_trace.h"
#include "scenes/traces/trace_input.h"

namespace scb::scenes {

/// Queries with all their tests from a file, frame after frame: of a trace, or of a recording.
class TestInput {
  public:
    /// `frames`: a list, see frames_among. `bodies`: as in RecordedTrace. Reads the whole file
    /// once, so that an invalid file gives no partial answer. Throws InputError.
    TestInput(const std::string& path, const std::string& frames, const std::string& bodies = {});

    const TraceHeader& header() const;
    std::size_t frame_count() const { return frames_.size(); }
    /// The next frame, valid until the next call; nullptr at the end.
    const TraceFrame* next();

  private:
    std::vector<int> frames_;
    std::size_t next_ = 0;
    std::unique_ptr<TraceInput> trace_;
    std::unique_ptr<RecordedTrace> recorded_;  ///< only one of the two is set
};

}  // namespace scb::scenes
