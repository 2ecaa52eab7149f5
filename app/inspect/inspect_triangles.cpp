#include "app/inspect/inspect_triangles.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/command_text.h"
#include "app/inspect/inspect_findings.h"
#include "app/timing/tune_layout_report.h"
#include "core/base/text_format.h"
#include "core/platform/utf8.h"
#include "render/figures/inspect_figure.h"
#include "render/overlay/figure_layout.h"
#include "scenes/scene/scene.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

std::string body_name(const InspectReport& report, std::size_t side) {
    return report.header.bodies[side].name;
}

std::uint64_t tests_together(const BodyTriangles& body) {
    std::uint64_t sum = 0;
    for (const CostlyTriangle& one : body.costly) sum += one.tests.items;
    return sum;
}

/// Both bodies if they have the same mesh.
std::string bodies_of(const InspectReport& report, const MeshCut& cut) {
    const auto& [a, b] = report.header.bodies;
    return report.causes.alike && a.name != b.name ? a.name + " and " + b.name
                                                   : body_name(report, cut.side);
}

}  // namespace

Table triangles_table(const InspectReport& report, std::size_t most) {
    std::size_t width = 4;
    for (std::size_t side = 0; side < 2; ++side)
        width = std::max(width, character_count(printable(body_name(report, side))));
    Table table({{.title = "body", .key = "body", .width = width, .align = Align::left},
                 {.title = "triangle", .key = "triangle", .width = 9, .before = 2},
                 {.title = "N_p", .key = "n_p", .width = 10, .before = 2},
                 {.title = "share", .key = "share", .width = 7, .before = 1},
                 {.title = "N_v of its nodes", .key = "n_v", .width = 16, .before = 2},
                 {.title = "longest side", .key = "longest_side", .width = 12, .before = 2},
                 {.title = "slenderness", .key = "slenderness", .width = 11, .before = 2}});
    for (std::size_t side = 0; side < 2; ++side) {
        const BodyTriangles& body = report.triangles[side];
        for (std::size_t i = 0; i < std::min(most, body.costly.size()); ++i) {
            const auto& [tests, size] = body.costly[i];
            const double part = static_cast<double>(tests.items) / static_cast<double>(body.tests);
            table.add({Cell(body_name(report, side), printable(body_name(report, side))),
                       tests.triangle,
                       {tests.items, render::count_text(tests.items)},
                       {part, share(tests.items, body.tests)},
                       {tests.volumes, render::count_text(tests.volumes)},
                       {size.longest_side, "%.3g"},
                       std::isfinite(size.slenderness) ? Cell(size.slenderness, "%.3g")
                                                       : Cell(Json(), std::string("no area"))});
        }
    }
    return table;
}

std::vector<std::string> triangle_sentences(const InspectReport& report) {
    std::vector<std::string> sentences;
    for (std::size_t side = 0; side < 2; ++side) {
        const BodyTriangles& body = report.triangles[side];
        if (body.tests == 0) continue;
        const std::uint64_t together = tests_together(body);
        sentences.push_back(counted(body.costly.size(), "triangle", "triangles") + " of " +
                            printable(body_name(report, side)) +
                            (body.costly.size() == 1 ? " takes part in " : " take part in ") +
                            share(together, body.tests) + " of the triangle tests.");
    }
    return sentences;
}

std::vector<std::string> cut_sentences(const InspectReport& report) {
    if (!has_advice(report) || !report.settings->cuts) return {};
    const CutTrial& cuts = *report.settings->cuts;
    const SceneTuning& tuning = report.settings->tuning;
    std::string what;
    for (const MeshCut& cut : cuts.meshes)
        what += (what.empty() ? "" : " and ") + counted(cut.triangles, "triangle", "triangles") +
                " of " + printable(bodies_of(report, cut)) + " into " +
                counted(cut.pieces, "piece", "pieces");
    const auto changes = [](const Work& from, const Work& to) {
        return "N_v " + render::change_text(from.volume_tests, to.volume_tests) + ", N_p " +
               render::change_text(from.triangle_tests, to.triangle_tests) + ", cost " +
               render::change_text(from.picoseconds, to.picoseconds);
    };
    const std::string with_best =
                          changes(cuts.before, cuts.after) + " with " + recommended_text(tuning),
                      with_base = changes(cuts.base_before, cuts.base_after) + " with " +
                                  (report.settings->recorded
                                       ? std::string(volume_kind_name(tuning.base().setting.volume))
                                       : "the present setting");
    const bool helps_best = cuts.after.picoseconds < cuts.before.picoseconds,
               has_best = tuning.cheapest_layout() || tuning.recommended() != 0;
    if (!has_best) return {"Cut " + what + ": " + with_base + "."};
    if (helps_best) return {"Cut " + what + ": " + with_best + "; " + with_base + "."};
    return {"Only if you keep the present setting, cut " + what + ": " + with_base + "; " +
            with_best + "."};
}

std::vector<std::string> cut_commands(const InspectReport& report) {
    if (!has_advice(report) || !report.settings->cuts) return {};
    std::vector<std::string> commands;
    for (const MeshCut& cut : report.settings->cuts->meshes) {
        std::string numbers;
        for (const std::uint32_t triangle : cut.seeds)
            numbers += (numbers.empty() ? " --triangles " : ",") + std::to_string(triangle);
        const std::string name = body_name(report, cut.side);
        commands.push_back("scb export" + report.settings->scene + " --body " + file_word(name) +
                           " --cut " + exact_number(cut.longest) + numbers + " -o " +
                           file_word(scenes::file_name_of(name) + "-cut.ply"));
    }
    return commands;
}

Json cuts_json(const InspectReport& report) {
    const CutTrial& cuts = *report.settings->cuts;
    Json json = {{"meshes", Json::array()}};
    const std::vector<std::string> commands = cut_commands(report);
    for (std::size_t i = 0; i < cuts.meshes.size(); ++i) {
        const MeshCut& cut = cuts.meshes[i];
        json["meshes"].push_back({{"body", body_name(report, cut.side)},
                                  {"triangles", cut.triangles},
                                  {"pieces", cut.pieces},
                                  {"longest_side", cut.longest},
                                  {"command", commands[i]}});
    }
    const auto work = [](const Work& of) {
        return Json{{"n_v", of.volume_tests},
                    {"n_p", of.triangle_tests},
                    {"cost", static_cast<double>(of.picoseconds) / 1000}};
    };
    json["setting"] = recommended_text(report.settings->tuning);
    json["before"] = work(cuts.before);
    json["after"] = work(cuts.after);
    json["base"] = {{"before", work(cuts.base_before)}, {"after", work(cuts.base_after)}};
    return json;
}

}  // namespace scb::app
