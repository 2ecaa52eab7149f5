#include "scenes/recordings/recorded_queries.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/text_format.h"
#include "core/judge/mapped_volume.h"
#include "core/judge/test_links.h"
#include "scb/error.h"
#include "scenes/recordings/number_bits.h"
#include "scenes/recordings/recorded_volume.h"
#include "scenes/scene/pose_rows.h"

namespace scb::scenes {
namespace {

/// The number of odd records to describe; further ones are only counted.
constexpr std::size_t most_odd = 20;
/// Tolerances as shares of the lengths in question, for 32-bit and 64-bit numbers: some units in
/// the last place of products of a few numbers.
constexpr double single_tolerance = 1e-6, double_tolerance = 1e-12;
/// The share of a body's distance that counts for the tolerance, since placing a body rounds each
/// coordinate only once.
constexpr double placing_share = 0.125;
/// The tree that the record is about.
std::optional<std::uint32_t> tree_recorded_by(const Record& record) {
    if (const auto* tree = std::get_if<RecordedTree>(&record)) return tree->tree;
    if (const auto* node = std::get_if<RecordedNode>(&record)) return node->tree;
    if (const auto* refit = std::get_if<RecordedRefit>(&record)) return refit->tree;
    return std::nullopt;
}

}  // namespace

RecordedQueries::RecordedQueries(const RecordingFile& file)
    : name_(file.path), selection_(file.selection), reader_(file.bytes, file.path) {
    query_.has_item_tests = file.summary.item_tests > 0;
    query_.has_answers = file.summary.has_pairs || file.summary.answers > 0;
    query_.has_pairs = file.summary.has_pairs || file.summary.pairs > 0;
}

RecordedQueries::Ended RecordedQueries::next() {
    if (ended_) return Ended::end;
    if (next_frame_) {
        frame_ = *next_frame_;
        next_frame_.reset();
        log_.clear();
        for (auto& [number, body] : bodies_) body.last = body.pose;
    }
    query_done_ = false;
    while (const Record* record = reader_.next()) {
        std::visit([&](const auto& r) { take(r); }, *record);
        telling_ = tree_recorded_by(*record);
        if (query_done_) return Ended::query;
        if (next_frame_) return Ended::frame;
    }
    ended_ = true;
    // If a program crashed, its last query counts as ended early.
    if (!in_query_ || !is_selected_) return Ended::frame;
    broke_off_ = true;
    take(RecordedQueryEnd{false, 0});
    ended_ = false;
    return Ended::query;
}

void RecordedQueries::take(const RecordedStage& stage) {
    constexpr std::uint8_t last = 127;
    if (stage.stage == 0 || stage.stage > last)
        return note(unusable_, "a stage has the number " + std::to_string(stage.stage) +
                                   ", and stages are 1 to 127");
    if (!stages_.contains(stage.stage)) stage_order_.push_back(stage.stage);
    stages_[stage.stage] = shown(stage.name);
}

void RecordedQueries::take(const RecordedEvent& event) {
    if (!in_query_) {
        note(unusable_, "a test or pair stands outside of queries");
        return;
    }
    if (!is_selected_) return;
    EngineEvent taken;
    taken.a = event.a;
    taken.b = event.b;
    const auto tag = static_cast<RecordTag>(event.tag);
    if (tag == RecordTag::parent) {
        next_parent_ = event.a;
        return;
    }
    if (tag == RecordTag::length) {
        next_length_ = length_of(event);
        return;
    }
    if (tag < RecordTag::items_apart) {
        taken.stage = event.tag;
        taken.parent = std::exchange(next_parent_, no_index);
    } else if (tag == RecordTag::items_apart) {
        taken.kind = EngineEvent::Kind::items_apart;
    } else if (tag == RecordTag::items_meet) {
        taken.kind = EngineEvent::Kind::items_meet;
    } else if (tag == RecordTag::pair) {
        taken.kind = EngineEvent::Kind::pair;
    } else {
        return;  // of a later version
    }
    if (taken.kind != EngineEvent::Kind::pair && next_length_) {
        taken.has_length = true;
        taken.length = *std::exchange(next_length_, std::nullopt);
    }
    query_.events.push_back(taken);
}

void RecordedQueries::take(const RecordedMeasure& measure) {
    if (!in_query_) return note(unusable_, "a measure of distances stands outside of queries");
    if (!is_selected_) return;
    const bool is_within = measure.aim == static_cast<std::uint8_t>(RecordedAim::within);
    if (measure.aim >= recorded_aim_count || !(measure.limit >= 0) ||
        (is_within && std::isinf(measure.limit)) ||
        !(measure.relative_error >= 0 && std::isfinite(measure.relative_error))) {
        query_.is_known = false;
        return note(unusable_,
                    "a distance query has an unknown kind, or a limit or relative error that is "
                    "negative or no number");
    }
    constexpr std::array<QueryKind, recorded_aim_count> kinds = {
        QueryKind::collide, QueryKind::distance, QueryKind::within};
    query_.kind = kinds[measure.aim];
    query_.limit = measure.limit;
    query_.relative_error = measure.relative_error;
}

void RecordedQueries::take(const RecordedAnswer& answer) {
    if (!in_query_) return note(unusable_, "a distance stands outside of queries");
    if (!is_selected_) return;
    if (query_.kind != QueryKind::distance)
        return note(unusable_, "a distance was recorded in a query that looks for none");
    constexpr std::size_t coordinates = 6;
    EngineAnswer& taken = query_.answer.emplace();
    taken.distance = answer.distance;
    taken.items = {answer.item_a, answer.item_b};
    if (answer.points.size() == coordinates)
        taken.points = {Vec3(answer.points[0], answer.points[1], answer.points[2]),
                        Vec3(answer.points[3], answer.points[4], answer.points[5])};
    else if (!answer.points.empty())
        note(unusable_, "the points of a distance are not two");
}

void RecordedQueries::compare_lengths() {
    if (query_.kind == QueryKind::collide) return;
    double most = query_.limit;
    if (query_.kind == QueryKind::distance) most = query_.answer ? query_.answer->distance : -1;
    for (EngineEvent& event : query_.events)
        if (event.kind == EngineEvent::Kind::items_apart && event.has_length &&
            event.length <= most)
            event.kind = EngineEvent::Kind::items_meet;
}

void RecordedQueries::take(const RecordedSetting& setting) {
    settings_.push_back({shown(setting.key), shown(setting.value)});
    if (setting.key == "tests") exact_tests_ = setting.value == "exact";
    if (setting.key != "tolerance") return;
    double told = 0;
    const char* end = setting.value.data() + setting.value.size();
    const auto [stop, error] = std::from_chars(setting.value.data(), end, told);
    if (error == std::errc() && stop == end && told >= 0 && told <= max_coordinate)
        recorded_tolerance_ = told;
    else
        note(unusable_, "the tolerance \"" + settings_.back().value + "\" is no length");
}

void RecordedQueries::take(const RecordedMesh& mesh) {
    if (!meshes_[mesh.mesh].take(mesh, frame_, name_ + ": mesh " + std::to_string(mesh.mesh)))
        return;
    // The shape depends on the number of triangles.
    for (auto& [number, tree] : trees_)
        if (tree.mesh == mesh.mesh) tree.change();
}

void RecordedQueries::take(const RecordedTree& tree) { trees_[tree.tree].begin(tree); }

void RecordedQueries::take(const RecordedNode& node) {
    known(trees_, node.tree, "tree").take(node, frame_, epoch_);
}

void RecordedQueries::take(const RecordedRefit& refit) {
    TreeState& state = known(trees_, refit.tree, "tree");
    const std::uint32_t index = state.tree.index_of(refit.node);
    if (index == no_index)
        return note(contradictions_, "node " + std::to_string(refit.node) + ", which tree " +
                                         std::to_string(refit.tree) +
                                         " does not have, was refitted");
    ++state.volume_version;
    state.set_volume(index, refit.volume, frame_);
}

void RecordedQueries::take(const RecordedObject& object) {
    TreeState& state = known(trees_, object.tree, "tree");
    std::string fault;
    NodeVolume volume = node_volume(object.volume, state.directions, fault);
    const std::string what = "the extent of object " + std::to_string(object.object) + " of tree " +
                             std::to_string(object.tree);
    if (state.mesh != record_none)
        return note(unusable_, what + ", whose items are triangles, was recorded");
    if (!fault.empty()) return note(unusable_, what + " is none: " + fault);
    ++state.volume_version;
    state.tree.set_object_volume(object.object, std::move(volume));
}

void RecordedQueries::take(const RecordedBody& body) {
    known(trees_, body.tree, "tree");
    // A body that is recorded again keeps its pose.
    BodyState& state = bodies_[body.body];
    state.name = shown(body.name);
    state.tree = body.tree;
}

void RecordedQueries::take(const RecordedFrame& frame) {
    ++epoch_;
    if (frame.frame >= static_cast<std::uint32_t>(std::numeric_limits<int>::max()))
        fail("frame " + std::to_string(frame.frame) + " is too high a number");
    const int number = static_cast<int>(frame.frame);
    if (in_query_)
        fail("frame " + std::to_string(number) +
             " begins within a query; call scb_record_query_end where a query ends");
    if (!frame_recorded_) {
        frame_recorded_ = true;
        frame_ = number;
        return;
    }
    if (number <= frame_)
        fail("frame " + std::to_string(number) + " follows frame " + std::to_string(frame_) +
             ": frames ascend");
    next_frame_ = number;
}

void RecordedQueries::take(const RecordedPose& pose) {
    BodyState& body = known(bodies_, pose.body, "body");
    static_cast<BodyPose&>(body) = body_pose(pose_of(pose.rows));
    body.has_single_pose = std::all_of(pose.rows.begin(), pose.rows.end(), is_of_32_bits) &&
                           std::any_of(pose.rows.begin(), pose.rows.end(), is_long);
    body.placed = true;
}

void RecordedQueries::take(const RecordedQuery& query) {
    ++epoch_;
    if (in_query_)
        fail("a query begins within a query; call scb_record_query_end where a query ends");
    in_query_ = true;
    is_selected_ = selection_.has(query);
    query_name_ = query.name;
    bodies_of_query_ = {query.body_a, query.body_b};
    for (const std::uint32_t number : bodies_of_query_) {
        const std::uint32_t of = known(bodies_, number, "body").tree;
        const std::uint32_t mesh = trees_.at(of).mesh;
        if (mesh != record_none && !meshes_.contains(mesh) && without_mesh_.insert(of).second)
            note(unusable_, "tree " + std::to_string(of) + " is of mesh " + std::to_string(mesh) +
                                ", which was not recorded, so results are not judged");
    }
    query_.events.clear();
    query_.kind = QueryKind::collide;
    query_.is_known = true;
    query_.limit = HUGE_VAL;
    query_.relative_error = 0;
    query_.answer.reset();
    next_parent_ = no_index;
    next_length_.reset();
}

void RecordedQueries::check_parents() {
    const auto is_at_or_below = [](const TreeShape& shape, std::uint32_t node,
                                   std::uint32_t above) {
        if (node == no_index || above == no_index || !shape.is_reachable(above)) return false;
        while (node != no_index && node != above) node = shape.parents[node];
        return node == above;
    };
    const bool has_parents =
        std::any_of(query_.events.begin(), query_.events.end(),
                    [](const EngineEvent& event) { return event.parent != no_index; });
    if (!has_parents) return;
    std::vector<IndexPair> tested;
    for (EngineEvent& event : query_.events) {
        if (event.kind != EngineEvent::Kind::volumes) continue;
        const IndexPair nodes = nodes_of(query_, event);
        if (event.parent != no_index) {
            const std::string what = "test " + std::to_string(tested.size()) +
                                     " of a query has the parent " + std::to_string(event.parent);
            if (event.parent >= tested.size()) {
                note(unusable_, what + ", which is no earlier test");
                event.parent = no_index;
            } else if (const IndexPair above = tested[event.parent];
                       nodes == above ||
                       !is_at_or_below(*query_.sides[0].shape, nodes.a, above.a) ||
                       !is_at_or_below(*query_.sides[1].shape, nodes.b, above.b)) {
                note(unusable_, what + ", whose nodes are not above its nodes");
                event.parent = no_index;
            }
        }
        tested.push_back(nodes);
    }
}

void RecordedQueries::take(const RecordedQueryEnd& end) {
    if (!in_query_) fail("a query ends that did not begin");
    in_query_ = false;
    if (!is_selected_) return;
    query_done_ = true;
    query_.frame = frame_;
    query_.self = bodies_of_query_[0] == bodies_of_query_[1];
    query_.complete = end.complete;
    query_.nanoseconds = end.nanoseconds;
    std::array<const BodyState*, 2> bodies{};
    double length = 0, length_of_meshes = 0, placing = 0, distances = 0, askew = 0;
    query_.single = false;
    query_.placed = true;
    query_.away = query_.reach = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        bodies[k] = &bodies_.at(bodies_of_query_[k]);
        query_.sides[k] = side_of_body(bodies_of_query_[k]);
        query_.sides[k].stretch = std::sqrt(bodies[k]->stretch.squaredNorm() / 3);
        query_.placed = query_.placed && bodies[k]->pose_fault.empty();
        const TreeState& tree = trees_.at(bodies[k]->tree);
        query_.single = query_.single || is_single(tree) || bodies[k]->has_single_pose;
        const double stretch = std::sqrt(bodies[k]->stretch.squaredNorm() / 3),
                     of_volumes = stretch * reach_of(tree), of_mesh = stretch * mesh_reach(tree),
                     away = bodies[k]->pose.translation.cwiseAbs().maxCoeff();
        length += of_volumes;
        length_of_meshes += of_mesh;
        placing += placing_share * away;
        distances += std::sqrt(squared_norm(bodies[k]->pose.translation));
        query_.away = std::max(query_.away, away);
        query_.reach = std::max(query_.reach, of_volumes);
        askew = std::max(askew, bodies[k]->defect);
    }
    const double share = query_.single ? single_tolerance : double_tolerance;
    // In a self query, both sides have the same pose.
    query_.b_to_a = query_.self ? Pose{} : relative_pose(bodies[0]->pose, bodies[1]->pose);
    query_.tolerance = tolerance_of(share, length + placing) + askew * (length + distances);
    query_.triangle_tolerance =
        tolerance_of(share, length_of_meshes + placing) + askew * (length_of_meshes + distances);
    query_.tolerance_slope = recorded_tolerance_ ? 0 : share + askew;
    const double of_numbers = share * (length + placing), of_poses = askew * (length + distances);
    query_.tolerance_cause = recorded_tolerance_ && *recorded_tolerance_ >= of_poses
                                 ? ToleranceCause::setting
                             : of_poses > of_numbers ? ToleranceCause::pose
                             : placing > length      ? ToleranceCause::distance
                                                     : ToleranceCause::reach;
    compare_lengths();
    check_parents();
    query_.a_to_world = bodies[0]->pose;
    query_.b_to_a_before.reset();
    if (query_.placed && bodies[0]->last && bodies[1]->last)
        query_.b_to_a_before = relative_pose(*bodies[0]->last, *bodies[1]->last);
}

bool RecordedQueries::is_single(const TreeState& tree) const {
    const auto mesh = meshes_.find(tree.mesh);
    const bool has_mesh = mesh != meshes_.end();
    if (has_mesh && mesh->second.coordinate_bytes == 4) return true;
    // Short numbers do not show the engine's precision.
    return tree.single && tree.has_numbers && (tree.has_long || !has_mesh);
}

double RecordedQueries::mesh_reach(const TreeState& tree) const {
    const auto mesh = meshes_.find(tree.mesh);
    return mesh != meshes_.end() ? mesh->second.reach : 0;
}

double RecordedQueries::reach_of(const TreeState& tree) const {
    return std::max(tree.reach(), mesh_reach(tree));
}

double RecordedQueries::tolerance_of(double share, double length) const {
    // The setting does not cover this program's own rounding.
    return recorded_tolerance_ ? std::max(*recorded_tolerance_, double_tolerance * length)
                               : share * length;
}

NodeTolerance RecordedQueries::node_tolerance_of(const TreeState& tree) const {
    const double share = is_single(tree) ? single_tolerance : double_tolerance;
    return {tolerance_of(share, mesh_reach(tree)), recorded_tolerance_ ? double_tolerance : share};
}

double RecordedQueries::tolerance_of(const TreeState& tree) const {
    return tolerance_of(is_single(tree) ? single_tolerance : double_tolerance, reach_of(tree));
}

EngineSide RecordedQueries::side_of(std::uint32_t tree) {
    TreeState& state = trees_.at(tree);
    const auto mesh = meshes_.find(state.mesh);
    const Mesh* of = mesh == meshes_.end() ? nullptr : mesh->second.mesh.get();
    state.complete(of);
    EngineSide side{&state.tree, &state.shape, of};
    side.rest = mesh == meshes_.end() ? nullptr : mesh->second.rest.get();
    side.objects_by_volume = state.mesh == record_none && state.single_objects;
    side.reach = reach_of(state);
    side.mesh_reach = mesh_reach(state);
    side.version = state.volume_version;
    return side;
}

const StretchedBody& RecordedQueries::stretched(std::uint32_t number) {
    const BodyState& body = bodies_.at(number);
    const TreeState& tree = trees_.at(body.tree);
    StretchedBody& made = stretched_[number];
    if (made.of == body.tree && made.volume_version == tree.volume_version &&
        made.stretch == body.stretch)
        return made;
    made.of = body.tree;
    made.stretch = body.stretch;
    made.volume_version = tree.volume_version;
    ++made.version;
    made.tree = mapped(tree.tree, body.stretch);
    made.mesh = made.finite = nullptr;
    if (const auto mesh = meshes_.find(tree.mesh); mesh != meshes_.end()) {
        made.mesh = std::make_shared<const Mesh>(mapped(*mesh->second.mesh, body.stretch));
        made.finite =
            mesh->second.mesh == mesh->second.finite
                ? made.mesh
                : std::make_shared<const Mesh>(mapped(*mesh->second.finite, body.stretch));
    }
    return made;
}

EngineSide RecordedQueries::side_of_body(std::uint32_t number) {
    const BodyState& body = bodies_.at(number);
    EngineSide side = side_of(body.tree);
    if (!body.is_stretched()) return side;
    const StretchedBody& made = stretched(number);
    side.tree = &made.tree;
    side.mesh = made.mesh.get();
    side.version = made.version;
    return side;
}

std::shared_ptr<const Mesh> RecordedQueries::finite_mesh(std::uint32_t number) {
    const BodyState& body = bodies_.at(number);
    if (body.is_stretched()) return stretched(number).finite;
    const auto mesh = meshes_.find(trees_.at(body.tree).mesh);
    return mesh == meshes_.end() ? nullptr : mesh->second.finite;
}

void RecordedQueries::note(OddRecords& records, const std::string& what) const {
    if (records.count++ < most_odd)
        records.first.push_back(what + ", at frame " + std::to_string(frame_));
}

template <class State>
State& RecordedQueries::known(std::map<std::uint32_t, State>& states, std::uint32_t number,
                              const char* what) {
    const auto found = states.find(number);
    if (found == states.end())
        fail(std::string(what) + " " + std::to_string(number) + " is used before it is recorded");
    return found->second;
}

void RecordedQueries::fail(const std::string& what) const {
    throw InputError(name_ + ": " + what + " (frame " + std::to_string(frame_) + ").");
}

}  // namespace scb::scenes
