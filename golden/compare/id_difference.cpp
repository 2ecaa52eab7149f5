#include "golden/compare/id_difference.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "golden/compare/image_difference.h"
#include "render/view/palette.h"

namespace scb::golden {
namespace {

using ChangesById = std::unordered_map<std::uint32_t, IdChange>;

void add_run(IdChange& change, std::uint32_t id, int left, int right, int y) {
    change.id = id;
    change.moved += static_cast<std::size_t>(right - left);
    change.box.add(left, y);
    change.box.add(right - 1, y);
}

/// Adds the pixels of one row that differ, run by run, since neighbors mostly have one owner.
void compare_rows(const std::uint32_t* before, const std::uint32_t* after, int width, int y,
                  IdDifference& difference, ChangesById& changes) {
    for (int left = 0, right = 0; left < width; left = right) {
        for (right = left + 1;
             right < width && before[right] == before[left] && after[right] == after[left];)
            ++right;
        if (before[left] == after[left]) continue;
        difference.pixels += static_cast<std::size_t>(right - left);
        difference.box.add(left, y);
        difference.box.add(right - 1, y);
        for (const std::uint32_t id : {before[left], after[left]})
            add_run(changes[id], id, left, right, y);
    }
}

/// Counts all pixels of the things that have changed.
void count_pixels(const render::IdImage& image, std::size_t IdChange::*side, ChangesById& changes) {
    const std::vector<std::uint32_t>& ids = image.ids;
    for (std::size_t first = 0, end = 0; first < ids.size(); first = end) {
        for (end = first + 1; end < ids.size() && ids[end] == ids[first];) ++end;
        const auto change = changes.find(ids[first]);
        if (change != changes.end()) change->second.*side += end - first;
    }
}

bool comes_first(const IdChange& a, const IdChange& b) {
    const bool a_stayed = a.before > 0 && a.after > 0, b_stayed = b.before > 0 && b.after > 0;
    return std::tie(a_stayed, b.moved, a.id) < std::tie(b_stayed, a.moved, b.id);
}

}  // namespace

IdDifference id_difference(const render::IdImage& before, const render::IdImage& after) {
    assert(before.width == after.width && before.height == after.height &&
           before.ids.size() == after.ids.size() &&
           "id pictures of different sizes cannot be compared pixel by pixel");
    IdDifference difference;
    ChangesById changes;
    const std::size_t width = static_cast<std::size_t>(before.width);
    for (int y = 0; y < before.height; ++y) {
        const std::size_t row = static_cast<std::size_t>(y) * width;
        if (width == 0 || std::memcmp(&before.ids[row], &after.ids[row], 4 * width) == 0) continue;
        compare_rows(&before.ids[row], &after.ids[row], before.width, y, difference, changes);
    }
    changes.erase(0);
    if (changes.empty()) return difference;
    count_pixels(before, &IdChange::before, changes);
    count_pixels(after, &IdChange::after, changes);
    for (const auto& [id, change] : changes) difference.changes.push_back(change);
    std::sort(difference.changes.begin(), difference.changes.end(), comes_first);
    return difference;
}

namespace {

/// Consecutive ids are far apart in hue.
render::Rgba8 color_of(std::uint32_t id) {
    if (id == 0) return {0, 0, 0, 0};
    std::uint32_t h = id * 0x9e3779b1u;
    h ^= h >> 15;
    h *= 0x85ebca77u;
    h ^= h >> 13;
    const auto channel = [&](int shift) {
        return static_cast<std::uint8_t>(60 + ((h >> shift) & 0xff) * 165 / 255);
    };
    return {channel(0), channel(8), channel(16), 255};
}

}  // namespace

render::Image shown_ids(const render::IdImage& ids) {
    render::Image image{ids.width, ids.height, std::vector<std::uint8_t>(4 * ids.ids.size())};
    for (int y = 0; y < ids.height; ++y)
        for (int x = 0; x < ids.width; ++x)
            render::set_pixel(image, x, y, color_of(render::pixel(ids, x, y)));
    return image;
}

render::Image shown_id_difference(const render::IdImage& before, const render::IdImage& after) {
    assert(before.width == after.width && before.height == after.height &&
           "id pictures of two sizes have no difference");
    render::Image image{after.width, after.height, std::vector<std::uint8_t>(4 * after.ids.size())};
    for (int y = 0; y < after.height; ++y)
        for (int x = 0; x < after.width; ++x) {
            const std::uint32_t id = render::pixel(after, x, y);
            const auto pale = static_cast<std::uint8_t>(id == 0 ? 250 : 205 + color_of(id).g / 8);
            render::set_pixel(image, x, y,
                              id == render::pixel(before, x, y) ? render::Rgba8{pale, pale, pale}
                                                                : render::changed_color);
        }
    return image;
}

}  // namespace scb::golden
