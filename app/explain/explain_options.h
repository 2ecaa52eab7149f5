#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/pictures/picture_options.h"
#include "app/query/query_options.h"
#include "scenes/text/number_list.h"

namespace scb::app {

/// What `scb explain` understands.
struct ExplainOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    QueryOptions query{.frames = scenes::auto_frames};
    PictureOptions picture{.output = ""};
    CameraOptions camera;
    std::string pair, pairs_file;
    /// Of those given, the ones that --pairs has no use for, those that a trace knows, and those
    /// of pictures.
    std::vector<std::string> of_scenes, recording, of_pictures;

    bool draws() const { return !picture.output.empty(); }
    /// Refuses what makes no sense before any work is done; throws InputError.
    void check() const;
    /// The numbers of --pair; throws InputError.
    std::array<std::int64_t, 2> nodes() const;
};

void add_explain_options(const Command& command, ExplainOptions& options);
/// Notes which of them were given.
void note_given(const Command& command, ExplainOptions& options);

}  // namespace scb::app
