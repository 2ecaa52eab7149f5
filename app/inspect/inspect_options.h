#pragma once

#include <string>
#include <vector>

#include "app/pictures/picture_options.h"
#include "app/query/distance_options.h"
#include "app/query/layout_options.h"
#include "app/query/query_options.h"
#include "app/view/view_page.h"

namespace scb::app {

struct InspectOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    QueryOptions query;
    KindOptions kind;
    QueryLimits limits;
    LayoutOptions layout;
    PictureOptions picture{.output = ""};
    std::vector<std::string> recording;    ///< see given_recording_options
    std::vector<std::string> of_pictures;  ///< given options that only pictures use
    std::string command, explain;          ///< see InspectPage
    std::string of_scene;                  ///< the given options of the scene, see given_text
    std::string of_files;                  ///< the given options of the meshes
    // The meshes and poses of a recording, and the frames: `scb collide` selects no recorded query.
    std::string of_meshes, of_frames;
    std::string of_bodies;     ///< the given options of the scene, without its frames
    std::string of_distances;  ///< the given limits of queries of distances
    ViewOptions view;          ///< only its texts of given options
    int top = 10;
    bool asks_top = false;  ///< --top was given
    bool time = false;
    bool no_view = false;
    bool full = false;       ///< all tables are printed
    bool no_advice = false;  ///< no other settings are tried

    bool draws() const { return !picture.output.empty(); }
    /// With a packed layout, makes its queries until interrupted. They are then inspected as a
    /// recording. Returns whether it has a packed layout. Throws InputError.
    bool take_layout(const Console& console, const InterruptWatch& watch);
    /// Throws InputError.
    void check();
};

}  // namespace scb::app
