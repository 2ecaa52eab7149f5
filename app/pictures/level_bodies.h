#pragma once

#include <vector>

#include "app/pictures/level_options.h"
#include "render/figures/level_figure.h"
#include "scenes/recordings/recorded_bodies.h"

namespace scb::app {

/// The bodies for pictures of levels; their nodes have ids from 1 on, body after body. `handles` is
/// empty if no mesh is drawn. Throws InputError if there are not enough ids.
std::vector<render::LevelBody> level_bodies(const std::vector<BodyAtFrame>& bodies,
                                            const std::vector<render::MeshHandle>& handles);

/// The style of levels of these bodies.
render::LevelStyle level_style(const LevelOptions& options, const std::vector<BodyAtFrame>& bodies,
                               int deepest);

}  // namespace scb::app
