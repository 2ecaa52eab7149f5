#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/pictures/picture_name.h"
#include "app/pictures/picture_options.h"
#include "app/pictures/sheet_run.h"
#include "app/query/query_sources.h"
#include "render/figures/comparison_figure.h"
#include "scenes/text/number_list.h"

namespace scb::app {

/// What of the bodies a picture shows, and a camera therefore has to hold.
enum class Shown { nothing, meshes, leaves, volumes };

/// What every command that draws queries understands.
struct QueryViewOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    QueryOptions query{.frames = scenes::auto_frames};
    QueryLimits limits;
    PictureOptions picture;
    CameraOptions camera;
    std::string pick;  ///< "X,Y", see PictureOptions::pick
    bool sheet = false;
    /// What was given of what a trace already knows, see given_recording_options.
    std::vector<std::string> recording;
    std::string compare;  ///< see CompareOptions::names
    Shown shown = Shown::meshes;
    /// How far the camera holds what sticks out of the bodies, see support_between.
    double held_part = 1;
    NamedOptions named;  ///< what of the command's own options changes its pictures

    /// Refuses what makes no sense before any work is done, and reads `pick`; throws InputError.
    void check();
    /// Opens what was asked for.
    QuerySources open(const Console& console) const;
    /// A sheet for this many pictures, where one is asked for; with `layout` where two queries are
    /// compared. Throws InputError where they are too many: ask before anything is written.
    std::optional<SheetRun> planned_sheet(
        std::size_t count, const std::optional<render::ComparisonLayout>& layout) const;
};
/// Sets QueryViewOptions::shown; where that is nothing, there are no options of a view.
void add_query_view_options(const Command& command, QueryViewOptions& options, Shown shown);

}  // namespace scb::app
