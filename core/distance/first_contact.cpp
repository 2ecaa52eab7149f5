#include "core/distance/first_contact.h"

#include <algorithm>
#include <cmath>

namespace scb {
namespace {

class Advancement {
  public:
    explicit Advancement(const Approach& approach) : approach_(approach) {}

    FirstContact run() {
        found_.least_distance = HUGE_VAL;
        double now = 0, distance = measure(0);
        if (distance == 0) return contact(0, 0);
        while (now < 1) {
            // Half of the tolerance at a time: a contact may follow a part that is undecided. A
            // step below the rounding of the time still advances.
            const double safe = span(distance),
                         next = std::min(1.0, std::max(now + approach_.tolerance / 2,
                                                       std::nextafter(now, HUGE_VAL)));
            if (now + safe >= 1) {
                // For the least distance.
                if (measure(1) == 0) return contact(1, 1);
                break;
            }
            if (safe >= approach_.tolerance / 4) {
                now += safe;
                distance = measure(now);
                if (distance == 0) return contact(now, now);
                continue;
            }
            if (found_.distances > most_distances) {
                give_up(now + safe, 1);
                break;
            }
            // Too near to advance: look from both ends of the step.
            const double beyond = measure(next);
            if (beyond == 0) return contact(now + safe, next);
            // Bodies that slide along each other are too near all the time.
            const double safe_before = span(beyond);
            if (safe == 0 && safe_before == 0)
                give_up(now, next);
            else if (between(now + safe, next - safe_before))
                return found_;
            now = next;
            distance = beyond;
        }
        return found_;
    }

  private:
    /// Bodies that slide along each other would take as many as the time has tolerances.
    static constexpr std::uint64_t most_distances = 20'000;

    /// How long the bodies are apart at least.
    double span(double distance) const {
        const double sure = distance - approach_.error;
        if (!(sure > 0)) return 0;
        return approach_.speed > 0 ? sure / approach_.speed * (1 - 0x1p-40) : 2;
    }
    double measure(double time) {
        const double distance = approach_.distance(time);
        ++found_.distances;
        if (distance < found_.least_distance) {
            found_.least_distance = distance;
            found_.time_of_least = time;
        }
        return distance;
    }

    /// If the bodies came too near before, they may have touched there already.
    FirstContact contact(double not_before, double at_latest) {
        if (found_.outcome == ContactOutcome::none)
            found_.not_before = std::min(not_before, at_latest);
        found_.outcome = ContactOutcome::contact;
        found_.at_latest = at_latest;
        return found_;
    }

    /// A part of the time that stays undecided.
    void give_up(double from, double to) {
        if (found_.outcome == ContactOutcome::none) found_.not_before = from;
        found_.outcome = ContactOutcome::undecided;
        found_.at_latest = to;
    }

    /// Looks for a contact in a part of the time, and returns whether there is one.
    bool between(double from, double to) {
        if (from >= to) return false;
        const double middle = from + (to - from) / 2;
        const bool can_divide = from < middle && middle < to;
        if (!can_divide || to - from < 0x1p-10 * approach_.tolerance) {
            give_up(from, to);
            return false;
        }
        const double distance = measure(middle);
        if (distance == 0) {
            contact(from, middle);
            return true;
        }
        const double safe = span(distance);
        return between(from, middle - safe) || between(middle + safe, to);
    }

    const Approach& approach_;
    FirstContact found_;
};

}  // namespace

FirstContact first_contact(const Approach& approach) { return Advancement(approach).run(); }

}  // namespace scb
