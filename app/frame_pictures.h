#pragma once

#include "app/exit_status.h"
#include "app/interrupt.h"
#include "app/picture_run.h"
#include "app/progress.h"
#include "app/query_source.h"

namespace scb {

/// Calls `draw` for each frame that was asked for, with its query, until a signal comes; then
/// finishes the pictures with the index that `head` gives. Returns the exit status.
template <class Draw, class Head>
int draw_frames(QuerySource& source, PictureRun& pictures, const Console& console, Draw draw,
                Head head) {
    const InterruptWatch watch;
    const std::vector<int>& frames = source.frames();
    Progress progress(console, frames.size());
    std::size_t done = 0;
    for (; done < frames.size() && watch.signal() == 0; ++done) {
        draw(source.frame(frames[done]));
        progress.step("frames");
    }
    pictures.finish(head());
    if (done == frames.size()) return exit_done;
    console.note("scb: interrupted; " + std::to_string(done) + " of " +
                 std::to_string(frames.size()) + " frames are drawn.");
    return exit_interrupted(watch.signal());
}

}  // namespace scb
