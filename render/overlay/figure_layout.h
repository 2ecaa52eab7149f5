#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text_format.h"
#include "render/overlay/font_face.h"
#include "render/overlay/overlay.h"
#include "render/view/camera.h"
#include "render/view/picture.h"

namespace scb::render {

/// The layout of a picture: a heading on top, the view of the scene below it, and a panel of
/// numbers at its right, or below it if the picture is taller than wide. Neither panel nor heading
/// covers the view.
struct FigureLayout {
    int unit = 20;  ///< size of body text, pixels
    PixelRect heading;
    PixelRect view;
    PixelRect panel;
    bool portrait = false;  ///< the panel is below the view
};

/// Without a panel the view is the whole picture, and there is no heading.
FigureLayout figure_layout(int width, int height, bool with_panel = true);

/// A smaller view beside the picture's view. It magnifies a part; or it shows the whole, and where
/// the picture's view is in it.
struct Detail {
    Camera camera;  ///< for a square view
    Vec3 center = Vec3::Zero();
    double radius = 1;  ///< of the part, about the center
    bool shows_whole = false;
};

/// The square for a magnified detail: below the panel's rows, which end at `below`, or beside them;
/// nothing if there is no room.
std::optional<PixelRect> detail_square(const FigureLayout& layout, int below);

/// The frames of a detail in its square and of the part in the larger of both views, and its size.
void draw_detail_frames(Overlay& overlay, const FigureLayout& layout, const PixelRect& square,
                        const Camera& camera, const Detail& detail, const Theme& theme);

/// The frames of a view of the whole in its square, without words.
void draw_square_of_view(Overlay& overlay, int unit, const PixelRect& square, const Detail& detail,
                         const Theme& theme);

inline double aspect_of(const PixelRect& rect) {
    return static_cast<double>(rect.width) / rect.height;
}

/// Draws the title and, behind it, a line of smaller text. If this does not fit and the heading has
/// room, it is below the title (see second_heading_line).
void draw_heading(Overlay& overlay, const FigureLayout& layout, const Theme& theme,
                  std::string_view title, std::string_view subtitle);

/// The additional height of a heading for a line below the title, if it needs one; else 0.
int second_heading_line(Overlay& overlay, const FigureLayout& layout, std::string_view title,
                        std::string_view subtitle);

/// The text, cut to fit into `width` pixels, with an ellipsis if it was cut.
std::string fitted_text(Overlay& overlay, std::string_view text, const TextStyle& style, int width);

/// The text in lines of at most this width, broken at spaces; a wider word is cut.
std::vector<std::string> wrapped_text(Overlay& overlay, std::string_view text,
                                      const TextStyle& style, int width);

/// Draws a length bar in the lower left corner of a view, or `below` pixels lower: the length of a
/// round number of scene units at `at`.
void draw_scale_bar(Overlay& overlay, const PixelRect& view, const Camera& camera, const Vec3& at,
                    const Theme& theme, int unit, int below = 0);

/// Draws a sentence at the top left of a view, in the accent color, on a panel.
void draw_remark(Overlay& overlay, const PixelRect& view, std::string_view remark,
                 const Theme& theme, int unit);

/// The square around a ball about `center` in the view, or nothing if the ball is behind the eye or
/// outside.
std::optional<PixelRect> marker_of(const PixelRect& view, const Camera& camera, const Vec3& center,
                                   double radius);

/// A number of about `digits` digits for a reader: 20,480 or 0.0731 or 1.2e-05.
std::string number_text(double value, int digits = 3);
using scb::count_text;
using scb::counted;
/// The mean over frames: "39,333.4", without a decimal for one frame.
std::string mean_text(std::uint64_t sum, std::size_t frames);

/// "43.8 %"; a dash if the whole is 0.
std::string share_text(double part, double whole);

/// The layout of sheets: cells of equal size side by side below a heading, wrapped into bands if
/// there are many. The caller, which knows the height of a cell, computes the height.
struct SheetGrid {
    int width = 0, height = 0;
    int unit = 0;                ///< size of body text
    int columns = 0, bands = 0;  ///< cells in a row; rows after wrapping
    int view_width = 0;          ///< of the view in a cell

    /// The left end of a column.
    int x(int column) const;
};

inline constexpr int sheet_margin = 24;

/// A size that every renderer here can draw, even with four samples.
inline constexpr int largest_sheet_side = 8000;

/// A grid of `count` cells, at most `most_columns` side by side; bands are evenly filled.
SheetGrid sheet_grid(int count, int most_columns, int view_width);

/// The width of a view if there is room for all, by the number of columns.
int roomy_view_width(int columns);

bool fits(const SheetGrid& grid);

}  // namespace scb::render
