#include "app/pictures/pairs_figure.h"

namespace scb::app {

std::string pairs_title(const render::PairsStyle& style) {
    return style.leaves ? "pairs with leaves" : "pairs";
}

void look_at_contact(render::SceneFigure& figure, const QueryView& view, const TraceHeader& header,
                     const QueryTrace& frame, const render::QueryBodies& bodies) {
    const std::vector<AnyVolume> region = render::contact_region(bodies, header, frame);
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
    figure.pane = render::pairs_pane(bodies, header, frame, style, view.ids().first_free);
    figure.panel = render::pairs_panel(bodies, header, frame, style);
    if (frame.found.pairs.empty())
        figure.remark = "no contact";
    else if (!frame.found.complete)
        figure.remark = stopped_remark(frame);
    look_at_contact(figure, view, header, frame, bodies);
    view.show_small_contact(figure, render::contact_region(bodies, header, frame));
    return figure;
}

}  // namespace scb::app
