#include "core/distance/first_contact.h"

#include <algorithm>
#include <cmath>
#include <optional>

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
            const double safe = span(distance), next = std::min(1.0, now + approach_.tolerance);
            if (now + safe >= 1) break;
            if (safe >= approach_.tolerance / 2) {
                now += safe;
                distance = measure(now);
                if (distance == 0) return contact(now, now);
                continue;
            }
            // Too near to advance: look from both ends of the tolerance.
            const double beyond = measure(next);
            if (beyond == 0) return contact(now + safe, next);
            if (const auto hit = between(now + safe, next - span(beyond))) return *hit;
            now = next;
            distance = beyond;
        }
        return found_;
    }

  private:
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

    FirstContact contact(double not_before, double at_latest) {
        found_.outcome = ContactOutcome::contact;
        found_.not_before = std::min(not_before, at_latest);
        found_.at_latest = at_latest;
        return found_;
    }

    /// The first contact in a part of the time; none if the bodies are apart.
    std::optional<FirstContact> between(double from, double to) {
        if (from >= to) return std::nullopt;
        if (to - from < 0x1p-10 * approach_.tolerance) {
            found_.outcome = ContactOutcome::undecided;
            found_.not_before = from;
            found_.at_latest = to;
            return found_;
        }
        const double middle = from + (to - from) / 2, distance = measure(middle);
        if (distance == 0) return contact(from, middle);
        const double safe = span(distance);
        if (const auto hit = between(from, middle - safe)) return hit;
        return between(middle + safe, to);
    }

    const Approach& approach_;
    FirstContact found_;
};

}  // namespace

FirstContact first_contact(const Approach& approach) { return Advancement(approach).run(); }

}  // namespace scb
