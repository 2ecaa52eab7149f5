#pragma once

#include <vector>

#include "app/pictures/level_options.h"
#include "render/figures/level_figure.h"
#include "scenes/recordings/recorded_bodies.h"

namespace scb::app {

/// The bodies as pictures of levels need them; their nodes have ids from 1 on, body after body.
/// `handles` is empty where no mesh is drawn. Throws InputError where ids run out.
std::vector<render::LevelBody> level_bodies(const std::vector<scenes::BodyAtFrame>& bodies,
                                            const std::vector<render::MeshHandle>& handles);

/// How levels of these bodies look.
render::LevelStyle level_style(const LevelOptions& options,
                               const std::vector<scenes::BodyAtFrame>& bodies, int deepest);

}  // namespace scb::app
