#include "scenes/recordings/test_input.h"

#include "core/platform/number_list.h"
#include "scb/error.h"
#include "scenes/recordings/recording_input.h"

namespace scb::scenes {

TestInput::TestInput(const std::string& path, const std::string& frames, const std::string& bodies,
                     const QuerySelection& selection)
    : path_(path) {
    if (names_recording(path)) {
        recorded_ = std::make_unique<RecordedTrace>(path, bodies, frames, selection);
        return;
    }
    if (!selection.empty())
        throw InputError(selection.words() + ": " + path +
                         " is a trace, whose queries have no names and tags; leave it out.");
    bytes_ = trace_bytes(path);
    TraceReader whole(as_bytes(bytes_), path);
    while (const QueryTrace* frame = whole.next()) {
        poses_.push_back({frame->frame, frame->b_to_a});
        all_frames_.push_back(frame->frame);
    }
    if (all_frames_.empty()) throw InputError(path + " has no frames; record it again.");
    frames_ = frames == auto_frames ? all_frames_
                                    : frames_among(all_frames_, frames, path, "a trace may have");
    trace_ = std::make_unique<TraceReader>(as_bytes(bytes_), path);
}

TestInput::TestInput(std::shared_ptr<const Recording> recording, const std::string& frames,
                     const std::string& bodies)
    : recorded_(std::make_unique<RecordedTrace>(std::move(recording), bodies, frames)) {}

const TraceHeader& TestInput::header() const {
    return recorded_ ? recorded_->header() : trace_->header();
}

const std::vector<int>& TestInput::frames() const {
    return recorded_ ? recorded_->frames() : frames_;
}

const std::vector<int>& TestInput::all_frames() const {
    return recorded_ ? recorded_->all_frames() : all_frames_;
}

const QueryTrace& TestInput::frame(int number) {
    if (recorded_) return recorded_->frame(number);
    const QueryTrace* frame = trace_->next();
    while (frame != nullptr && frame->frame < number) frame = trace_->next();
    if (frame == nullptr || frame->frame != number)
        throw InputError(path_ + ": it has no frame " + std::to_string(number) + " any more.");
    return *frame;
}

const QueryTrace* TestInput::next() {
    return next_ == frames().size() ? nullptr : &frame(frames()[next_++]);
}

}  // namespace scb::scenes
