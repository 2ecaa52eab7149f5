#include "app/distance/distance_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "app/query/pair_lines.h"
#include "app/query/query_title.h"
#include "app/report/build_text.h"
#include "app/report/count_table.h"
#include "app/report/scene_report.h"
#include "app/report/trace_report.h"
#include "app/study/proven_distance.h"
#include "core/base/text_format.h"
#include "core/collide/index_pairs.h"
#include "scb/triangle_overlap.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

std::string point_text(const Vec3& p) { return format("(%.6g, %.6g, %.6g)", p[0], p[1], p[2]); }

std::vector<Column> answer_columns(bool with_proof) {
    std::vector<Column> columns = found_columns();
    if (with_proof)
        for (const char* bound : {"lower", "upper", "certified"}) columns.push_back({"", bound});
    return columns;
}

}  // namespace

DistanceReport::DistanceReport(const DistanceCommandOptions& options, SceneQuery& query)
    : options_(options),
      query_(query),
      stages_(query.is_packed() ? std::vector<Stage>{} : counted_distance_stages(query.kind)) {
    for (const BodyPair& pair : query.pairs) {
        query.choose(pair);
        bodies_.push_back({InsideReport(query), {}, {}});
    }
    pairs_ = pair_lines_header(query);
    std::vector<Column> columns = {{"frame", "frame", 5}};
    if (lists_pairs())
        columns.push_back({"pairs", "pairs", 9});
    else
        for (Column& column : answer_columns(options.prove)) columns.push_back(std::move(column));
    for (const auto& [title, key] :
         {std::pair("N_v", "n_v"), std::pair("N_p", "n_p"), std::pair("N_u", "n_u")})
        columns.push_back({title, key, 10});
    for (const Stage stage : stages_)
        columns.push_back({distance_stage_name(stage), distance_stage_name(stage),
                           std::max<std::size_t>(9, distance_stage_name(stage).size() + 1)});
    columns.push_back({"", "inside"});
    if (!lists_pairs() && !options.first) columns.push_back({"", "signed_distance"});
    if (is_of_many(query)) {
        columns.push_back({"", "body_a"});
        columns.push_back({"", "body_b"});
        columns.push_back({"bodies", "", 0, Align::left, 2});
    }
    table_ = Table(std::move(columns));
}

void DistanceReport::add(int frame) {
    if (is_of_many(query_)) json_frames_.push_back({{"frame", frame}});
    for (std::size_t i = 0; i < query_.pairs.size(); ++i) {
        query_.choose(query_.pairs[i]);
        if (lists_pairs())
            add_pairs(bodies_[i], frame);
        else
            add_distance(bodies_[i], frame);
    }
    ++frames_;
}

DistanceOptions DistanceReport::limits(const Bodies& bodies) const {
    DistanceOptions limits = asked().within ? asked().up_to_first() : asked().limits;
    if (options_.seeded) limits.seed = bodies.closest;
    return limits;
}

void DistanceReport::add_distance(Bodies& bodies, int frame) {
    const Distance found = query_.nearest(frame, limits(bodies));
    bodies.closest = found.triangles;
    bodies.line.frames.push_back(frame);
    bodies.line.distances.push_back(found.triangles ? found.found.distance
                                                    : std::numeric_limits<double>::quiet_NaN());
    bodies.near.add(frame, found.triangles && (asked().within || found.found.distance == 0));
    const auto keep_least = [&](std::optional<Least>& least) {
        if (!least || found.found.distance < least->found.found.distance)
            least = {found, frame, {query_.a, query_.b}};
    };
    if (found.triangles) keep_least(least_);
    if (found.triangles && found.found.distance > 0) keep_least(least_apart_);
    found_ += found.triangles.has_value();
    // A query that ends at the first pair says nothing about the others.
    const bool is_apart = !found.triangles || (!options_.first && found.found.distance > 0);
    Json json = found_json(found.triangles, found.found);
    if (options_.json && found.triangles) json["rounding"] = query_.rounding(frame);
    std::vector<Cell> cells = found_cells(found.triangles, found.found);
    if (options_.prove) {
        json["proof"] = prove(frame, found);
        for (const char* bound : {"lower", "upper", "certified"})
            cells.emplace_back(json["proof"][bound], std::string());
    }
    add_row(bodies, frame, found, std::move(cells), std::move(json), is_apart);
}

Json DistanceReport::prove(int frame, const Distance& found) {
    const CertifiedDistance proof =
        certified_distance(query_, query_.b_to_a(frame), *found.triangles, found.found.distance);
    ++(proof.certified ? proven_ : not_proven_);
    return {{"lower", proof.proven.lower},
            {"upper", proof.proven.upper},
            {"certified", proof.certified},
            {"directions", proof.directions}};
}

bool DistanceReport::intersect(std::span<const IndexPair> pairs, int frame) const {
    const Mesh &a = query_.mesh(query_.a), &b = query_.mesh(query_.b);
    const Pose b_to_a = query_.b_to_a(frame);
    return std::any_of(pairs.begin(), pairs.end(), [&](const IndexPair& pair) {
        return triangles_overlap(corners(a, pair.a), transform_corners(b_to_a, corners(b, pair.b)));
    });
}

void DistanceReport::add_pairs(Bodies& bodies, int frame) {
    const Collision found = query_.within(frame, *asked().within);
    bodies.near.add(frame, !found.pairs.empty());
    found_ += found.pairs.size();
    if (!options_.pairs_out.empty()) pairs_ += pair_lines(query_, frame, found.pairs);
    Distance work;
    work.n_v = found.n_v;
    work.n_p = found.n_p;
    work.n_u = found.n_u;
    work.stages = found.stages;
    add_row(bodies, frame, work, {found.pairs.size()},
            {{"pairs", found.pairs.size()}, {"pairs_hash", hash_text(pairs_hash(found.pairs))}},
            !intersect(found.pairs, frame));
}

void DistanceReport::add_row(Bodies& bodies, int frame, const Distance& work,
                             std::vector<Cell> cells, Json json, bool judges_inside) {
    work_.n_v += work.n_v;
    work_.n_p += work.n_p;
    work_.n_u += work.n_u;
    for (std::size_t s = 0; s < stage_count; ++s) work_.stages[s] += work.stages[s];

    Json inside = judges_inside ? bodies.inside.add(frame) : Json::array();
    const bool is_judged = judges_inside && bodies.inside.is_judged();
    const bool breaks_clearance = bodies.near.is_last_in_contact() || !inside.empty();
    if (breaks_clearance && (not_clear_.empty() || not_clear_.back() != frame))
        not_clear_.push_back(frame);
    open_ += judges_inside && !is_judged;
    const std::string note = inside_words(inside);
    for (Json& part : inside) part.erase("frame");
    Json signed_distance;
    if (!lists_pairs() && work.triangles) {
        const double distance = work.found.distance;
        if (!inside.empty())
            signed_distance = -distance;
        else if (is_judged || distance == 0)
            signed_distance = distance;
    }

    cells.insert(cells.begin(), frame);
    Json stages = Json::object();
    for (const std::uint64_t count : {work.n_v, work.n_p}) cells.emplace_back(count);
    cells.push_back(query_.is_packed() ? Cell(Json(), std::string("-")) : Cell(work.n_u));
    for (const Stage stage : stages_) {
        const std::uint64_t count = work.stages[static_cast<std::size_t>(stage)];
        cells.emplace_back(count);
        stages[distance_stage_name(stage)] = count;
    }
    const bool is_known = is_judged || !inside.empty();
    cells.emplace_back(is_known ? Json(note.empty() ? "no" : note) : Json(), std::string());
    if (!lists_pairs() && !options_.first) cells.emplace_back(signed_distance, std::string());
    if (is_of_many(query_)) {
        cells.emplace_back(body_name(query_, query_.a));
        cells.emplace_back(body_name(query_, query_.b));
        cells.emplace_back(pair_words(query_));
    }
    table_.add(std::move(cells), note.empty() ? "" : "  " + note);

    if (!options_.json) return;
    Json query;
    if (is_of_many(query_))
        query["bodies"] = pair_json(query_);
    else
        query["frame"] = frame;
    query["pose"] = pose_json(query_.b_to_a(frame));
    if (options_.first) query["within"] = work.triangles.has_value();
    query.update(json);
    if (!options_.first) {
        if (!lists_pairs()) query["signed_distance"] = signed_distance;
        query["inside"] = is_known ? std::move(inside) : Json();
    }
    query["n_v"] = work.n_v;
    query["n_p"] = work.n_p;
    if (!query_.is_packed()) {
        query["n_u"] = work.n_u;
        query["stages"] = std::move(stages);
    }
    if (is_of_many(query_))
        json_frames_.back()["queries"].push_back(std::move(query));
    else
        json_frames_.push_back(std::move(query));
}

std::vector<Cell> DistanceReport::mean_cells() const {
    const auto mean = [&](std::uint64_t sum) {
        return Cell(static_cast<double>(sum) / static_cast<double>(frames_), "%.1f");
    };
    std::vector<Cell> cells = {"mean"};
    if (lists_pairs())
        cells.push_back(mean(found_));
    else
        cells.resize(1 + answer_columns(options_.prove).size());
    for (const std::uint64_t sum : {work_.n_v, work_.n_p}) cells.push_back(mean(sum));
    cells.push_back(query_.is_packed() ? Cell(Json(), std::string("-")) : mean(work_.n_u));
    for (const Stage stage : stages_)
        cells.push_back(mean(work_.stages[static_cast<std::size_t>(stage)]));
    return cells;
}

std::string DistanceReport::title() const {
    std::string text = bodies_title(query_);
    if (asked().within)
        text += options_.first ? format(", first triangles at most %g apart", *asked().within)
                               : format(", triangles at most %g apart", *asked().within);
    else
        text += ", order " + std::string(distance_order_name(asked().limits.order));
    if (query_.is_packed())
        text += ", layout " + options_.layout.layout;
    else
        text += ", descent by " + std::string(descent_rule_name(options_.query.descent));
    text += build_text(query_.build);
    if (asked().limits.relative_error > 0)
        text += format(", relative error up to %g", asked().limits.relative_error);
    if (std::isfinite(asked().limits.limit)) text += format(", limit %g", asked().limits.limit);
    if (options_.seeded) text += ", each frame begins with the pair before";
    return text + "\n\n";
}

std::string DistanceReport::words_of(const Least& least, const std::string& name) {
    const auto& [found, frame, bodies] = least;
    query_.choose(bodies);
    const std::string a = body_name(query_, query_.a), b = body_name(query_, query_.b);
    std::string text = "\n" + name + format(": %.9g", found.found.distance);
    if (frames_ > 1) text += format(" in frame %d", frame);
    text += ", of triangle " + std::to_string(found.triangles->a) + " of " + a + " and triangle " +
            std::to_string(found.triangles->b) + " of " + b + ".\n";
    text += "Closest points, in the frame of " + a + ": " + point_text(found.found.point_a) +
            " and " + point_text(found.found.point_b) + ".\n";
    return text;
}

std::string DistanceReport::least_words() {
    if (!least_) return "";
    if (asked().within) return words_of(*least_, "The first pair that is near enough");
    const bool meet = least_->found.found.distance == 0;
    return words_of(*least_, "Least distance") +
           (meet && least_apart_ ? words_of(*least_apart_, "Least distance of bodies apart") : "");
}

std::string DistanceReport::proof_words() const {
    if (!options_.prove) return "";
    const std::size_t all = proven_ + not_proven_;
    return "\n" + format("Proven: %zu of %zu ", proven_, all) +
           (all == 1 ? "distance" : "distances") +
           ", by bounds that differ by at most 1e-9 of the distance plus 4 x 2^-52 of the largest "
           "coordinate.\n";
}

std::string DistanceReport::inside_text() {
    std::string claims, doubts;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Bodies& bodies = bodies_[i];
        query_.choose(query_.pairs[i]);  // whose names it has
        if (const std::string claim = bodies.inside.claims(frames_); !claim.empty())
            claims += (claims.empty() ? "" : "; ") + claim;
        else
            doubts += bodies.inside.doubts();
    }
    const std::string start =
        frames_ == 1 && !is_of_many(query_) ? "\n" : "\nWhere no triangles intersect: ";
    return (claims.empty() ? "" : start + claims + ".\n") +
           (doubts.empty() || (options_.first && !options_.expects_clear) ? "" : "\n" + doubts);
}

std::string DistanceReport::near_words() {
    if (frames_ < 2) return "";
    std::string text;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (bodies_[i].near.empty()) continue;
        query_.choose(query_.pairs[i]);
        text += (text.empty() ? "" : "; ") +
                (is_of_many(query_) ? pair_words(query_) + " in " : std::string()) +
                bodies_[i].near.words();
    }
    const std::string name =
        asked().within ? format("At most %g apart", *asked().within) : "In contact";
    return "\n" + name + ": " + (text.empty() ? "in no frame" : text) +
           among_queried({query_.frames.begin(),
                          query_.frames.begin() + static_cast<std::ptrdiff_t>(frames_)});
}

std::optional<bool> DistanceReport::is_clear() const {
    if (!not_clear_.empty()) return false;
    if (open_ > 0 || frames_ < query_.frames.size()) return std::nullopt;
    return true;
}

std::string DistanceReport::clearance_words() const {
    const std::string text = "Clearance " + exact_number(*asked().within) + ": ";
    const std::optional<bool> clear = is_clear();
    if (clear && *clear) return text + "kept.";
    if (!clear)
        return text + "not judged. No triangles are that near, and " +
               (open_ > 0 ? "a body may lie inside another that is not closed."
                          : "frames are missing.");
    if (query_.frames.size() == 1) return text + "not kept.";
    return text + format("not kept in %zu of %zu frames, the first is frame %d.", not_clear_.size(),
                         frames_, not_clear_.front());
}

render::DistancePlot DistanceReport::plot() {
    render::DistancePlot plot;
    plot.title = query_.scene.name + " · distance";
    plot.subtitle = asked().limits.relative_error > 0
                        ? format("relative error up to %g", asked().limits.relative_error)
                        : "";
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        query_.choose(query_.pairs[i]);
        bodies_[i].line.name = pair_words(query_);
        plot.lines.push_back(bodies_[i].line);
        if (!is_of_many(query_))
            for (const Json& interval : bodies_[i].near.json())
                plot.ranges.push_back({interval[0], interval[1], "in contact"});
    }
    return plot;
}

Json DistanceReport::json() {
    Json json = bodies_json(options_.scene, query_);
    json["query"] = asked().within ? "within" : "distance";
    if (asked().within) json["tolerance"] = *asked().within;
    if (options_.expects_clear) {
        const std::optional<bool> clear = is_clear();
        json["clear"] = clear ? Json(*clear) : Json();
        json["not_clear"] = not_clear_;
    }
    if (!asked().within) {
        json.update(limits_json(asked().limits));
        json["seeded"] = options_.seeded;
    }
    if (query_.is_packed()) {
        json["layout"] = options_.layout.layout;
        json["leaf"] = options_.layout.leaf_triangles;
    } else {
        json["descent"] = descent_rule_name(options_.query.descent);
    }
    json.update(build_json(query_.build));
    json["poses"] = poses_json(query_.scene, query_.frames);
    json["frames"] = std::move(json_frames_);
    if (least_) {
        json["least"] = {{"frame", least_->frame}};
        if (is_of_many(query_))
            json["least"]["bodies"] = {body_name(query_, least_->bodies[0]),
                                       body_name(query_, least_->bodies[1])};
        json["least"].update(found_json(least_->found.triangles, least_->found.found));
    }
    Json intervals = Json::array();
    std::set<std::string> not_closed;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        query_.choose(query_.pairs[i]);
        for (std::string& name : bodies_[i].inside.not_closed()) not_closed.insert(std::move(name));
        if (!bodies_[i].near.empty())
            intervals.push_back(
                {{"bodies", pair_json(query_)}, {"frames", bodies_[i].near.json()}});
    }
    json[asked().within ? "within_intervals" : "contact_intervals"] = std::move(intervals);
    if (!not_closed.empty()) json["not_closed"] = not_closed;
    return json;
}

std::string DistanceReport::text() {
    if (options_.json) return json().dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    if (options_.csv) return table_.csv_header() + table_.csv_rows();
    if (frames_ > 1) table_.add(mean_cells());
    return title() + table_.text() + least_words() + proof_words() + inside_text() + near_words() +
           (options_.expects_clear ? "\n" + clearance_words() + "\n" : "");
}

}  // namespace scb::app
