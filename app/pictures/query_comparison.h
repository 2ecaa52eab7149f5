#pragma once

#include "app/pictures/query_view.h"
#include "render/figures/query_comparison.h"

namespace scb::app {

/// The two queries of a view at a frame.
render::ComparedQueries compared_queries(const QueryView& view, const QuerySources& sources,
                                         const QueryFrames& frames);

/// Gives the views captions and camera, and draws them as one picture. `title` and `what`: see
/// QueryView, for the title and for file names.
void draw_comparison(const QueryView& view, const render::ComparedQueries& queries,
                     const render::PairsOfOne& only_here, std::array<render::ComparedView, 2> views,
                     const std::string& title, const std::string& what,
                     const QueryViewOptions& options, PictureRun& pictures);

}  // namespace scb::app
