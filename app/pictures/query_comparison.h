#pragma once

#include "app/pictures/query_view.h"
#include "render/figures/query_comparison.h"

namespace scb {

/// The two queries of a view at a frame.
ComparedQueries compared_queries(const QueryView& view, const QuerySources& sources,
                                 const QueryFrames& frames);

/// Gives the views captions and camera, and draws them as one picture. `title` and `what` are
/// QueryView's, of the title and of file names.
void draw_comparison(const QueryView& view, const ComparedQueries& queries,
                     const PairsOfOne& only_here, std::array<ComparedView, 2> views,
                     const std::string& title, const std::string& what,
                     const QueryViewOptions& options, PictureRun& pictures);

}  // namespace scb
