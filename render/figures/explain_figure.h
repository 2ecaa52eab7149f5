#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/explain/pair_explanation.h"
#include "core/volumes/any_volume.h"
#include "render/view/palette.h"
#include "render/view/picture.h"
#include "scb/any_hierarchy.h"
#include "scb/overlap_options.h"

namespace scb::render {

class Overlay;

/// One overlap test as a picture, a live version of the paper's Figures 7 and 9: both volumes with
/// the proof of the exact verdict; the step that decided, or came closest, in a plane that shows it
/// (not for boxes); the slack of all steps; the answer.
struct ExplainFigure {
    std::string title;
    std::string subtitle;
    std::array<std::string, 2> names;  ///< "A 412"
    VolumeKind kind{};
    AnyVolume a, b;  ///< in A's frame
    /// The triangles in the volumes, if known, in the world, with their colors.
    std::optional<std::array<MeshDraw, 2>> triangles;
    OverlapOptions options;
    /// How a test of another engine ended: "bullet: rejected at box".
    std::string ending;
    bool is_tested = true;  ///< false: there was no test, and `ending` says so
    std::string but;        ///< a remaining error, printed behind "the test is right"; may be empty
    const PairExplanation* found = nullptr;
    Pose to_world;                 ///< from A's frame, for the camera
    std::optional<Camera> camera;  ///< in the world; else explain_camera's
    bool orthographic = false;     ///< of explain_camera
    const Theme* theme = &light_theme;
};

/// A camera that sees the step's plane from the front, but a little from the side and from above,
/// fitted to both volumes. For disjoint volumes it is without perspective and looks along the plane
/// between them.
Camera explain_camera(const ExplainFigure& figure, double aspect);

Picture compose(const ExplainFigure& figure, int width, int height, int samples, Overlay& overlay);

/// The positions of the parts of a picture of an explanation.
struct ExplainLayout {
    int unit = 20;  ///< size of body text, pixels
    PixelRect heading;
    PixelRect view, section;  ///< with their captions above them; boxes have no section
    PixelRect steps, verdict;
    PixelRect footnote;  ///< the meaning of symbols; empty if there are none, or no room

    static constexpr int caption_lines = 2;
    int caption_height() const { return caption_lines * unit * 5 / 4 + unit / 4; }
    /// The view of the scene, without its caption and the scale bar below it.
    PixelRect view_box() const;
};
ExplainLayout explain_layout(int width, int height, const ExplainFigure& figure, Overlay& overlay);

/// The symbols in the formulas of a test beyond the paper's, in lines for a terminal.
std::vector<std::string_view> symbol_lines(VolumeKind kind, const OverlapOptions& options);

}  // namespace scb::render
