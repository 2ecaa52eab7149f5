#include "render/plots/line_thinning.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scb::render {

std::vector<ScreenPosition> thinned(std::span<const ScreenPosition> points) {
    std::vector<ScreenPosition> result;
    std::size_t begin = 0;
    while (begin < points.size()) {
        const double column = std::floor(points[begin].x);
        std::size_t low = begin, high = begin, end = begin;
        for (; end < points.size() && std::floor(points[end].x) == column; ++end) {
            if (points[end].y < points[low].y) low = end;
            if (points[end].y > points[high].y) high = end;
        }
        // A NaN position is in no column.
        if (end == begin) {
            ++begin;
            continue;
        }
        std::array kept = {begin, low, high, end - 1};
        std::sort(kept.begin(), kept.end());
        for (std::size_t i = 0; i < kept.size(); ++i)
            if (i == 0 || kept[i] != kept[i - 1]) result.push_back(points[kept[i]]);
        begin = end;
    }
    return result;
}

}  // namespace scb::render
