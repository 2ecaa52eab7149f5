#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/pictures/picture_options.h"
#include "app/query/query_options.h"
#include "core/platform/number_list.h"

namespace scb::app {

/// Options of `scb explain`.
struct ExplainOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    QueryOptions query{.frames = auto_frames};
    PictureOptions picture{.output = "", .takes_file = true};
    CameraOptions camera;
    std::string pair, pairs_file;
    /// Given options that do not apply to --pairs, that a trace already has, and that only pictures
    /// use.
    std::vector<std::string> of_scenes, recording, of_pictures;

    bool draws() const { return !picture.output.empty(); }
    /// Refuses invalid options before any work is done; throws InputError.
    void check() const;
    /// The numbers of --pair; throws InputError.
    std::array<std::int64_t, 2> nodes() const;
};

void add_explain_options(const Command& command, ExplainOptions& options);
/// Notes which options were given.
void note_given(const Command& command, ExplainOptions& options);

}  // namespace scb::app
