#include "app/distance/motion_report.h"

#include <algorithm>
#include <cmath>

#include "app/query/query_title.h"
#include "app/report/build_text.h"
#include "core/base/portable_math.h"
#include "core/base/text_format.h"
#include "core/distance/body_motion.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(ContactOutcome outcome) {
    switch (outcome) {
        case ContactOutcome::none:
            return "none";
        case ContactOutcome::contact:
            return "contact";
        case ContactOutcome::undecided:
            break;
    }
    return "undecided";
}

/// Enough digits to tell the two times of a contact from each other.
int digits_of(double tolerance) {
    return std::clamp(static_cast<int>(std::ceil(-decimal_logarithm(tolerance))) + 3, 3, 12);
}

/// Rounded down, or up.
std::string time_text(double time, int digits, bool up) {
    double unit = 1;
    for (int i = 0; i < digits; ++i) unit *= 10;
    return format("%.*f", digits, (up ? std::ceil(time * unit) : std::floor(time * unit)) / unit);
}

}  // namespace

MotionReport::MotionReport(const MotionOptions& options, SceneQuery& query)
    : options_(options), query_(query) {}

void MotionReport::add(int from, int to, const std::function<bool()>& is_interrupted) {
    const std::array<Pose, 2> start = query_.poses(from), end = query_.poses(to);
    const BodyMotion a(start[0], end[0]), b(start[1], end[1]);
    const Mesh &mesh_a = query_.mesh(query_.a), &mesh_b = query_.mesh(query_.b);
    // Distances and poses are rounded, by some units in the last place of the coordinates. The sum
    // bounds the coordinates at all times.
    constexpr double rounding = 0x1p-44;
    double largest = farthest_vertex(mesh_a) + farthest_vertex(mesh_b);
    for (const auto& poses : {start, end})
        for (const Pose& pose : poses) largest += std::sqrt(squared_norm(pose.translation));
    Approach approach;
    approach.distance = [&](double time) {
        if (is_interrupted()) throw Interrupted();
        DistanceOptions limits = query_.distance->limits;
        limits.seed = closest_;
        const Distance found =
            scb::distance(query_.hierarchy(query_.a), mesh_a, query_.hierarchy(query_.b), mesh_b,
                          relative_pose(a.at(time), b.at(time)), limits);
        closest_ = found.triangles;
        return found.found.distance;
    };
    approach.speed = std::sqrt(squared_norm(Vec3(b.velocity() - a.velocity()))) +
                     a.turning_speed(mesh_a) + b.turning_speed(mesh_b);
    approach.error = rounding * largest + a.last_jump(mesh_a) + b.last_jump(mesh_b);
    const double frames = to - from;
    approach.tolerance = options_.tolerance / frames;
    Step step{from, to, first_contact(approach), false, false};
    step.begins_in_contact = step.has_contact() && step.found.at_latest == 0;
    step.ends_in_contact = step.has_contact() && approach.distance(1) == 0;
    for (double* time : {&step.found.not_before, &step.found.at_latest, &step.found.time_of_least})
        *time = from + frames * *time;
    steps_.push_back(step);
}

Table MotionReport::table() const {
    const int digits = digits_of(options_.tolerance);
    const auto wide = static_cast<std::size_t>(std::max(14, digits + 8));
    Table table({{"from", "from", 6},
                 {"to", "to", 6},
                 {"contact", "contact", 10},
                 {"not before", "not_before", wide},
                 {"at the latest", "at_latest", wide},
                 {"least measured", "least_measured", 15},
                 {"at", "time_of_least", 12},
                 {"distances", "distances", 10}});
    for (const Step& step : steps_) {
        std::vector<Cell> cells = {step.from, step.to, Cell(name_of(step.found.outcome))};
        const bool has_times = step.found.outcome != ContactOutcome::none;
        const auto add = [&](double time, bool up) {
            cells.push_back(has_times ? Cell(Json(time), time_text(time, digits, up))
                                      : Cell(Json(), std::string("-")));
        };
        add(step.found.not_before, false);
        add(step.found.at_latest, true);
        cells.emplace_back(step.found.least_distance, "%.6g");
        cells.emplace_back(step.found.time_of_least, "%.4f");
        cells.emplace_back(step.found.distances);
        table.add(std::move(cells), step.is_jumped() ? "  jumped" : "");
    }
    return table;
}

std::string MotionReport::sentences() const {
    const auto first = std::find_if(steps_.begin(), steps_.end(), [](const Step& step) {
        return step.found.outcome != ContactOutcome::none;
    });
    const bool is_whole = steps_.size() + 1 == query_.frames.size();
    if (first == steps_.end())
        return steps_.empty() ? std::string()
               : is_whole     ? "\nNo contact.\n"
                              : "\nNo contact in the motions that are finished.\n";
    const int digits = digits_of(options_.tolerance);
    const std::string from = time_text(first->found.not_before, digits, false),
                      to = time_text(first->found.at_latest, digits, true);
    std::string text;
    if (!first->has_contact())
        text = "\nThe bodies may touch between the times " + from + " and " + to +
               ": there they are too near for the tolerance and the rounding of numbers.\n";
    else if (first->begins_in_contact)
        text = format("\nThe bodies are in contact at frame %d.\n", first->from);
    else
        text = "\nFirst contact: not before the time " + from + ", and at the latest at " + to +
               ", in frames.\n";
    const auto wide = std::count_if(steps_.begin(), steps_.end(), [this](const Step& step) {
        return step.has_contact() &&
               step.found.at_latest - step.found.not_before > 1.001 * options_.tolerance;
    });
    if (wide > 0)
        text +=
            format("The rounding of numbers keeps %d of the intervals wider than the tolerance.\n",
                   static_cast<int>(wide));
    std::string jumped;
    for (const Step& step : steps_)
        if (step.is_jumped())
            jumped += (jumped.empty() ? "" : ", ") + format("%d and %d", step.from, step.to);
    if (!jumped.empty())
        text += "Queries at frames miss contacts: the bodies touch between " + jumped +
                ", and are apart at both.\n";
    return text;
}

Json MotionReport::json() const {
    Json json = bodies_json(options_.scene, query_);
    json.update(build_json(query_.build));
    json["tolerance"] = options_.tolerance;
    Json steps = Json::array(), jumped = Json::array();
    for (const Step& step : steps_) {
        const bool has_times = step.found.outcome != ContactOutcome::none;
        steps.push_back({{"from", step.from},
                         {"to", step.to},
                         {"contact", name_of(step.found.outcome)},
                         {"not_before", has_times ? Json(step.found.not_before) : Json()},
                         {"at_latest", has_times ? Json(step.found.at_latest) : Json()},
                         {"least_measured", step.found.least_distance},
                         {"time_of_least", step.found.time_of_least},
                         {"distances", step.found.distances}});
        if (step.is_jumped()) jumped.push_back({step.from, step.to});
    }
    json["steps"] = std::move(steps);
    const auto first = std::find_if(json["steps"].begin(), json["steps"].end(),
                                    [](const Json& step) { return step["contact"] != "none"; });
    json["first_contact"] = first == json["steps"].end()
                                ? Json()
                                : Json{{"contact", (*first)["contact"]},
                                       {"not_before", (*first)["not_before"]},
                                       {"at_latest", (*first)["at_latest"]}};
    json["jumped"] = std::move(jumped);
    return json;
}

std::string MotionReport::text() const {
    if (options_.json) return json().dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    if (options_.csv) return table().csv_header() + table().csv_rows();
    return bodies_title(query_) + build_text(query_.build) +
           format(", contacts to %g frames\n\n", options_.tolerance) + table().text() + sentences();
}

}  // namespace scb::app
