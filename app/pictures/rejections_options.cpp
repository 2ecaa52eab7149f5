#include "app/pictures/rejections_options.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "app/cli/choice.h"
#include "app/cli/validators.h"
#include "app/study/scene_setup.h"
#include "core/base/text_format.h"
#include "core/platform/number_list.h"
#include "scb/error.h"

namespace scb::app {
namespace {

/// The default share of ended paths. Without the volumes of the other paths, most of a CAD model
/// can be seen.
constexpr double default_focus = 0.5;

std::string names_of(const TraceHeader& header, const std::vector<Stage>& endings) {
    std::string names;
    for (const Stage ending : endings)
        names += (names.empty() ? "" : ", ") + stage_words(header, ending);
    return names;
}

/// "7" or "0:9".
std::pair<int, int> depth_range(const std::string& text, int deepest_level) {
    const std::string option = "--depth " + text;
    const std::string hint = "; give a level such as 7, or the first and the last such as 0:9.";
    const std::vector<std::string> parts = split_list(text, ':');
    if (parts.size() > 2) throw InputError(option + ": these are not two levels" + hint);
    const int first = whole_number(parts.front(), option, hint),
              last = whole_number(parts.back(), option, hint);
    if (first < 0 || last < first || last > deepest_level)
        throw InputError(option + ": this scene's hierarchies have the levels 0 to " +
                         std::to_string(deepest_level) + hint);
    return {first, last};
}

int deepest_level(const QuerySource& source) {
    const int frame = source.frames().front();
    return std::max(depth(source.body(0, frame).tree->shape()),
                    depth(source.body(1, frame).tree->shape()));
}

}  // namespace

render::RejectionsStyle RejectionsOptions::style(const QuerySources& sources) const {
    const QuerySource& source = sources.front();
    render::RejectionsStyle result;
    result.by = by;
    std::vector<Stage> known;
    for (const QuerySource& each : sources)
        for (const Stage ending : endings_of(each.header()))
            if (std::find(known.begin(), known.end(), ending) == known.end())
                known.push_back(ending);
    if (!stages.empty())
        for (const std::string& name : split_list(stages)) {
            std::optional<Stage> ending;
            for (const QuerySource& each : sources)
                if (!ending) ending = ending_of(each.header(), name);
            if (!ending || std::find(known.begin(), known.end(), *ending) == known.end())
                throw InputError("--stages " + stages + ": '" + name +
                                 "' is not an ending of these queries; give some of " +
                                 names_of(source.header(), known) + ".");
            result.filter.endings.push_back(*ending);
        }
    if (!depths.empty())
        std::tie(result.filter.least_depth, result.filter.most_depth) =
            depth_range(depths, deepest_level(source));
    const TraceHeader& header = source.header();
    if (!body.empty()) {
        for (std::size_t side = 0; side < 2; ++side)
            result.sides[side] = header.bodies[side].name == body;
        // A and B always mean the first and the second body.
        if (!result.sides[0] && !result.sides[1]) result.sides = {body == "A", body == "B"};
        if (!result.sides[0] && !result.sides[1])
            throw InputError("--body " + body + ": the bodies are " + header.bodies[0].name +
                             " and " + header.bodies[1].name + "; give one of them.");
    }
    if (!(opacity > 0 && opacity <= 1))
        throw InputError(
            format("--opacity %g: give a number above 0 (clear) up to 1 (opaque).", opacity));
    result.opacity = opacity;
    result.nested = nested;
    if (focus && !(*focus > 0 && *focus <= 1))
        throw InputError(
            format("--focus %g: give a share of the ended paths, above 0 up to 1 (all).", *focus));
    // Animations show every test.
    const bool whole = steps || nested;
    result.focus = focus.value_or(whole ? 1 : default_focus);
    result.theme = picture.theme();
    return result;
}

std::string RejectionsOptions::filtered(std::string text) const {
    const auto add = [&text](const std::string& what, const std::string& value) {
        if (!value.empty()) text += (text.empty() ? "only " : ", only ") + what + value;
    };
    add("body ", body);
    add("levels ", depths);
    add("", stages);
    return text;
}

std::string RejectionsOptions::title() const {
    std::string text = "rejections";
    if (by != RejectionsOptions{}.by) text += " by " + std::string(render::node_color_names[by]);
    return filtered("").empty() ? text : text + ", filtered";
}

NamedOptions RejectionsOptions::changed() const {
    const RejectionsOptions usual;
    NamedOptions result;
    result.add_if(by != usual.by, "by", std::string(render::node_color_names[by]));
    result.add_if(!stages.empty(), "stages", stages);
    result.add_if(!depths.empty(), "depth", depths);
    result.add_if(!body.empty(), "body", body);
    result.add_if(opacity != usual.opacity, "opacity", exact_number(opacity));
    result.add_if(nested, "nested");
    if (focus) result.add("focus", exact_number(*focus));
    return result;
}

void add_rejections_options(const Command& command, RejectionsOptions& options) {
    add_query_view_options(command, options, Shown::volumes);
    add_choice(command, "--by", options.by, choices_of(render::node_color_names),
               "Color of a node at which several paths ended: its first, last or most frequent "
               "(dominant) ending; or share, the share of its tests that rejected")
        .type_name("WHICH")
        .shareable();
    command
        .add_option(
            "--stages,--stage", options.stages,
            "Only paths with these endings: names of stages, 'triangles apart', 'triangles meet'")
        .type_name("LIST")
        .shareable();
    command.add_option("--depth", options.depths, "Only nodes of these levels: 7 or 0:9")
        .type_name("A:B")
        .shareable();
    command.add_option("--body", options.body, "Draw only the nodes of this body; counts stay")
        .type_name("NAME")
        .shareable();
    command
        .add_option("--opacity", options.opacity, "Opacity of the volumes: more than 0, at most 1")
        .check(real_number)
        .show_default()
        .shareable();
    command
        .add_option("--focus", options.focus,
                    "Leave out the volumes that are large for their paths, as long as this share "
                    "of paths is "
                    "seen; 1: none. Default: 0.5, and 1 with --nested or --steps")
        .check(real_number)
        .type_name("SHARE")
        .shareable();
    command
        .add_flag(
            "--nested", options.nested,
            "Also draw nodes that contain other drawn nodes (use --opacity below 1 to see both)")
        .shareable();
    command
        .add_option("--steps", options.steps,
                    "Draw an animation: the first N tests, the first 2N, and so on, each with the "
                    "pair that was tested last")
        .check(decimal_number)
        .type_name("N")
        .shareable();
}

}  // namespace scb::app
