#pragma once

#include "app/explain_options.h"
#include "app/explained_pair.h"
#include "app/picture_run.h"
#include "render/explain_figure.h"

namespace scb {

/// What a picture of a pair says beside the pair itself, and where it goes.
struct ExplainPicture {
    std::string name;  ///< of the file, without .png
    std::string title, subtitle;
    Pose to_world;                     ///< from A's frame
    std::optional<CameraSpec> camera;  ///< that the user asked for
};

/// Draws the pair and hands the picture on to be written. `entry` is what the index says of it.
void draw_explanation(PictureRun& pictures, const ExplainOptions& options,
                      const ExplainedPair& pair, const ExplainPicture& picture,
                      nlohmann::ordered_json entry);

/// The camera that was asked for: of a scene, or else of raw volumes; nothing where it is left to
/// the picture.
std::optional<CameraSpec> asked_camera(const CameraOptions& options, const Scene* scene);

/// "test corrected, threshold 0.5", for subtitles; nothing of balls and boxes.
std::string asked_words(const ExplainedPair& pair);

/// What index.json says of the run.
nlohmann::ordered_json explain_index_head(const ExplainOptions& options);

}  // namespace scb
