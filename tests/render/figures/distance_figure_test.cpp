#include "render/figures/distance_figure.h"

#include <gtest/gtest.h>

namespace scb::render {
namespace {

/// The first value of the panel's row with this label.
std::string value_of(const std::vector<PanelItem>& panel, const std::string& label) {
    for (const PanelItem& item : panel)
        if (const auto* row = std::get_if<PanelRow>(&item); row != nullptr && row->label == label)
            return row->values.front();
    return "";
}

TEST(DistanceFigure, CountsPairsThatWereDividedInVain) {
    TraceHeader header;
    header.kind = QueryKind::distance;
    header.volume = VolumeKind::scb2;
    QueryTrace frame;
    // The roots lead to the answer in 1,0; 2,0 is divided in vain, and both pairs below it end.
    frame.steps.volumes = {{{0, 0}, 0, 0, Stage::overlapping, no_step},
                           {{1, 0}, 1, 0, Stage::overlapping, 0},
                           {{2, 0}, 1, 0, Stage::overlapping, 0},
                           {{2, 1}, 1, 1, Stage::slab_a, 2},
                           {{2, 2}, 1, 1, Stage::overlapping, 2}};
    frame.steps.items = {{{4, 5}, 1, true, false}};
    frame.found.n_v = 5;
    frame.found.pairs = {{4, 5}};
    frame.nearest = TriangleDistance{1, Vec3::Zero(), Vec3::UnitX()};
    DistanceSteps steps;
    steps.answer = 1;
    steps.bounds = {0, 0.5, 0.5, 2, 1.5};
    steps.exact = {Contact::overlapping, Contact::overlapping, Contact::overlapping,
                   Contact::disjoint, Contact::overlapping};
    steps.gaps = {0, 0, 0, 1, 0};
    steps.nearest = {1, 1, 0, 0, 0};
    const Mesh mesh{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()}, {{0, 1, 2}}};
    QueryBodies bodies;
    for (QueryBody& body : bodies) body.mesh = &mesh;
    const Attribution verdicts =
        attribute(header, frame, tested_pairs(steps, frame, outcomes_of(header, frame)));
    const std::vector<PanelItem> panel =
        distance_panel(bodies, header, frame, verdicts, light_theme);
    EXPECT_EQ(value_of(panel, "passed on"), "2");
    EXPECT_EQ(value_of(panel, "of these in vain"), "1");
}

}  // namespace
}  // namespace scb::render
