#include "app/study/query_timing.h"

#include <algorithm>
#include <utility>

#include "core/base/statistics.h"
#include "core/platform/clock.h"

namespace scb::app {

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

Collision collision_of(PackedWithin found) {
    Collision result;
    result.pairs = std::move(found.pairs);
    result.n_v = found.n_v;
    result.n_p = found.n_p;
    return result;
}

Distance distance_of(const PackedDistance& found) {
    Distance result;
    result.found = found.found;
    result.triangles = found.triangles;
    result.n_v = found.n_v;
    result.n_p = found.n_p;
    return result;
}

std::optional<std::vector<std::vector<double>>> time_queries(const QueryTiming& timing) {
    const std::size_t subjects = timing.subjects, frames = timing.frames;
    // Per subject, per frame, per repeat.
    std::vector<std::vector<std::vector<double>>> ms(subjects);
    for (auto& of_subject : ms) of_subject.resize(frames);
    const bool cold = timing.order == BenchOrder::cold;
    const Clock clock = timing.wall ? Clock::wall : Clock::thread;
    const double reading = reading_milliseconds(clock);
    for (int repeat = 0; repeat < timing.repeats; ++repeat)
        for (std::size_t k = 0; k < subjects * frames; ++k) {
            const std::size_t s = cold ? k % subjects : k / frames;
            const std::size_t i = cold ? k / subjects : k % frames;
            if (timing.before) timing.before(s, i);
            const double start = milliseconds(clock);
            const QueryAnswer answer = timing.query(s, i);
            ms[s][i].push_back(std::max(0.0, milliseconds(clock) - start - reading));
            if (repeat == 0 && timing.keep) timing.keep(s, i, answer);
            if (!timing.step()) return std::nullopt;
        }
    std::vector<std::vector<double>> medians(subjects);
    for (std::size_t s = 0; s < subjects; ++s)
        for (const std::vector<double>& repeats : ms[s]) medians[s].push_back(median(repeats));
    return medians;
}

}  // namespace scb::app
