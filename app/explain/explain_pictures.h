#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/explain/explain_options.h"
#include "app/pictures/picture_name.h"
#include "app/pictures/picture_run.h"
#include "app/study/explained_pair.h"
#include "render/figures/explain_figure.h"
#include "scb/mesh.h"

namespace scb::app {

/// Texts and placement of a picture of a pair.
struct ExplainPicture {
    std::string name;  ///< of the file, without .png
    std::string title, subtitle;
    std::string but{}, ending{};     ///< see ExplainFigure
    bool is_tested = true;           ///< likewise
    std::array<Pose, 2> to_world{};  ///< from the frames of A and B
    std::optional<std::array<Mesh, 2>>
        triangles{};                             ///< the triangles in the volumes, in these frames
    std::optional<scenes::CameraView> camera{};  ///< set by the user
    bool orthographic = false;                   ///< if `camera` is not set
};

/// The name of a picture of two nodes; it has a body's name and a node of each. `stem`: see
/// SceneOptions::file_stem. `named`: the options of the picture, besides those of the query.
std::string explain_name(const std::string& stem, const TraceHeader& header,
                         const NamedOptions& named, int frame,
                         const std::array<std::uint32_t, 2>& nodes);

/// Places the picture of two nodes of these bodies, by index, with the triangles below them; with
/// none if the items of a body are objects.
void place_nodes(ExplainPicture& picture, const std::array<BodyAtFrame, 2>& bodies,
                 IndexPair nodes);

/// Draws the pair and queues the picture to be written. `entry`: its entry in the index.
void draw_explanation(PictureRun& pictures, const PictureOptions& options,
                      const ExplainedPair& pair, const ExplainPicture& picture,
                      nlohmann::ordered_json entry);

/// The camera set by the user: for a scene, or else for raw volumes; none if the picture chooses
/// it.
std::optional<scenes::CameraView> asked_camera(const CameraOptions& options,
                                               const scenes::Scene* scene);

/// "test corrected, threshold 0.5", for subtitles; empty for balls and boxes.
std::string asked_words(const ExplainedPair& pair);

/// The description of the run in index.json.
nlohmann::ordered_json explain_index_head(const ExplainOptions& options);

}  // namespace scb::app
