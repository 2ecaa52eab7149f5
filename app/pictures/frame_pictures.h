#pragma once

#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/pictures/picture_run.h"
#include "app/query/query_sources.h"
#include "core/base/exit_status.h"

namespace scb::app {

/// Calls `draw(queries, watch)` for each frame that was asked for until a signal comes; then
/// finishes the pictures with the index that `head` gives. `draw` returns whether it drew all of
/// the frame, and may stop between two pictures where the watch has a signal. Returns the exit
/// status.
template <class Draw, class Head>
int draw_frames(QuerySources& sources, PictureRun& pictures, const Console& console, Draw draw,
                Head head) {
    const InterruptWatch watch;
    const std::vector<int>& frames = sources.front().frames();
    Progress progress(console, frames.size());
    std::size_t done = 0;
    for (; done < frames.size() && watch.signal() == 0; ++done) {
        QueryFrames queries;
        for (QuerySource& source : sources) queries.push_back(&source.frame(frames[done]));
        if (!draw(queries, watch)) break;
        progress.step("frames");
    }
    pictures.finish(head(), console);
    if (done == frames.size()) return exit_done;
    console.note("scb: interrupted; " + std::to_string(done) + " of " +
                 std::to_string(frames.size()) + " frames are drawn.");
    return exit_interrupted(watch.signal());
}

}  // namespace scb::app
