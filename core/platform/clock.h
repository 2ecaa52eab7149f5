#pragma once

namespace scb {

/// Clocks that time queries and builds.
enum class Clock {
    wall,     ///< the time that passes, where threads share the work
    thread,   ///< processor time of this thread, without other programs of a shared machine
    process,  ///< processor time of all threads of this program
};

/// The time of a clock, in milliseconds.
double milliseconds(Clock clock);

/// The milliseconds between two readings of a clock with nothing between them, the median of many:
/// some 0.2 us of processor time, a fifth of the quickest queries.
double reading_milliseconds(Clock clock);

}  // namespace scb
