#pragma once

#include "app/pictures/query_view.h"
#include "render/figures/pairs_figure.h"

namespace scb::app {

/// "pairs", "pairs with leaves", "contact patches".
std::string pairs_title(const render::PairsStyle& style);

/// The picture of `scb render pairs` for a query's frame: the contact, with camera, numbers and
/// legend. `bodies` are the view's at that frame.
render::SceneFigure pairs_figure(const QueryView& view, const QuerySource& source,
                                 const QueryTrace& frame, const render::QueryBodies& bodies,
                                 const render::PairsStyle& style);

/// Sets the camera as in the view's options, and names the frame: common to all pictures of a query
/// with meshes. `region`: of contact_region.
void look_at_contact(render::SceneFigure& figure, const QueryView& view, const QueryTrace& frame,
                     const std::vector<AnyVolume>& region);

}  // namespace scb::app
