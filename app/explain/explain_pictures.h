#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/explain/explain_options.h"
#include "app/explain/explained_pair.h"
#include "app/pictures/picture_name.h"
#include "app/pictures/picture_run.h"
#include "render/figures/explain_figure.h"
#include "scb/mesh.h"

namespace scb::app {

/// What a picture of a pair says beside the pair itself, and where it goes.
struct ExplainPicture {
    std::string name;  ///< of the file, without .png
    std::string title, subtitle;
    std::string but{}, ending{};                     ///< see ExplainFigure
    bool is_tested = true;                           ///< likewise
    std::array<Pose, 2> to_world{};                  ///< from the frames of A and B
    std::optional<std::array<Mesh, 2>> triangles{};  ///< what the volumes bound, in these frames
    std::optional<scenes::CameraView> camera{};      ///< that the user asked for
    bool orthographic = false;                       ///< without such a camera
};

/// The name of such a picture of two nodes: a body's name and a node of each. `stem`: see
/// SceneOptions::file_stem. `named`: the options of the picture, beside those of the query.
std::string explain_name(const std::string& stem, const TraceHeader& header,
                         const NamedOptions& named, int frame,
                         const std::array<std::uint32_t, 2>& nodes);

/// Places the picture of two nodes at a frame, with the triangles below them.
void place_nodes(ExplainPicture& picture, const SceneQuery& query, int frame,
                 const ExplainedPair& pair);

/// Draws the pair and hands the picture on to be written. `entry` is what the index says of it.
void draw_explanation(PictureRun& pictures, const PictureOptions& options,
                      const ExplainedPair& pair, const ExplainPicture& picture,
                      nlohmann::ordered_json entry);

/// The camera that was asked for: of a scene, or else of raw volumes; nothing where it is left to
/// the picture.
std::optional<scenes::CameraView> asked_camera(const CameraOptions& options,
                                               const scenes::Scene* scene);

/// "test corrected, threshold 0.5", for subtitles; nothing of balls and boxes.
std::string asked_words(const ExplainedPair& pair);

/// What index.json says of the run.
nlohmann::ordered_json explain_index_head(const ExplainOptions& options);

}  // namespace scb::app
