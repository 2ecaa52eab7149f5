#pragma once

#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/pictures/picture_run.h"
#include "app/study/query_sources.h"
#include "core/base/exit_status.h"

namespace scb::app {

/// The queries of the sources at a frame.
inline QueryFrames queries_at(QuerySources& sources, int frame) {
    QueryFrames queries;
    for (QuerySource& source : sources) queries.push_back(&source.frame(frame));
    return queries;
}

/// Calls `make(frame, watch)` for each frame to show until a signal comes; then finishes the
/// pictures with the index from `head`, or the shard. `make` returns whether it made the whole
/// frame; it may stop between two pictures if the watch has a signal. Returns the exit status.
template <class Make, class Head>
int make_frames(const QuerySources& sources, PictureRun& pictures, const Console& console,
                Make make, Head head) {
    const InterruptWatch watch;
    const std::vector<int>& frames = sources.front().frames();
    Progress progress(console, frames.size());
    std::size_t done = 0;
    for (; done < frames.size() && watch.signal() == 0; ++done) {
        if (!make(frames[done], watch)) break;
        progress.step("frames");
    }
    const bool all = done == frames.size();
    if (!pictures.is_shard())
        pictures.finish(head(), console);
    else if (all)
        pictures.finish_shard(console);
    if (all) return exit_done;
    console.note("scb: interrupted; " +
                 (pictures.is_shard() ? "the shard is to be made again."
                                      : std::to_string(done) + " of " +
                                            std::to_string(frames.size()) + " frames are drawn."));
    return exit_interrupted(watch.signal());
}

/// The same, with each frame as a part of the run. `draw(queries)` draws a frame and returns a
/// value for `take`, which also gets the values from shards.
template <class Draw, class Take, class Head>
int draw_frames(QuerySources& sources, PictureRun& pictures, const Console& console, Draw draw,
                Take take, Head head) {
    pictures.plan(sources.front().frames().size(), [&] { return subject_of(sources); });
    return make_frames(
        sources, pictures, console,
        [&](int frame, const InterruptWatch&) {
            return pictures.part([&] { return draw(queries_at(sources, frame)); }, take);
        },
        head);
}

/// For pictures without values to collect.
inline void take_nothing(const nlohmann::ordered_json&) {}

}  // namespace scb::app
