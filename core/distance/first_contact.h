#pragma once

#include <cstdint>
#include <functional>

namespace scb {

/// Whether two bodies that move touch in the time from 0 to 1.
enum class ContactOutcome : std::uint8_t {
    none,       ///< they do not touch
    contact,    ///< they touch: not before `not_before`, and at `at_latest`
    undecided,  ///< they may touch between `not_before` and `at_latest`, where they come too near
};

struct FirstContact {
    ContactOutcome outcome = ContactOutcome::none;
    double not_before = 1, at_latest = 1;  ///< the bodies are apart before `not_before`
    /// The least distance that was measured, at `time_of_least`.
    double least_distance = 0, time_of_least = 0;
    std::uint64_t distances = 0;  ///< how many were measured
};

/// What is known of the motion.
struct Approach {
    /// The distance of the bodies at a time from 0 to 1; 0 if and only if they touch.
    std::function<double(double time)> distance;
    double speed = 0;      ///< the distance changes at most so much in a unit of time
    double error = 0;      ///< of a distance, and of the poses at which it was measured
    double tolerance = 0;  ///< of at_latest - not_before, more than 0
};

/// The first contact by conservative advancement (Mirtich, "Impulse-based Dynamic Simulation of
/// Rigid Body Systems", 1996, Section 2.3): while the bodies are a distance apart, they are apart
/// for that distance over the speed. Both ends of a contact are shown: until `not_before` such
/// spans cover the time, and at `at_latest` a distance is 0. The two differ by at most the
/// tolerance, unless the bodies came too near before: nearer than the error, or so near that spans
/// are shorter than 2^-10 of the tolerance. After 20,000 distances, the rest is undecided.
FirstContact first_contact(const Approach& approach);

}  // namespace scb
