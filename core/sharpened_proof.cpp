#include <algorithm>
#include <array>
#include <cmath>

#include "core/exact_overlap.h"

namespace scb {
namespace {

/// Climbs from a direction or a point to where no step of a shrinking size is better. `scale` is
/// that of the first steps, `value(x)` what is to grow, `step(x, s)` where a step leads.
template <class Value, class Step>
void climb(Vec3& x, double& best, double scale, const Value& value, const Step& step) {
    // The edges and corners of a cube: enough directions for a value with creases.
    constexpr int rounds = 1000;
    double size = scale;
    for (int round = 0; round < rounds && size > 1e-13 * scale; ++round) {
        Vec3 chosen = x;
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j)
                for (int k = -1; k <= 1; ++k) {
                    const Vec3 candidate = step(x, Vec3(size * Vec3(i, j, k)));
                    const double v = value(candidate);
                    if (v > best) {
                        best = v;
                        chosen = candidate;
                    }
                }
        if (chosen == x) size /= 2;
        x = chosen;
    }
}

template <class V>
ContactProof sharpened_proof(const V& a, const V& b, ContactProof proof) {
    if (proof.contact == Contact::disjoint)
        climb(
            proof.direction, proof.margin, 0.5, [&](const Vec3& d) { return proven_gap(a, b, d); },
            [](const Vec3& d, const Vec3& s) {
                const Vec3 moved = d + s;
                const double length = std::sqrt(squared_norm(moved));
                return length > 0.1 ? Vec3(moved / length) : d;
            });
    else if (proof.contact == Contact::overlapping)
        climb(
            proof.point, proof.margin, std::min(diameter(a), diameter(b)) / 4,
            [&](const Vec3& p) { return proven_depth(a, b, p); },
            [](const Vec3& p, const Vec3& s) { return Vec3(p + s); });
    return proof;
}

}  // namespace

ContactProof sharpened(const Scb& a, const Scb& b, const ContactProof& proof) {
    return sharpened_proof(a, b, proof);
}

ContactProof sharpened(const Ball& a, const Ball& b, const ContactProof& proof) {
    return sharpened_proof(a, b, proof);
}

ContactProof sharpened(const Obb& a, const Obb& b, const ContactProof& proof) {
    return sharpened_proof(a, b, proof);
}

}  // namespace scb
