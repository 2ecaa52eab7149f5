#include "scenes/recordings/test_input.h"

#include "scenes/recordings/recording_input.h"

namespace scb::scenes {

TestInput::TestInput(const std::string& path, const std::string& frames,
                     const std::string& bodies) {
    if (names_recording(path)) {
        recorded_ = std::make_unique<RecordedTrace>(path, bodies, frames);
        frames_ = recorded_->frames();
    } else {
        frames_ = frames_in_trace(path, frames);
        trace_ = std::make_unique<TraceInput>(path);
    }
}

const TraceHeader& TestInput::header() const {
    return recorded_ ? recorded_->header() : trace_->reader.header();
}

const TraceFrame* TestInput::next() {
    if (next_ == frames_.size()) return nullptr;
    const int wanted = frames_[next_++];
    if (recorded_) return &recorded_->frame(wanted);
    const TraceFrame* frame = trace_->reader.next();
    while (frame != nullptr && frame->frame < wanted) frame = trace_->reader.next();
    return frame;
}

}  // namespace scb::scenes
