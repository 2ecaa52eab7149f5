#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/pictures/picture_name.h"
#include "app/pictures/picture_options.h"
#include "app/pictures/sheet_run.h"
#include "app/study/query_sources.h"
#include "core/platform/number_list.h"
#include "render/figures/comparison_figure.h"

namespace scb::app {

class Command;
struct Console;

/// The parts of the bodies that a picture shows, and that the camera must include.
enum class Shown { nothing, meshes, leaves, volumes };

/// Options of every command that draws queries.
struct QueryViewOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    QueryOptions query{.frames = auto_frames};
    QueryLimits limits;
    PictureOptions picture{.takes_file = true};
    CameraOptions camera;
    std::string pick;  ///< "X,Y", see PictureOptions::pick
    bool sheet = false;
    /// The given options that a trace already has, see given_recording_options.
    std::vector<std::string> recording;
    std::string compare;  ///< see CompareOptions::names
    Shown shown = Shown::meshes;
    /// Share of the parts outside of the meshes that the camera includes, see support_between.
    double held_part = 1;
    /// Whether the camera looks from where most of the contact is visible, if its direction is
    /// open.
    bool seeks_contact = true;
    bool one_picture = false;  ///< of the frames, only one is drawn
    bool animated = false;     ///< the pictures are steps of queries, and share one camera
    NamedOptions named;        ///< the command's own options that affect its pictures

    /// Refuses invalid options before any work is done, and reads `pick`; throws InputError.
    void check();
    /// Opens the queries.
    QuerySources open(const Console& console) const;
    /// A sheet for this many pictures, if asked for; with `layout` if two queries are compared.
    /// Throws InputError if there are too many pictures: call this before anything is written.
    std::optional<SheetRun> planned_sheet(
        std::size_t count, const std::optional<render::ComparisonLayout>& layout) const;
};
/// If QueryOptions::distance is set, the options are of a query of distances. Sets
/// QueryViewOptions::shown; with Shown::nothing, adds no options of a view.
void add_query_view_options(const Command& command, QueryViewOptions& options, Shown shown);

}  // namespace scb::app
