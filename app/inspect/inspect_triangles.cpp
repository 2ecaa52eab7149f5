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
std::string bodies_of(const InspectReport& report, std::size_t side) {
    const auto& [a, b] = report.header.bodies;
    return report.causes.alike && a.name != b.name ? a.name + " and " + b.name
                                                   : body_name(report, side);
}

/// The change of the meshes, and what it saves. `change`: "cut 3 triangles of A into 9 pieces".
std::string trial_sentence(const InspectReport& report, std::string change, const TrialWork& work) {
    const SceneTuning& tuning = report.settings->tuning;
    const auto changes = [](const Work& from, const Work& to) {
        return "N_v " + render::change_text(from.volume_tests, to.volume_tests) + ", N_p " +
               render::change_text(from.triangle_tests, to.triangle_tests) + ", cost " +
               render::change_text(from.picoseconds, to.picoseconds);
    };
    const std::string with_best =
                          changes(work.before, work.after) + " with " + recommended_text(tuning),
                      with_base = changes(work.base_before, work.base_after) + " with " +
                                  (report.settings->recorded
                                       ? std::string(volume_kind_name(tuning.base().setting.volume))
                                       : "the present setting");
    const bool helps_best = work.after.picoseconds < work.before.picoseconds,
               has_best = tuning.cheapest_layout() || tuning.recommended() != 0;
    if (has_best && !helps_best)
        return "Only if you keep the present setting, " + change + ": " + with_base + "; " +
               with_best + ".";
    change.front() = static_cast<char>(change.front() - 'a' + 'A');
    return change + ": " + (has_best ? with_best + "; " : "") + with_base + ".";
}

std::string cut_sentence(const InspectReport& report, const CutTrial& cuts) {
    std::string what;
    for (const MeshCut& cut : cuts.meshes)
        what += (what.empty() ? "" : " and ") + counted(cut.triangles, "triangle", "triangles") +
                " of " + printable(bodies_of(report, cut.side)) + " into " +
                counted(cut.pieces, "piece", "pieces");
    return trial_sentence(report, "cut " + what, cuts.work);
}

std::string clean_sentence(const InspectReport& report, const CureTrial& clean) {
    std::string what;
    for (const CuredMesh& mesh : clean.meshes) {
        what += what.empty() ? "" : " and ";
        if (mesh.copies > 0) what += counted(mesh.copies, "copy", "copies") + " of other triangles";
        if (mesh.degenerate > 0)
            what += (mesh.copies > 0 ? " and " : "") +
                    counted(mesh.degenerate, "triangle without area", "triangles without area");
        what += " of " + printable(bodies_of(report, mesh.side));
    }
    return trial_sentence(report, "leave out " + what, clean.work) +
           " Their pairs are then not reported.";
}

/// `scb export` of the mesh of a body.
std::string export_command(const InspectReport& report, std::size_t side,
                           const std::string& options, const std::string& ending) {
    const std::string name = body_name(report, side);
    return "scb export" + report.settings->scene + " --body " + file_word(name) + options + " -o " +
           file_word(scenes::file_name_of(name) + ending + ".ply");
}

/// The commands that write the cut meshes, one each.
std::vector<std::string> cut_commands(const InspectReport& report) {
    std::vector<std::string> commands;
    if (!report.settings->cuts) return commands;
    for (const MeshCut& cut : report.settings->cuts->meshes) {
        std::string numbers;
        for (const std::uint32_t triangle : cut.seeds)
            numbers += (numbers.empty() ? " --triangles " : ",") + std::to_string(triangle);
        commands.push_back(export_command(report, cut.side,
                                          " --cut " + exact_number(cut.longest) + numbers, "-cut"));
    }
    return commands;
}

/// The commands that write the cleaned meshes, one each.
std::vector<std::string> clean_commands(const InspectReport& report) {
    std::vector<std::string> commands;
    if (!report.settings->clean) return commands;
    for (const CuredMesh& mesh : report.settings->clean->meshes)
        commands.push_back(export_command(report, mesh.side, " --clean", "-clean"));
    return commands;
}

Json json_of(const TrialWork& trial) {
    const auto work = [](const Work& of) {
        return Json{{"n_v", of.volume_tests},
                    {"n_p", of.triangle_tests},
                    {"cost", static_cast<double>(of.picoseconds) / 1000}};
    };
    return {{"before", work(trial.before)},
            {"after", work(trial.after)},
            {"base", {{"before", work(trial.base_before)}, {"after", work(trial.base_after)}}}};
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

std::vector<std::string> mesh_sentences(const InspectReport& report) {
    if (!has_advice(report)) return {};
    std::vector<std::string> sentences;
    if (report.settings->cuts) sentences.push_back(cut_sentence(report, *report.settings->cuts));
    if (report.settings->clean)
        sentences.push_back(clean_sentence(report, *report.settings->clean));
    return sentences;
}

std::vector<std::string> mesh_commands(const InspectReport& report) {
    if (!has_advice(report)) return {};
    std::vector<std::string> commands = cut_commands(report);
    for (std::string& command : clean_commands(report)) commands.push_back(std::move(command));
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
    json["setting"] = recommended_text(report.settings->tuning);
    json.update(json_of(cuts.work));
    return json;
}

Json clean_json(const InspectReport& report) {
    const CureTrial& clean = *report.settings->clean;
    const std::vector<std::string> commands = clean_commands(report);
    Json json = {{"meshes", Json::array()}};
    for (std::size_t i = 0; i < clean.meshes.size(); ++i)
        json["meshes"].push_back({{"body", body_name(report, clean.meshes[i].side)},
                                  {"copies", clean.meshes[i].copies},
                                  {"degenerate", clean.meshes[i].degenerate},
                                  {"command", commands[i]}});
    json["setting"] = recommended_text(report.settings->tuning);
    json.update(json_of(clean.work));
    return json;
}

}  // namespace scb::app
