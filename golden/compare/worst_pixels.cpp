#include "golden/compare/worst_pixels.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace scb::golden {

std::array<int, 4> PixelChange::by() const {
    return {after.r - before.r, after.g - before.g, after.b - before.b, after.a - before.a};
}

int PixelChange::most() const {
    int largest = 0;
    for (const int d : by()) largest = std::max(largest, std::abs(d));
    return largest;
}

std::vector<PixelChange> worst_pixels(const render::Image& before, const render::Image& after,
                                      const PixelBox& part, std::size_t listed) {
    assert(before.width == after.width && before.height == after.height &&
           "pictures of two sizes have no pixels in common");
    std::vector<PixelChange> worst;
    if (listed == 0) return worst;
    for (int y = part.top; y < std::min(part.bottom, after.height); ++y)
        for (int x = part.left; x < std::min(part.right, after.width); ++x) {
            const PixelChange change{x, y, render::pixel(before, x, y), render::pixel(after, x, y)};
            const int most = change.most();
            if (most == 0 || (worst.size() == listed && most <= worst.back().most())) continue;
            const auto at = std::find_if(worst.begin(), worst.end(), [&](const PixelChange& other) {
                return other.most() < most;
            });
            worst.insert(at, change);
            if (worst.size() > listed) worst.pop_back();
        }
    return worst;
}

}  // namespace scb::golden
