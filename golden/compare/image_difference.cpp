#include "golden/compare/image_difference.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "render/view/palette.h"

namespace scb::golden {
namespace {

/// The largest difference of a channel of two pixels, each 4 bytes.
int pixel_difference(const std::uint8_t* a, const std::uint8_t* b) {
    int largest = 0;
    for (int channel = 0; channel < 4; ++channel)
        largest = std::max(largest, std::abs(a[channel] - b[channel]));
    return largest;
}

/// A share of the changed color on white, in 255ths: even a difference of 1 is a strong color.
int changed_share(int difference) { return 200 + 55 * difference / 255; }

std::uint8_t between(int from, int to, int share) {
    return static_cast<std::uint8_t>(from + (to - from) * share / 255);
}

/// Grey from 190 (black) to 255 (white), so that equal pixels are recognizable but unobtrusive.
render::Rgba8 pale_grey(render::Rgba8 color) {
    const int luma = (54 * color.r + 183 * color.g + 19 * color.b) / 256;
    const std::uint8_t grey = between(190, 255, luma);
    return {grey, grey, grey, 255};
}

}  // namespace

ImageDifference image_difference(const render::Image& a, const render::Image& b) {
    assert(a.width == b.width && a.height == b.height && a.rgba.size() == b.rgba.size() &&
           "pictures of different sizes cannot be compared pixel by pixel");
    ImageDifference difference;
    // At [d], the number of pixels that differ by d. This takes far fewer steps than a pass for
    // each threshold.
    std::array<std::size_t, 256> exactly{};
    const std::size_t row_size = 4 * static_cast<std::size_t>(a.width);
    for (int y = 0; y < a.height; ++y) {
        const std::uint8_t* row_a = a.rgba.data() + static_cast<std::size_t>(y) * row_size;
        const std::uint8_t* row_b = b.rgba.data() + static_cast<std::size_t>(y) * row_size;
        if (row_size == 0 || std::memcmp(row_a, row_b, row_size) == 0) continue;
        for (int x = 0; x < a.width; ++x) {
            const std::size_t at = 4 * static_cast<std::size_t>(x);
            const int by = pixel_difference(row_a + at, row_b + at);
            if (by == 0) continue;
            ++exactly[static_cast<std::size_t>(by)];
            difference.box.add(x, y);
        }
    }
    for (std::size_t d = 255; d > 0; --d) {
        difference.beyond[d - 1] = difference.beyond[d] + exactly[d];
        if (exactly[d] > 0) difference.largest = std::max(difference.largest, static_cast<int>(d));
    }
    difference.pixels = difference.beyond[0];
    return difference;
}

PixelBox changed_box(const render::Image& a, const render::Image& b, const PixelBox& part) {
    assert(a.width == b.width && a.height == b.height &&
           "pictures of different sizes cannot be compared pixel by pixel");
    PixelBox box;
    for (int y = part.top; y < part.bottom; ++y)
        for (int x = part.left; x < part.right; ++x)
            if (!(render::pixel(a, x, y) == render::pixel(b, x, y))) box.add(x, y);
    return box;
}

bool within(const ImageDifference& difference, const ColorTolerance& tolerance) {
    if (tolerance.max_channel_delta >= 255) return true;
    const int delta = std::max(0, tolerance.max_channel_delta);
    return difference.beyond[static_cast<std::size_t>(delta)] <= tolerance.max_pixels;
}

render::Image difference_picture(const render::Image& a, const render::Image& b) {
    assert(a.width == b.width && a.height == b.height && a.rgba.size() == b.rgba.size() &&
           "pictures of different sizes have no picture of their difference");
    render::Image picture{b.width, b.height, {}};
    picture.rgba.resize(b.rgba.size());
    for (int y = 0; y < b.height; ++y)
        for (int x = 0; x < b.width; ++x) {
            const std::size_t at =
                4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(b.width) +
                     static_cast<std::size_t>(x));
            const int by = pixel_difference(&a.rgba[at], &b.rgba[at]);
            if (by == 0) {
                render::set_pixel(picture, x, y, pale_grey(render::pixel(b, x, y)));
                continue;
            }
            const int share = changed_share(by);
            render::set_pixel(picture, x, y,
                              {between(255, render::changed_color.r, share),
                               between(255, render::changed_color.g, share),
                               between(255, render::changed_color.b, share), 255});
        }
    return picture;
}

namespace {

bool is_changed(render::Rgba8 color) { return color.r != color.g || color.g != color.b; }

/// The clusters of pixels of square cells that touch.
std::vector<PixelBox> clusters_of_cells(const render::Image& difference, int cell) {
    const int columns = (difference.width + cell - 1) / cell,
              rows = (difference.height + cell - 1) / cell;
    std::vector<PixelBox> cells(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    const auto at = [&](int column, int row) -> PixelBox& {
        return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                     static_cast<std::size_t>(column)];
    };
    for (int y = 0; y < difference.height; ++y)
        for (int x = 0; x < difference.width; ++x)
            if (is_changed(render::pixel(difference, x, y))) at(x / cell, y / cell).add(x, y);
    std::vector<PixelBox> clusters;
    std::vector<std::pair<int, int>> open;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            if (at(column, row).empty()) continue;
            PixelBox cluster;
            open.emplace_back(column, row);
            while (!open.empty()) {
                const auto [i, j] = open.back();
                open.pop_back();
                if (i < 0 || j < 0 || i >= columns || j >= rows || at(i, j).empty()) continue;
                const PixelBox part = std::exchange(at(i, j), {});
                cluster.add(part.left, part.top);
                cluster.add(part.right - 1, part.bottom - 1);
                for (int side = 0; side < 9; ++side)
                    open.emplace_back(i + side % 3 - 1, j + side / 3 - 1);
            }
            clusters.push_back(cluster);
        }
    return clusters;
}

}  // namespace

std::vector<PixelBox> changed_clusters(const render::Image& difference, std::size_t most) {
    for (int cell = 8;; cell *= 2) {
        std::vector<PixelBox> clusters = clusters_of_cells(difference, cell);
        if (clusters.size() <= std::max<std::size_t>(most, 1)) return clusters;
    }
}

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
