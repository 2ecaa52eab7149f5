#include "render/view/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "scb/any_hierarchy.h"

namespace scb::render {

namespace {

constexpr std::array<Rgba8, 8> categories = {{body_a_color,
                                              body_b_color,
                                              {0x00, 0x9E, 0x73},
                                              {0xD5, 0x5E, 0x00},
                                              {0xCC, 0x79, 0xA7},
                                              {0x56, 0xB4, 0xE9},
                                              {0xF0, 0xE4, 0x42},
                                              {0x8C, 0x8C, 0x8C}}};

// Viridis at every fifteenth of its range, from the third on.
constexpr std::array<Rgba8, 13> viridis_stops = {{{0x41, 0x44, 0x87},
                                                  {0x39, 0x56, 0x8C},
                                                  {0x31, 0x68, 0x8E},
                                                  {0x2A, 0x78, 0x8E},
                                                  {0x23, 0x88, 0x8E},
                                                  {0x1F, 0x98, 0x8B},
                                                  {0x22, 0xA8, 0x84},
                                                  {0x35, 0xB7, 0x79},
                                                  {0x54, 0xC5, 0x68},
                                                  {0x7A, 0xD1, 0x51},
                                                  {0xA5, 0xDB, 0x36},
                                                  {0xD2, 0xE2, 0x1B},
                                                  {0xFD, 0xE7, 0x25}}};

constexpr std::array<Rgba8, 7> red_stops = {{{0xFF, 0xED, 0xA0},
                                             {0xFE, 0xD9, 0x76},
                                             {0xFE, 0xB2, 0x4C},
                                             {0xFD, 0x8D, 0x3C},
                                             {0xFC, 0x4E, 0x2A},
                                             {0xE3, 0x1A, 0x1C},
                                             {0xB1, 0x00, 0x26}}};

Rgba8 between_stops(std::span<const Rgba8> stops, double at) {
    const double t = at > 0 ? std::min(at, 1.0) * static_cast<double>(stops.size() - 1) : 0;
    const std::size_t below = std::min(static_cast<std::size_t>(t), stops.size() - 2);
    return mix(stops[below], stops[below + 1], t - static_cast<double>(below));
}

}  // namespace

Rgba8 category_color(std::size_t category) { return categories[category % categories.size()]; }

Rgba8 hierarchy_color(VolumeKind kind) {
    switch (kind) {
        case VolumeKind::scb:
            return category_color(3);
        case VolumeKind::ball:
            return category_color(0);
        case VolumeKind::ritter:
            return category_color(5);
        case VolumeKind::scb2:
            return category_color(2);
        case VolumeKind::aabb:
            return category_color(1);
        case VolumeKind::aabb_exact:
            return category_color(4);
        case VolumeKind::obb:
            return category_color(7);
        default:
            break;
    }
    // The colors after the eight, in their order: as far from the eight as their shades are.
    constexpr std::array<Rgba8, 5> others = {{{0x7A, 0x3E, 0x9D},
                                              {0x00, 0x5F, 0x73},
                                              {0x8A, 0x5A, 0x00},
                                              {0xA0, 0x1A, 0x3C},
                                              {0x55, 0x6B, 0x2F}}};
    const auto beyond =
        static_cast<std::size_t>(kind) - static_cast<std::size_t>(VolumeKind::aabb_exact) - 1;
    return others[beyond % others.size()];
}

Rgba8 shade_of(Rgba8 color, std::size_t i, std::size_t count, const Theme& theme) {
    if (i == 0 || count < 2) return color;
    const double at = static_cast<double>(std::min(i, count - 1));
    return mix(color, theme.text, std::min(0.4 * at, 0.8 * at / static_cast<double>(count - 1)));
}

Rgba8 viridis(double magnitude) { return between_stops(viridis_stops, magnitude); }

Rgba8 pale_to_red(double amount) { return between_stops(red_stops, amount); }

Rgba8 mix(Rgba8 a, Rgba8 b, double t) {
    const auto channel = [t](std::uint8_t from, std::uint8_t to) {
        return static_cast<std::uint8_t>(std::lround(from + t * (to - from)));
    };
    return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b), channel(a.a, b.a)};
}

Rgba8 with_opacity(Rgba8 color, double opacity) {
    color.a = static_cast<std::uint8_t>(std::lround(255 * std::clamp(opacity, 0.0, 1.0)));
    return color;
}

const Theme light_theme = {.background = {255, 255, 255},
                           .panel = {255, 255, 255, 224},
                           .border = {196, 200, 206},
                           .text = {28, 32, 38},
                           .faint_text = {96, 103, 112},
                           .mesh = {176, 180, 186},
                           .accent = {0xD5, 0x5E, 0x00},
                           .warning = {0xB4, 0x00, 0x3C},
                           .left_over = {0x4B, 0x1F, 0x8A}};

const Theme dark_theme = {.background = {22, 25, 30},
                          .panel = {22, 25, 30, 224},
                          .border = {74, 80, 90},
                          .text = {236, 239, 243},
                          .faint_text = {160, 168, 178},
                          .mesh = {122, 128, 136},
                          .accent = {0xF0, 0xE4, 0x42},
                          .warning = {0xFF, 0x7A, 0x90},
                          .left_over = {0xC4, 0xA6, 0xFF}};

}  // namespace scb::render
