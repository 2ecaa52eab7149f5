#pragma once

#include "app/pictures/query_view.h"
#include "render/figures/pairs_figure.h"

namespace scb::app {

/// "pairs", "pairs with leaves".
std::string pairs_title(const render::PairsStyle& style);

/// What `scb render pairs` draws of a query's frame: the contact, with camera, numbers and legend.
/// `bodies` are the view's at that frame.
render::SceneFigure pairs_figure(const QueryView& view, const QuerySource& source,
                                 const TraceFrame& frame, const render::QueryBodies& bodies,
                                 const render::PairsStyle& style);

/// Looks at the contact, as the view's options wish, and says which frame it is: what all pictures
/// of a query with meshes have in common.
void look_at_contact(render::SceneFigure& figure, const QueryView& view, const TraceHeader& header,
                     const TraceFrame& frame, const render::QueryBodies& bodies);

}  // namespace scb::app
