#include "app/study/query_timing.h"

#include <time.h>

#include <utility>

#include "core/base/statistics.h"

namespace scb::app {
namespace {

/// Processor time of this thread, which excludes other programs on a shared machine. With `wall`
/// the time of day, which includes the work of other threads.
double milliseconds(bool wall) {
    timespec now{};
    clock_gettime(wall ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

}  // namespace

Collision collision_of(PackedCollision found) {
    Collision result;
    result.pairs = std::move(found.pairs);
    result.n_v = found.n_v;
    result.n_p = found.n_p;
    result.complete = found.complete;
    return result;
}

Collision collision_of(const PackedTouch& found) {
    Collision result;
    if (found.pair) result.pairs = {*found.pair};
    result.n_v = found.n_v;
    result.n_p = found.n_p;
    result.complete = !found.pair;
    return result;
}

std::optional<std::vector<std::vector<double>>> time_queries(const QueryTiming& timing) {
    const std::size_t subjects = timing.subjects, frames = timing.frames;
    // Per subject, per frame, per repeat.
    std::vector<std::vector<std::vector<double>>> ms(subjects);
    for (auto& of_subject : ms) of_subject.resize(frames);
    const bool cold = timing.order == BenchOrder::cold;
    for (int repeat = 0; repeat < timing.repeats; ++repeat)
        for (std::size_t k = 0; k < subjects * frames; ++k) {
            const std::size_t s = cold ? k % subjects : k / frames;
            const std::size_t i = cold ? k / subjects : k % frames;
            if (timing.before) timing.before(s, i);
            const double start = milliseconds(timing.wall);
            const Collision found = timing.query(s, i);
            ms[s][i].push_back(milliseconds(timing.wall) - start);
            if (repeat == 0 && timing.keep) timing.keep(s, i, found);
            if (!timing.step()) return std::nullopt;
        }
    std::vector<std::vector<double>> medians(subjects);
    for (std::size_t s = 0; s < subjects; ++s)
        for (const std::vector<double>& repeats : ms[s]) medians[s].push_back(median(repeats));
    return medians;
}

}  // namespace scb::app
