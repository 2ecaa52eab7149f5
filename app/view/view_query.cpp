#include "app/view/view_query.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/cli/command_text.h"
#include "app/view/view_manifest.h"
#include "app/view/view_steps.h"
#include "core/analysis/ending.h"
#include "core/analysis/traversal_part.h"
#include "core/analysis/worst_pairs.h"
#include "core/base/parallel_for.h"
#include "core/platform/utf8.h"
#include "render/figures/distance_figure.h"
#include "render/figures/explain_figure.h"
#include "render/figures/inspect_figure.h"
#include "render/web/query_blocks.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

/// Number of the worst pairs of each kind listed in a page.
constexpr std::size_t most_worst = 8;
/// Limit of the counted pairs of a level: a page of many frames must be made in seconds.
constexpr std::size_t most_overlaps = 20'000;

/// A pair that a query of distances left over has nothing below that was done in vain.
bool ends_a_path(const TraceHeader& header, Stage ending) {
    return is_rejection(ending) || (is_of_distance(header.kind) && ending == Stage::left_over);
}

Json groups_json(const TraceHeader& header) {
    const std::vector<render::EndingGroup> light =
                                               render::ending_groups(header, render::light_theme),
                                           dark = render::ending_groups(header, render::dark_theme);
    Json groups = Json::array();
    for (std::size_t i = 0; i < light.size(); ++i) {
        // Endings of tests of two leaves' triangles, which are drawn in place of the leaves.
        const bool triangles =
            std::all_of(light[i].endings.begin(), light[i].endings.end(), [](Stage ending) {
                return ending == Stage::triangles_apart || ending == Stage::triangles_meet;
            });
        const bool meet = std::find(light[i].endings.begin(), light[i].endings.end(),
                                    Stage::triangles_meet) != light[i].endings.end();
        std::string stages;  // names as in --stages of scb render rejections
        for (const Stage ending : light[i].endings)
            stages += (stages.empty() ? "" : ",") + stage_words(header, ending);
        groups.push_back({{"label", printable(render::ending_words(light[i], header.kind))},
                          {"stages", file_word(stages)},
                          {"light", color_json(light[i].color)},
                          {"dark", color_json(dark[i].color)},
                          {"triangles", triangles},
                          {"meet", meet},
                          {"rejects", ends_a_path(header, light[i].endings.front())}});
    }
    return groups;
}

/// The verdicts on tests that are not right, in the order of render/web/query.js.
Json worths_json(QueryKind kind) {
    Json worths = Json::array();
    const auto add = [&worths](const char* label, auto color) {
        worths.push_back({{"label", label},
                          {"light", color_json(color(render::light_theme))},
                          {"dark", color_json(color(render::dark_theme))}});
    };
    const bool is_distance = is_of_distance(kind);
    for (const auto& [label, reason] :
         {std::pair{is_distance ? "bound below the distance" : "fit too loose",
                    PassReason::loose_fit},
          {is_distance ? "before it was known" : "test too weak", PassReason::weak_test}})
        add(label, [reason = reason](const render::Theme& theme) {
            return render::pass_reason_color(reason, theme);
        });
    add("rejected wrongly", render::wrong_rejection_color);
    return worths;
}

/// The worst tests of all frames.
struct Worst {
    WorstPairs fits{PassReason::loose_fit, most_worst}, tests{PassReason::weak_test, most_worst};
    WorstRejections wrong{most_worst};

    void add(const QueryTrace& frame, const Attribution& attribution) {
        fits.add(frame, attribution);
        tests.add(frame, attribution);
        wrong.add(frame, attribution);
    }

    void add(const Worst& of_other_frames) {
        fits.add(of_other_frames.fits.outermost(), of_other_frames.fits.parts());
        tests.add(of_other_frames.tests.outermost(), of_other_frames.tests.parts());
        wrong.add(of_other_frames.wrong.pairs());
    }

    /// Lists by the index of the verdict, with the nodes' numbers.
    Json json() const {
        Json worst = Json::array();
        for (const WorstPairs* pairs : {&fits, &tests}) {
            Json list = Json::array();
            for (const FalsePair& pair : pairs->pairs()) {
                if (pair.pair.below == Work{}) continue;
                list.push_back({{"frame", pair.frame},
                                {"test", pair.pair.test},
                                {"nodes", Json{pair.test.nodes.a, pair.test.nodes.b}},
                                {"n_v", pair.pair.below.volume_tests},
                                {"n_p", pair.pair.below.triangle_tests}});
            }
            worst.push_back(std::move(list));
        }
        Json list = Json::array();
        for (const WronglyRejectedPair& pair : wrong.pairs())
            list.push_back({{"frame", pair.frame},
                            {"test", pair.rejection.test},
                            {"nodes", Json{pair.test.nodes.a, pair.test.nodes.b}},
                            {"missed", pair.rejection.missed}});
        worst.push_back(std::move(list));
        return worst;
    }
};

/// The verdicts on the tests of a query of distances, as the page names them: pairs that passed
/// early, and all others in vain.
Attribution in_two_classes(Attribution attribution) {
    const auto renamed = [](PassReason reason) {
        if (reason == PassReason::triangles_meet) return reason;
        return reason == PassReason::early ? PassReason::weak_test : PassReason::loose_fit;
    };
    for (PassedPair& pair : attribution.passed) {
        pair.reason = renamed(pair.reason);
        pair.within = renamed(pair.within);
    }
    return attribution;
}

/// Tests whose steps a reader looks for first: the worst of each kind, and all wrong rejections.
std::vector<std::uint32_t> worst_tests(const Worst& worst, const Attribution& attribution) {
    std::vector<std::uint32_t> tests;
    for (const WorstPairs* pairs : {&worst.fits, &worst.tests})
        for (const FalsePair& pair : pairs->pairs()) tests.push_back(pair.pair.test);
    for (const WrongRejection& rejection : attribution.wrongly_rejected)
        tests.push_back(rejection.test);
    return tests;
}

/// A frame of a page.
struct FramePart {
    Json entry;                 ///< with numbers of its own blocks
    render::BlockStore blocks;  ///< compressed before the frame's turn comes
    Worst worst;
};

/// The keys of an entry whose values are numbers of blocks.
constexpr std::array block_keys = {"outcomes", "pair_block", "nodes", "bounds", "lines", "steps"};

/// Makes the parts of the frames of a column.
class PartMaker {
  public:
    PartMaker(const ViewColumn& column, std::size_t steps)
        : source_(*column.query),
          groups_(render::ending_groups(source_.header(), render::light_theme)),
          most_steps_(steps == 0 ? 0 : std::max<std::size_t>(1, steps / source_.frames().size())) {
        for (std::size_t side = 0; side < 2; ++side) {
            bodies_[side].mesh = column.bodies[side].mesh.get();
            bodies_[side].tree = column.bodies[side].tree.get();
            // Builds the tree before threads ask for it.
            if (source_.makes_queries()) source_.body(side, source_.frames().front());
        }
    }

    FramePart part(const QueryTrace& frame) const {
        const TraceHeader& header = source_.header();
        const Outcomes outcomes = outcomes_of(header, frame);
        std::optional<DistanceSteps> steps;
        if (is_of_distance(header.kind)) steps = source_.query().distance_steps(header, frame);
        const Attribution attribution =
            steps ? in_two_classes(attribute(header, frame, tested_pairs(*steps, frame, outcomes)))
                  : source_.attribution(frame);
        FramePart part;
        part.worst.add(frame, attribution);
        const render::QueryBlocks blocks =
            render::query_blocks(bodies_, frame, outcomes, attribution, groups_, part.blocks);
        part.entry = {{"frame", frame.frame},
                      {"n_v", frame.found.n_v},
                      {"n_p", frame.found.n_p},
                      {"pairs", frame.found.pairs.size()},
                      {"judged", attribution.counts.all.volume_tests > 0},
                      {"wasted", attribution.counts.wasted().volume_tests},
                      {"overlaps", source_.level_overlaps(frame, most_overlaps)},
                      {"outcomes", blocks.outcomes},
                      {"pair_block", blocks.pairs}};
        if (blocks.nodes) part.entry["nodes"] = *blocks.nodes;
        if (steps) {
            add_distance(part, frame, *steps);
            return part;
        }
        if (!source_.is_recording() && most_steps_ > 0)
            part.entry["steps"] = part.blocks.add(std::string_view(
                view_steps_json(
                    source_.query(), frame,
                    costly_tests(frame.steps, worst_tests(part.worst, attribution), most_steps_))
                    .dump(-1, ' ', false, Json::error_handler_t::replace)));
        return part;
    }

  private:
    /// The bounds of the tests, and the lines between the closest points.
    void add_distance(FramePart& part, const QueryTrace& frame, const DistanceSteps& steps) const {
        if (frame.nearest) part.entry["distance"] = frame.nearest->distance;
        part.entry["bounds"] =
            part.blocks.add(std::vector<float>(steps.bounds.begin(), steps.bounds.end()));
        std::vector<double> lines;
        for (const auto& [of_a, of_b] : render::distance_lines(bodies_, frame))
            for (const Vec3& point : {of_a, of_b})
                lines.insert(lines.end(), {point[0], point[1], point[2]});
        part.entry["lines"] = part.blocks.add(lines);
    }

    const QuerySource& source_;
    std::vector<render::EndingGroup> groups_;
    std::size_t most_steps_;
    render::QueryBodies bodies_;
};

}  // namespace

Json view_query_json(const ViewColumn& column, const std::vector<int>& in_page, std::size_t steps,
                     render::BlockStore& store, const std::function<void()>& step) {
    QuerySource& source = *column.query;
    const TraceHeader& header = source.header();
    std::vector<int> numbers;
    std::set_intersection(source.frames().begin(), source.frames().end(), in_page.begin(),
                          in_page.end(), std::back_inserter(numbers));
    const PartMaker maker(column, steps);
    Json frames = Json::array();
    Worst worst;
    // A recording is read frame by frame. Each thread holds a query with all its tests.
    const int threads = source.makes_queries() ? std::min(processor_count(), 8) : 1;
    const std::size_t at_once = threads == 1 ? 1 : 4 * static_cast<std::size_t>(threads);
    for (std::size_t first = 0; first < numbers.size(); first += at_once) {
        std::vector<FramePart> parts(std::min(at_once, numbers.size() - first));
        if (threads == 1)
            parts[0] = maker.part(source.frame(numbers[first]));
        else
            parallel_for(threads, parts.size(), [&](std::size_t i) {
                parts[i] = maker.part(source.frame_again(numbers[first + i]));
            });
        for (FramePart& part : parts) {
            for (const char* key : block_keys)
                if (part.entry.contains(key))
                    part.entry[key] =
                        store.add(part.blocks.blocks()[part.entry[key].get<std::size_t>()]);
            worst.add(part.worst);
            frames.push_back(std::move(part.entry));
            step();
        }
    }
    Json symbols = Json::array();
    if (!source.is_recording())
        for (const std::string_view line :
             render::symbol_lines(header.volume, header.options.overlap))
            symbols.push_back(line);
    return {{"objects", pairs_are_nodes(header)}, {"distance", is_of_distance(header.kind)},
            {"symbols", std::move(symbols)},      {"groups", groups_json(header)},
            {"worths", worths_json(header.kind)}, {"worst", worst.json()},
            {"frames", std::move(frames)}};
}

}  // namespace scb::app
