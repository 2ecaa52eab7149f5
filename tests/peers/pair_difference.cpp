#include "tests/peers/pair_difference.h"

#include <algorithm>

#include "scb/collide.h"
#include "scb/triangle_overlap.h"

namespace scb {
namespace {

bool is_degenerate(const TriangleCorners& t) {
    return squared_norm(cross(t[1] - t[0], t[2] - t[0])) == 0;
}

TriangleCorners moved(const TriangleCorners& t, const Vec3& by) {
    return {t[0] + by, t[1] + by, t[2] + by};
}

/// Whether a triangle meets what an edge of the other passes through on its way from `-by` to `by`.
bool edges_pass(const TriangleCorners& moving, const TriangleCorners& still, const Vec3& by) {
    const TriangleCorners from = moved(moving, -by), to = moved(moving, by);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if (triangles_overlap({from[i], from[j], to[j]}, still) ||
            triangles_overlap({from[i], to[j], to[i]}, still))
            return true;
    }
    return false;
}

/// Whether the answer for two triangles is another one where B is moved at most that far along each
/// axis. Triangles almost in one plane pass through each other, which their edges show.
bool is_close(const TriangleCorners& a, const TriangleCorners& b, double closeness) {
    const bool overlap = triangles_overlap(a, b);
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                const Vec3 by = closeness * Vec3(x, y, z);
                if (triangles_overlap(a, moved(b, by)) != overlap) return true;
                if (!overlap && (edges_pass(b, a, by) || edges_pass(a, b, by))) return true;
            }
    return false;
}

void add(UnsharedPairs& unshared, std::span<const IndexPair> all, std::span<const IndexPair> others,
         const PairScene& scene) {
    std::vector<IndexPair> only;
    std::set_difference(all.begin(), all.end(), others.begin(), others.end(),
                        std::back_inserter(only));
    unshared.count += only.size();
    for (const IndexPair& pair : only) {
        const TriangleCorners a = corners(scene.a, pair.a), b = corners(scene.b, pair.b);
        if (is_degenerate(a) || is_degenerate(b))
            ++unshared.degenerate;
        else if (is_close(a, transform_corners(scene.b_to_a, b), scene.closeness))
            ++unshared.close;
    }
}

}  // namespace

void add_frame(PairDifference& difference, std::span<const IndexPair> reference,
               std::span<const IndexPair> found, const PairScene& scene) {
    ++difference.frames;
    difference.pairs += reference.size();
    add(difference.missing, reference, found, scene);
    add(difference.extra, found, reference, scene);
}

}  // namespace scb
