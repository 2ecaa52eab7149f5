#pragma once

#include <cstddef>

#include "render/files/image.h"

namespace scb {
enum class VolumeKind;
}

namespace scb::render {

/// The palette of Okabe and Ito ("Color Universal Design", 2008), which color-blind readers can
/// tell apart, in the order used here: blue (body A), orange (body B), bluish green, vermillion,
/// reddish purple, sky blue, yellow, grey. Categories beyond the eighth repeat it.
Rgba8 category_color(std::size_t category);

inline constexpr Rgba8 body_a_color{0x00, 0x72, 0xB2};
inline constexpr Rgba8 body_b_color{0xE6, 0x9F, 0x00};

/// Each kind of hierarchy has one color in every figure that compares them: the SCB stands out in
/// vermillion, the balls are two blues and the OBB is grey. Among all choices of four from the
/// palette, these are among the farthest apart for color-blind readers, and legible on white and on
/// black.
Rgba8 hierarchy_color(VolumeKind kind);

/// A strong magenta, for what differs between two pictures or results: a few pixels of it are seen
/// on pale grey.
inline constexpr Rgba8 changed_color{0xD6, 0x00, 0x6E};

struct Theme;

/// The i-th of `count` shades of a color: the first is the color itself, the others step towards
/// the theme's text (darker on white, lighter on black), so that all stay legible.
Rgba8 shade_of(Rgba8 color, std::size_t i, std::size_t count, const Theme& theme);

/// Smith and van der Walt's viridis without its darkest fifth, in which shaded volumes are nearly
/// black: a magnitude from 0 (violet blue) to 1 (yellow), clamped; NaN counts as 0.
Rgba8 viridis(double magnitude);

/// Brewer's YlOrRd ("ColorBrewer", 2003): an amount from 0 (pale yellow) to 1 (dark red), clamped,
/// whose small values do not stand out; NaN counts as 0.
Rgba8 pale_to_red(double amount);

/// Between a (t = 0) and b (t = 1), channel by channel.
Rgba8 mix(Rgba8 a, Rgba8 b, double t);

/// The same color with another opacity, 0 to 1.
Rgba8 with_opacity(Rgba8 color, double opacity);

/// The colors of everything around the subject.
struct Theme {
    Rgba8 background;  ///< of the picture
    Rgba8 panel;       ///< behind text and figures
    Rgba8 border;      ///< hairlines: frames, axes, grid
    Rgba8 text;        ///< titles and values
    Rgba8 faint_text;  ///< units, remarks
    Rgba8 mesh;        ///< a mesh that is not the subject
    Rgba8 accent;      ///< for the things that the reader should look at first
    Rgba8 warning;     ///< text about errors; always with words that say so
    Rgba8 left_over;   ///< areas and volumes of pairs that a query left over
};

extern const Theme light_theme;
extern const Theme dark_theme;

}  // namespace scb::render
