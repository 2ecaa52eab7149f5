#include "core/platform/clock.h"

#include <time.h>

#include <vector>

#include "core/base/statistics.h"

namespace scb {
namespace {

clockid_t id_of(Clock clock) {
    if (clock == Clock::wall) return CLOCK_MONOTONIC;
    return clock == Clock::thread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_PROCESS_CPUTIME_ID;
}

}  // namespace

double milliseconds(Clock clock) {
    timespec now{};
    clock_gettime(id_of(clock), &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double reading_milliseconds(Clock clock) {
    std::vector<double> readings(1001);
    for (double& reading : readings) {
        const double start = milliseconds(clock);
        reading = milliseconds(clock) - start;
    }
    return median(readings);
}

}  // namespace scb
