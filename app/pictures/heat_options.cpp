#include "app/pictures/heat_options.h"

#include "app/cli/choice.h"
#include "app/cli/command.h"
#include "app/cli/validators.h"
#include "scb/error.h"

namespace scb::app {

void HeatOptions::check() const {
    if (end && (!of || *end < 2))
        throw InputError("--heat-end " + std::to_string(*end) + ": give at least 2, and --heat.");
}

std::optional<std::uint32_t> HeatOptions::scale_end() const {
    if (!end) return std::nullopt;
    return static_cast<std::uint32_t>(*end);
}

std::string HeatOptions::title() const {
    return "heat of " + std::string(*of == HeatOf::wasted    ? "wasted tests"
                                    : *of == HeatOf::volumes ? "volume tests"
                                                             : "triangle tests");
}

std::string HeatOptions::name() const { return "heat-" + std::string(render::heat_names[*of]); }

void add_heat_options(const Command& command, HeatOptions& options, const std::string& found) {
    add_choice(command, "--heat", options.of, optional_choices(choices_of(render::heat_names)),
               "Color triangles by number of tests: tests of the volumes that hold the triangle, "
               "of the triangle itself, or wasted ones of volumes, which led to no " +
                   found)
        .type_name("volumes|triangles|wasted")
        .shareable();
    command
        .add_option("--heat-end", options.end,
                    "Count at the end of the color scale. Default: the first of 1, 2 and 5 times a "
                    "power of ten that holds all counts")
        .check(decimal_number)
        .type_name("N")
        .shareable();
}

render::SceneFigure heat_figure(const QueryView& view, const QuerySource& source,
                                const QueryTrace& frame, const HeatOptions& options) {
    const render::QueryBodies bodies = view.bodies(frame.frame);
    std::vector<bool> wasted;
    if (options.of == HeatOf::wasted)
        wasted = is_of_distance(source.header().kind)
                     ? wasted_tests(source.attribution(frame))
                     : wasted_tests(frame.steps, outcomes_of(source.header(), frame));
    const render::Heat heat =
        render::heat_of(bodies, frame, *options.of, options.scale_end(), wasted);
    render::SceneFigure figure;
    figure.title = view.title(options.title());
    figure.pane = render::heat_pane(bodies, heat);
    figure.panel = render::heat_panel(bodies, source.header(), frame, heat);
    if (heat.most == 0) figure.remark = "no such test";
    return figure;
}

}  // namespace scb::app
