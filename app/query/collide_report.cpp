#include "app/query/collide_report.h"

#include <algorithm>
#include <limits>
#include <set>

#include "app/query/pair_lines.h"
#include "app/query/query_title.h"
#include "app/report/build_text.h"
#include "app/report/count_table.h"
#include "app/report/scene_report.h"
#include "core/base/text_format.h"
#include "core/geometry/mesh_facts.h"
#include "scb/triangle_overlap.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

std::vector<Cell> mean_cells(const SceneQuery& query, const CollideSums& sums,
                             const std::vector<Stage>& stages) {
    const auto mean = [&](std::uint64_t sum) { return Cell(sums.mean(sum), "%.1f"); };
    std::vector<Cell> cells = {
        "mean", mean(sums.pairs), mean(sums.n_v), mean(sums.n_p), mean(sums.n_u), {}, {}};
    if (query.is_packed()) cells[4] = Cell(Json(), std::string("-"));
    for (const Stage stage : stages)
        cells.push_back(mean(sums.stages[static_cast<std::size_t>(stage)]));
    return cells;
}

/// `left_out`: see TraceEngine.
Json json_of(const CollideCommandOptions& options, const SceneQuery& query, const CollideSums& sums,
             Json frames, std::uint64_t left_out) {
    Json result = bodies_json(options.scene, query);
    if (query.is_self()) result["query"] = "self";
    if (query.is_packed()) {
        result["layout"] = options.layout.layout;
        result["leaf"] = options.layout.leaf_triangles;
    } else {
        if (query.kind == VolumeKind::scb) {
            result["test"] = options.query.test;
            if (has_threshold(query.options.overlap.test))
                result["threshold"] = options.query.threshold;
        }
        result["descent"] = descent_rule_name(options.query.descent);
    }
    result.update(build_json(query.build));
    result["max_pairs"] = query.options.max_pairs;
    if (!options.contacts.empty()) result["contacts"] = options.contacts;
    const int level = query.options.stop_level;
    result["level"] = level >= 0 ? Json(level) : Json();
    result["poses"] = poses_json(query.scene, query.frames);
    if (left_out > 0) result["left_out"] = left_out;
    result["frames"] = std::move(frames);
    result["mean"] = {{"pairs", sums.mean(sums.pairs)},
                      {"n_v", sums.mean(sums.n_v)},
                      {"n_p", sums.mean(sums.n_p)}};
    if (!query.is_packed()) result["mean"]["n_u"] = sums.mean(sums.n_u);
    return result;
}

std::string title_of(const CollideCommandOptions& options, const SceneQuery& query) {
    std::string text = bodies_title(query);
    if (query.is_packed())
        return text + ", layout " + options.layout.layout + ", at most " +
               counted(static_cast<std::uint64_t>(options.layout.leaf_triangles), "triangle",
                       "triangles") +
               " in a leaf" + build_text(query.build) + "\n\n";
    if (query.kind == VolumeKind::scb) {
        text += ", test " + options.query.test;
        if (has_threshold(query.options.overlap.test) &&
            query.options.overlap.threshold != OverlapOptions{}.threshold)
            text += format(", threshold %g", query.options.overlap.threshold);
    }
    text += ", descent by " + std::string(descent_rule_name(options.query.descent));
    text += build_text(query.build);
    if (query.options.stop_level >= 0)
        text += format("; pairs of nodes of level %d", query.options.stop_level);
    return text + "\n\n";
}

/// For queries that find nothing: which body lies inside the other, or how far apart the boxes of
/// the bodies are, in A's frame.
std::string nothing_text(const SceneQuery& query, const InsideReport& inside) {
    if (query.is_self()) return "\nNo triangles intersect but those that share a vertex.\n";
    if (const std::string claims = inside.claims(query.frames.size()); !claims.empty())
        return "\nNo triangles intersect: " + claims + ".\n" + inside.doubts();
    const Box a = bounding_box(query.mesh(query.a));
    std::size_t overlapping = 0;
    double least = std::numeric_limits<double>::infinity();
    int nearest = 0;
    Vec3 gap = Vec3::Zero();
    for (const int frame : query.frames) {
        const Vec3 here = gap_between(a, bounding_box(query.mesh(query.b), query.b_to_a(frame)));
        overlapping += here.isZero(0);
        if (here.norm() >= least) continue;
        least = here.norm();
        nearest = frame;
        gap = here;
    }
    const std::string names = pair_words(query);
    const std::size_t frames = query.frames.size();
    if (overlapping > 0)
        return "\nNo triangles intersect, though the boxes of " + names + " overlap" +
               (frames == 1 ? ".\n" : format(" in %zu of %zu frames.\n", overlapping, frames)) +
               inside.doubts();
    return "\nNo triangles intersect: the boxes of " + names + format(" are %.6g apart", least) +
           (frames == 1 ? "" : format(" in frame %d, where they are nearest", nearest)) +
           format(" (x %.6g, y %.6g, z %.6g in the frame of ", gap[0], gap[1], gap[2]) +
           body_name(query, query.a) + ").\n";
}

}  // namespace

/// Counts of a recorded query, compared with the exact pairs.
struct CollideReport::RecordedCounts {
    std::uint64_t pairs = 0, wrong = 0, grazing = 0;
    std::optional<std::uint64_t> missed;  ///< none if the engine ended early or recorded no results

    RecordedCounts(const scenes::RecordedResults& results, bool knows_missed)
        : pairs(results.reported), wrong(results.wrong), grazing(results.grazing) {
        if (knows_missed) missed = results.missed;
    }
};

CollideReport::CollideReport(const CollideCommandOptions& options, SceneQuery& query,
                             scenes::RecordedTrace* recorded)
    : options_(options),
      query_(query),
      recorded_(recorded),
      stages_(query.is_packed() ? std::vector<Stage>{}
                                : counted_stages(query.kind, query.options.overlap)),
      met_(query.pairs.size()),
      intervals_(query.pairs.size()) {
    pairs_ = pair_lines_header(query, options.patches);
    if (options.patches) patches_.emplace(query);
    for (const BodyPair& pair : query.pairs) {
        query.choose(pair);
        inside_.emplace_back(query);
    }
    if (!options.expect.empty()) comparison_.emplace(options.expect, query);
    if (!options.json && !options.csv && stages_.size() > most_stage_columns) stages_.clear();
    std::vector<Column> columns = count_columns(stages_);
    if (options.contacts == "all") columns.push_back({"touching", "touching", 9});
    if (recorded)
        for (const char* name : {"recorded", "missed", "false"}) columns.push_back({name, name, 9});
    if (comparison_)
        for (const char* name : {"expected", "missing", "false"})
            columns.push_back({name, name, 9});
    if (is_of_many(query)) {
        columns.push_back({"", "body_a"});
        columns.push_back({"", "body_b"});
        columns.push_back({"bodies", "", 0, Align::left, 2});
    }
    table_ = Table(std::move(columns));
}

void CollideReport::add(int frame) {
    if (is_of_many(query_)) json_frames_.push_back({{"frame", frame}});
    for (std::size_t i = 0; i < query_.pairs.size(); ++i) {
        query_.choose(query_.pairs[i]);
        add(i, frame, query_.collide(frame));
    }
    ++sums_.frames;
}

std::string CollideReport::text() {
    if (options_.json) {
        Json json = json_of(options_, query_, sums_, std::move(json_frames_),
                            recorded_ == nullptr ? 0 : recorded_->header().engine->left_out);
        json["inside"] = std::move(json_inside_);
        if (query_.options.stop_level < 0) json["contact_intervals"] = contact_json();
        std::set<std::string> not_closed;
        for (const InsideReport& inside : inside_)
            for (std::string& name : inside.not_closed()) not_closed.insert(std::move(name));
        if (!not_closed.empty()) json["not_closed"] = not_closed;
        return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    }
    if (options_.csv) return patches_ ? patches_->csv() : table_.csv_header() + table_.csv_rows();
    if (sums_.frames > 1) {
        std::vector<Cell> means = mean_cells(query_, sums_, stages_);
        if (is_all_contacts()) means.emplace_back(sums_.mean(all_touching_), "%.1f");
        table_.add(std::move(means));
    }
    return title_of(options_, query_) + table_.text() + recorded_words() +
           (leaves_out_contacts() ? left_out_words() : "") +
           (is_of_many(query_) ? many_words() : apart_words()) + contact_words() +
           (patches_ ? patches_->text() : "") +
           (comparison_ ? comparison_->text(sums_.frames) : "");
}

std::size_t CollideReport::choose_contacts(Collision& found, int frame) {
    std::size_t touching = 0;
    const Mesh &a = query_.mesh(query_.a), &b = query_.mesh(query_.b);
    const Pose b_to_a = query_.b_to_a(frame);
    const auto first_to_leave_out =
        std::stable_partition(found.pairs.begin(), found.pairs.end(), [&](IndexPair pair) {
            const bool touches = triangle_contact(corners(a, pair.a),
                                                  transform_corners(b_to_a, corners(b, pair.b))) ==
                                 TriangleContact::touching;
            touching += touches;
            return is_all_contacts() || touches == (options_.contacts == "touching");
        });
    left_out_ += static_cast<std::size_t>(found.pairs.end() - first_to_leave_out);
    found.pairs.erase(first_to_leave_out, found.pairs.end());
    all_touching_ += touching;
    return touching;
}

void CollideReport::add(std::size_t i, int frame, Collision found) {
    met_[i] = met_[i] || !found.pairs.empty();
    if (found.pairs.empty() && query_.options.stop_level < 0 && !query_.is_self())
        for (Json& found_inside : inside_[i].add(frame))
            json_inside_.push_back(std::move(found_inside));
    const std::size_t touching = options_.contacts.empty() ? 0 : choose_contacts(found, frame);
    if (patches_) patches_->add(frame, found);
    sums_.add(found);
    intervals_[i].add(frame, !found.pairs.empty());
    std::optional<RecordedCounts> there;
    if (recorded_ != nullptr) {
        const bool complete = recorded_->frame(frame).found.complete;
        there.emplace(recorded_->results(), complete && recorded_->has_results());
        grazing_ += there->grazing;
    }
    ExpectedDifference difference;
    if (comparison_) difference = comparison_->add(i, frame, found.pairs);
    if (options_.json)
        add_json(frame, found, touching, there, difference);
    else
        add_row(frame, found, touching, there, difference);
    if (!options_.pairs_out.empty())
        pairs_ += pair_lines(query_, frame, found.pairs,
                             patches_ ? patches_->patch_of_pairs() : std::vector<std::uint32_t>{});
}

void CollideReport::add_json(int frame, const Collision& found, std::size_t touching,
                             const std::optional<RecordedCounts>& there,
                             const ExpectedDifference& difference) {
    Json counts = query_.is_packed() ? packed_count_json(frame, query_.b_to_a(frame), found)
                                     : count_json(frame, query_.b_to_a(frame), found, stages_);
    if (is_all_contacts()) counts["touching"] = touching;
    if (difference) counts["expected"] = json_of(*difference);
    if (patches_) counts.update(patches_->json());
    if (is_of_many(query_)) {
        Json query = {{"bodies", pair_json(query_)}};
        counts.erase("frame");
        query.update(counts);
        json_frames_.back()["queries"].push_back(std::move(query));
        return;
    }
    json_frames_.push_back(std::move(counts));
    if (there)
        json_frames_.back()["recorded"] = {
            {"pairs", there->pairs},
            {"missed", there->missed ? Json(*there->missed) : Json()},
            {"false", there->wrong},
            {"within_rounding", there->grazing}};
}

void CollideReport::add_row(int frame, const Collision& found, std::size_t touching,
                            const std::optional<RecordedCounts>& there,
                            const ExpectedDifference& difference) {
    std::vector<Cell> cells =
        query_.is_packed() ? packed_count_cells(frame, found) : count_cells(frame, found, stages_);
    if (is_all_contacts()) cells.emplace_back(touching);
    if (there) {
        cells.emplace_back(there->pairs);
        cells.push_back(there->missed ? Cell(*there->missed) : Cell("-"));
        cells.emplace_back(there->wrong);
    }
    if (difference) {
        cells.emplace_back(difference->expected);
        cells.emplace_back(difference->missing.size());
        cells.emplace_back(difference->not_found.size());
    }
    if (is_of_many(query_)) {
        cells.emplace_back(body_name(query_, query_.a));
        cells.emplace_back(body_name(query_, query_.b));
        cells.emplace_back(pair_words(query_));
    }
    table_.add(std::move(cells), count_note(found));
}

std::string CollideReport::left_out_words() const {
    const std::string others = counted(left_out_, "pair", "pairs");
    return options_.contacts == "crossing"
               ? "\npairs: triangles that cross. " + others + " that only touch: left out.\n"
               : "\npairs: triangles that only touch. " + others + " that cross: left out.\n";
}

std::string CollideReport::recorded_words() const {
    if (recorded_ == nullptr) return "";
    return "\nrecorded: pairs that " + recorded_->header().engine->name +
           " reported; missed and false: against the exact ones. `scb inspect` says why.\n" +
           (grazing_ == 0 ? std::string()
                          : format("%llu of these pairs have a distance or depth within the "
                                   "tolerance of `scb inspect`, and are not judged.\n",
                                   wide(grazing_)));
}

std::string CollideReport::apart_words() const {
    if (sums_.frames != query_.frames.size() || query_.options.stop_level >= 0) return "";
    if (sums_.pairs + left_out_ == 0) return nothing_text(query_, inside_.front());
    const std::string claims = inside_.front().claims(sums_.frames);
    return claims.empty() ? "" : "\nWhere no triangles intersect: " + claims + ".\n";
}

std::string CollideReport::many_words() {
    if (sums_.frames != query_.frames.size() || query_.options.stop_level >= 0) return "";
    std::string apart, inside;
    std::size_t count = 0;
    for (std::size_t i = 0; i < query_.pairs.size(); ++i) {
        query_.choose(query_.pairs[i]);
        if (const std::string claims = inside_[i].claims(sums_.frames); !claims.empty())
            inside += (inside.empty() ? "" : "; ") + claims;
        if (met_[i]) continue;
        if (++count <= most_named_pairs) apart += (count == 1 ? "" : "; ") + pair_words(query_);
    }
    if (count > most_named_pairs) apart += format("; and %zu more", count - most_named_pairs);
    std::string text;
    if (count > 0)
        text += format(count == 1 ? "\n%zu of %zu pairs of bodies has no contact: "
                                  : "\n%zu of %zu pairs of bodies have no contact: ",
                       count, query_.pairs.size()) +
                apart + ".\n";
    if (!inside.empty()) text += "\nWhere no triangles intersect: " + inside + ".\n";
    return text;
}

std::string CollideReport::contact_words() {
    if (sums_.frames < 2 || query_.options.stop_level >= 0) return "";
    std::string text;
    std::size_t count = 0;
    for (std::size_t i = 0; i < query_.pairs.size(); ++i) {
        if (intervals_[i].empty() || ++count > most_named_pairs) continue;
        query_.choose(query_.pairs[i]);
        text += (count == 1 ? "" : "; ") +
                (is_of_many(query_) ? pair_words(query_) + " in " : std::string()) +
                intervals_[i].words();
    }
    if (count == 0) return "";
    if (count > most_named_pairs) text += format("; and %zu more pairs", count - most_named_pairs);
    return "\n" +
           std::string(!leaves_out_contacts()            ? "In contact: "
                       : options_.contacts == "crossing" ? "Crossing: "
                                                         : "Touching: ") +
           text + among_queried(query_.frames);
}

Json CollideReport::contact_json() {
    Json list = Json::array();
    for (std::size_t i = 0; i < query_.pairs.size(); ++i) {
        if (intervals_[i].empty()) continue;
        query_.choose(query_.pairs[i]);
        list.push_back({{"bodies", pair_json(query_)}, {"frames", intervals_[i].json()}});
    }
    return list;
}

}  // namespace scb::app
