#pragma once

namespace scb::golden {

/// Pixels from (left, top) to before (right, bottom); empty if right <= left.
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;

    bool empty() const { return right <= left || bottom <= top; }
    void add(int x, int y) {
        if (empty()) {
            *this = {x, y, x + 1, y + 1};
            return;
        }
        left = x < left ? x : left;
        top = y < top ? y : top;
        right = x >= right ? x + 1 : right;
        bottom = y >= bottom ? y + 1 : bottom;
    }
    friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

}  // namespace scb::golden
