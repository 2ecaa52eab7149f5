#include "app/pictures/pairs_figure.h"

#include "render/figures/patch_labels.h"

namespace scb::app {

std::string pairs_title(const render::PairsStyle& style) {
    return style.leaves ? "pairs with leaves" : style.patches ? "contact patches" : "pairs";
}

void look_at_contact(render::SceneFigure& figure, const QueryView& view, const QueryTrace& frame,
                     const std::vector<AnyVolume>& region) {
    figure.subtitle = view.subtitle(frame.frame);
    figure.pane.camera = view.camera(region);
    figure.center = view.center(region);
    figure.theme = view.options().picture.theme();
    figure.with_panel = !view.options().picture.no_panel;
}

render::SceneFigure pairs_figure(const QueryView& view, const QuerySource& source,
                                 const QueryTrace& frame, const render::QueryBodies& bodies,
                                 const render::PairsStyle& style) {
    const TraceHeader& header = source.header();
    render::SceneFigure figure;
    figure.title = view.title(pairs_title(style));
    const std::vector<render::Segment> contact = render::contact_segments(bodies, header, frame);
    const std::vector<AnyVolume> region = render::contact_region(bodies, header, frame, contact);
    figure.pane = render::pairs_pane(bodies, header, frame, contact, style, view.ids().first_free);
    std::vector<ContactPatch> patches;
    if (style.patches) patches = render::patches_of(bodies, header, frame);
    figure.panel = render::pairs_panel(bodies, header, frame, style, patches);
    if (frame.found.pairs.empty())
        figure.remark = "no contact";
    else if (!frame.found.complete)
        figure.remark = stopped_remark(frame);
    look_at_contact(figure, view, frame, region);
    if (style.patches)
        figure.labels =
            render::patch_labels(patches, bodies, contact, figure.pane.camera, *style.theme);
    view.show_place_of_contact(figure, region);
    return figure;
}

}  // namespace scb::app
