#include "app/query/patch_report.h"

#include "app/query/query_title.h"
#include "core/base/text_format.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

Json xyz(const Vec3& p) { return {p[0], p[1], p[2]}; }

std::string triple(const Vec3& p) { return format("%.4g %.4g %.4g", p[0], p[1], p[2]); }

std::vector<Column> patch_columns(const SceneQuery& query) {
    std::vector<Column> columns = {{"frame", "frame", 5},
                                   {"patch", "patch", 7},
                                   {"pairs", "pairs", 9},
                                   {"size of its box", "", 30},
                                   {"center", "", 30}};
    for (const char* corner : {"lower_x", "lower_y", "lower_z", "upper_x", "upper_y", "upper_z"})
        columns.push_back({"", corner});
    if (!query.is_self())
        for (const std::string side : {"a", "b"}) {
            const std::string letter = side == "a" ? "A" : "B";
            columns.push_back({"deepest " + letter, "signed_distance_" + side, 14});
            columns.push_back({"vertex " + letter, "vertex_" + side, 10});
        }
    if (is_of_many(query)) {
        columns.push_back({"", "body_a"});
        columns.push_back({"", "body_b"});
        columns.push_back({"bodies", "", 0, Align::left, 2});
    }
    return columns;
}

Json vertex_json(const DeepVertex& v) {
    return {{"vertex", v.vertex},
            {"at", xyz(v.at)},
            {"signed_distance", -v.depth},
            {"triangle", v.nearest}};
}

}  // namespace

PatchReport::PatchReport(const SceneQuery& query)
    : query_(query), all_(patch_columns(query)), largest_(patch_columns(query)) {}

const JoinedMesh& PatchReport::joined(std::size_t body) {
    const std::size_t mesh = query_.scene.bodies[body].mesh;
    return joined_.try_emplace(mesh, query_.scene.meshes[mesh].mesh).first->second;
}

const std::string& PatchReport::name(std::size_t side) const {
    return body_name(query_, side == 0 ? query_.a : query_.b);
}

std::string PatchReport::doubt(std::size_t side, const Collision& found) {
    if (query_.is_self()) return "Depths are of two bodies, and are not judged for one.";
    if (!found.complete)
        return "Depths are not judged where --max-pairs ended a query: its patches are not whole.";
    if (query_.kind == VolumeKind::scb && query_.options.overlap.test == OverlapTest::printed &&
        !query_.is_packed())
        return "Depths are not judged: the test printed may miss pairs, and patches may lack them.";
    if (!joined(side == 0 ? query_.b : query_.a).is_closed)
        return "How deep " + name(side) + " is inside " + name(1 - side) +
               " is not judged: " + name(1 - side) + " is not closed.";
    return "";
}

PatchReport::Deepest PatchReport::deepest(std::size_t side, const Pose& b_to_a,
                                          const Collision& found) {
    if (const std::string why = doubt(side, found); !why.empty()) {
        doubts_.insert(why);
        return std::nullopt;
    }
    const auto body = [&](std::size_t of_side) {
        const std::size_t index = of_side == 0 ? query_.a : query_.b;
        return PatchBody{query_.mesh(index), joined(index), query_.hierarchy(index),
                         of_side == 0 ? Pose{} : b_to_a};
    };
    return deepest_vertices(body(side), body(1 - side), side, found.pairs, patches_);
}

void PatchReport::add(int frame, const Collision& found) {
    const Pose b_to_a = query_.b_to_a(frame);
    pair_count_ = found.pairs.size();
    patches_ = contact_patches({query_.mesh(query_.a), joined(query_.a).triangles},
                               {query_.mesh(query_.b), joined(query_.b).triangles}, b_to_a,
                               found.pairs, query_.is_self());
    deepest_here_.reset();
    of_sides_ = {};
    if (patches_.empty()) return;
    for (std::size_t side = 0; side < 2; ++side) {
        of_sides_[side] = deepest(side, b_to_a, found);
        if (!of_sides_[side]) continue;
        for (std::size_t i = 0; i < patches_.size(); ++i) {
            const std::optional<DeepVertex>& vertex = (*of_sides_[side])[i];
            if (vertex && (!deepest_here_ || vertex->depth > deepest_here_->vertex.depth))
                deepest_here_ = Place{frame, i + 1, name(side), name(1 - side), *vertex};
        }
    }
    if (deepest_here_ && (!deepest_ || deepest_here_->vertex.depth > deepest_->vertex.depth))
        deepest_ = deepest_here_;
    for (std::size_t i = 0; i < patches_.size(); ++i) add_row(frame, i);
}

void PatchReport::add_row(int frame, std::size_t patch) {
    const Box& box = patches_[patch].box;
    std::vector<Cell> cells = {frame, patch + 1, patches_[patch].pairs.size(),
                               triple(box.upper - box.lower),
                               triple(0.5 * box.lower + 0.5 * box.upper)};
    for (const Vec3& corner : {box.lower, box.upper})
        for (int i = 0; i < 3; ++i) cells.emplace_back(corner[i], "%.6g");
    if (!query_.is_self())
        for (const Deepest& of_side : of_sides_) {
            const bool is_there = of_side && (*of_side)[patch];
            const std::string none = of_side ? "-" : "?";
            cells.push_back(is_there ? Cell(-(*of_side)[patch]->depth, "%.6g") : Cell({}, none));
            cells.push_back(is_there ? Cell((*of_side)[patch]->vertex) : Cell({}, none));
        }
    if (is_of_many(query_)) {
        cells.emplace_back(name(0));
        cells.emplace_back(name(1));
        cells.emplace_back(pair_words(query_));
    }
    if (patch < most_rows) {
        const std::size_t left = patches_.size() - most_rows;
        const bool is_cut = patch + 1 == most_rows && patches_.size() > most_rows;
        largest_.add(cells, is_cut ? format("  and %zu smaller ones", left) : "");
    }
    all_.add(std::move(cells));
}

Json PatchReport::json() const {
    Json list = Json::array();
    for (std::size_t i = 0; i < patches_.size(); ++i) {
        const Box& box = patches_[i].box;
        Json patch = {{"patch", i + 1},
                      {"pairs", patches_[i].pairs.size()},
                      {"box", {{"lower", xyz(box.lower)}, {"upper", xyz(box.upper)}}}};
        for (std::size_t side = 0; side < 2 && !query_.is_self(); ++side) {
            const Deepest& of_side = of_sides_[side];
            Json deepest = {{"judged", of_side.has_value()}, {"vertex", nullptr}};
            if (of_side && (*of_side)[i]) deepest.update(vertex_json(*(*of_side)[i]));
            patch[side == 0 ? "deepest_a" : "deepest_b"] = std::move(deepest);
        }
        list.push_back(std::move(patch));
    }
    Json json = {{"patches", std::move(list)}};
    if (query_.is_self()) return json;
    json["deepest_vertex"] = nullptr;
    if (!deepest_here_) return json;
    json["deepest_vertex"] = {
        {"body", deepest_here_->body}, {"in", deepest_here_->in}, {"patch", deepest_here_->patch}};
    json["deepest_vertex"].update(vertex_json(deepest_here_->vertex));
    return json;
}

std::vector<std::uint32_t> PatchReport::patch_of_pairs() const {
    std::vector<std::uint32_t> numbers(pair_count_);
    for (std::size_t i = 0; i < patches_.size(); ++i)
        for (const std::uint32_t pair : patches_[i].pairs)
            numbers[pair] = static_cast<std::uint32_t>(i + 1);
    return numbers;
}

std::string PatchReport::deepest_words() const {
    if (!deepest_) return "";
    const DeepVertex& v = deepest_->vertex;
    return "\nDeepest vertex: " + std::to_string(v.vertex) + " of " + deepest_->body +
           format(", %.6g inside ", v.depth) + deepest_->in +
           format(
               ", in patch %zu of frame %d. A shift that parts the bodies is at least this "
               "long, and may be longer.\n",
               deepest_->patch, deepest_->frame);
}

std::string PatchReport::text() const {
    if (largest_.size() == 0) return "";
    std::string text = "\nContact patches, connected sets of pairs; places in the frame of " +
                       std::string(is_of_many(query_) ? "the first body" : name(0)) + ":\n" +
                       largest_.text() + deepest_words();
    if (!doubts_.empty()) text += "\n";
    for (const std::string& doubt : doubts_) text += doubt + "\n";
    return text;
}

std::string PatchReport::csv() const { return all_.csv_header() + all_.csv_rows(); }

}  // namespace scb::app
