#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/query/output_guard.h"
#include "app/query/query_options.h"
#include "app/report/table.h"
#include "app/report/trace_report.h"
#include "app/study/point_queries.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "core/geometry/mesh_facts.h"
#include "core/platform/number_rows.h"
#include "scb/error.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

struct InsideOptions {
    SceneOptions scene;
    std::string points;
    bool json = false, csv = false;
};

std::vector<Vec3> read_points(const std::string& path) {
    NumberRows rows(path);
    std::vector<Vec3> points;
    while (const std::optional<NumberRows::Cells> cells = rows.next()) {
        if (points.empty() && !rows.header().empty() && rows.header().size() != 3)
            rows.refuse("the header before has " +
                        counted(rows.header().size(), "column", "columns") +
                        "; give x, y and z of one point in each row.");
        if (cells->size() != 3)
            rows.refuse("it has " + counted(cells->size(), "column", "columns") +
                        "; give x, y and z of one point.");
        const std::vector<double> p = rows.numbers(*cells, max_coordinate);
        points.emplace_back(p[0], p[1], p[2]);
    }
    if (points.empty()) throw InputError(path + ": it has no points; give rows of x, y and z.");
    return points;
}

std::string_view side_name(PointSide side) {
    switch (side) {
        case PointSide::out:
            return "out";
        case PointSide::in:
            return "in";
        case PointSide::on:
            break;
    }
    return "on";
}

Json json_of(std::size_t number, const Vec3& point, const PointAnswer& answer) {
    const auto xyz = [](const Vec3& p) { return Json{p[0], p[1], p[2]}; };
    const std::optional<double> depth = answer.signed_distance();
    return {{"number", number},
            {"point", xyz(point)},
            {"answer", answer.side ? Json(side_name(*answer.side)) : Json()},
            {"distance", answer.nearest.found.distance},
            {"signed_distance", depth ? Json(*depth) : Json()},
            {"triangle", answer.nearest.triangles->a},
            {"closest", xyz(answer.nearest.found.point_a)}};
}

Table table_of_answers() {
    return Table({{"point", "number", 7},
                  {"x", "x", 13},
                  {"y", "y", 13},
                  {"z", "z", 13},
                  {"answer", "answer", 11},
                  {"distance", "distance", 13},
                  {"", "signed_distance"},
                  {"triangle", "triangle", 10},
                  {"", "closest_x"},
                  {"", "closest_y"},
                  {"", "closest_z"}});
}

std::vector<Cell> cells_of(std::size_t number, const Vec3& point, const PointAnswer& answer) {
    std::vector<Cell> cells = {number};
    const auto add = [&cells](const Vec3& p) {
        for (int i = 0; i < 3; ++i) cells.emplace_back(p[i], "%.6g");
    };
    add(point);
    cells.push_back(answer.side ? Cell(side_name(*answer.side))
                                : Cell(Json(), std::string("not judged")));
    cells.emplace_back(answer.nearest.found.distance, "%.6g");
    const std::optional<double> depth = answer.signed_distance();
    cells.push_back(depth ? Cell(*depth, "%.6g") : Cell());
    cells.emplace_back(answer.nearest.triangles->a);
    add(answer.nearest.found.point_a);
    return cells;
}

int run(const InsideOptions& options, const Console& console) {
    check_one_format(options.json, options.csv);
    const scenes::Scene scene = options.scene.load();
    if (scene.bodies.size() != 1)
        throw InputError(options.scene.names[0] + ": the scene has " +
                         counted(scene.bodies.size(), "body", "bodies") +
                         ", and points are inside of one; give a mesh file.");
    const Mesh& mesh = scene.meshes[scene.bodies[0].mesh].mesh;
    if (mesh.triangles.empty())
        throw InputError(options.scene.names[0] + ": it has no triangles; give a mesh.");
    const std::vector<Vec3> points = read_points(options.points);
    HierarchyOptions hierarchy;
    hierarchy.split = SplitMethod::cost;
    PointQueries queries(mesh, hierarchy.build());
    Table table = table_of_answers();
    Json answers = Json::array();
    std::array<std::size_t, 3> counts{};
    const InterruptWatch watch;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (watch.signal() != 0) {
            console.note("scb: interrupted; no answer is printed.");
            return exit_interrupted(watch.signal());
        }
        const PointAnswer answer = queries.at(points[i]);
        if (answer.side) ++counts[static_cast<std::size_t>(*answer.side)];
        if (options.json)
            answers.push_back(json_of(i, points[i], answer));
        else
            table.add(cells_of(i, points[i], answer));
    }
    if (options.json) {
        Json json = {{"version", SCB_VERSION},
                     {"source", utf8_names(options.scene.names)},
                     {"body", body_json({scene.bodies[0].name, fingerprint(mesh)})},
                     {"closed", queries.is_closed()}};
        if (queries.is_closed())
            for (const PointSide side : {PointSide::in, PointSide::on, PointSide::out})
                json[std::string(side_name(side))] = counts[static_cast<std::size_t>(side)];
        json["points"] = std::move(answers);
        print_result(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
        return exit_done;
    }
    if (options.csv) {
        print_result(table.csv_header() + table.csv_rows());
        return exit_done;
    }
    const std::string title = scene.bodies[0].name + ": " +
                              counted(mesh.triangles.size(), "triangle", "triangles") +
                              (queries.is_closed() ? ", closed" : ", not closed") + "\n\n";
    const auto of = [&counts](PointSide side) {
        return count_text(counts[static_cast<std::size_t>(side)]) + " " +
               std::string(side_name(side));
    };
    const std::string all = counted(points.size(), "point", "points") + ": ";
    print_result(title + table.text() + "\n" + all +
                 (queries.is_closed()
                      ? of(PointSide::in) + ", " + of(PointSide::out) + ", " + of(PointSide::on) +
                            " the surface.\n"
                      : "inside or outside is not judged, since the mesh is not closed.\n"));
    return exit_done;
}

}  // namespace

void add_inside(const Command& program, const Console& console, Action& action) {
    const Command command = program.add_subcommand(
        "inside", "Say which points lie inside a closed mesh, and how far from its surface");
    const auto options = std::make_shared<InsideOptions>();
    command.add_option("MESH", options->scene.names, "A mesh file, or a scene file with one body")
        .required()
        .expected(1)
        .file(scene_endings())
        .type_name("[MESH]");
    command
        .add_option("--points", options->points,
                    "A file with a point in each row: x, y and z, in the frame of the mesh")
        .required()
        .file({".csv", ".txt"})
        .type_name("FILE");
    command
        .add_option("--models", options->scene.models_dir,
                    "Folder to search for meshes that are missing at their given path")
        .envname("SCB_MODELS")
        .folder()
        .shareable();
    command.add_flag("--csv", options->csv, "Print CSV instead of a table");
    command.add_flag("--json", options->json, "Print JSON instead of a table");
    command.footer(
        "answer: in, out, or on, if the point is exactly on a triangle. A point is inside if a ray "
        "from it crosses the surface an\n"
        "odd number of times; this is decided exactly. So a point in two overlapping shells is "
        "outside. A mesh is closed if each\n"
        "edge has an even number of triangles; for other meshes the answer is not judged. "
        "distance: to the nearest triangle.\n\n"
        "Examples:\n"
        "  scb inside part.ply --points probes.csv\n"
        "  scb inside part.ply --points probes.csv --json");
    command.callback([&action, &console, options] {
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
