#include "scenes/recordings/recorded_queries.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "core/base/text_format.h"
#include "core/base/word_hash.h"
#include "core/judge/mapped_volume.h"
#include "scb/error.h"
#include "scenes/recordings/recorded_volume.h"
#include "scenes/scene/pose_rows.h"

namespace scb::scenes {
namespace {

/// More are counted.
constexpr std::size_t most_odd = 20;
/// Shares of the lengths in question, by how exact the engine's numbers are: some units in the last
/// place of products of a few.
constexpr double single_tolerance = 1e-6, double_tolerance = 1e-12;
/// Where a body stands, each coordinate is rounded once: of this share of the lengths above.
constexpr double placing_share = 0.125;
/// A number that says that its engine computes in 32 bits: one that takes most of these. Whole
/// numbers and short fractions do not.
bool is_long(double value) {
    constexpr double short_bits = 0x1p16;
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent) * short_bits;
    return std::isfinite(value) && value != std::trunc(value) && mantissa != std::trunc(mantissa);
}

bool is_of_32_bits(double value) {
    return static_cast<double>(static_cast<float>(value)) == value || !std::isfinite(value);
}

/// See MeshState::finite.
Mesh made_finite(Mesh mesh) {
    const auto some = std::find_if(mesh.vertices.begin(), mesh.vertices.end(), is_usable);
    const Vec3 place = some == mesh.vertices.end() ? Vec3(Vec3::Zero()) : *some;
    for (Triangle& triangle : mesh.triangles) {
        // A vertex that there is not is an error, which check_mesh reports.
        const auto is_known = [&mesh](std::uint32_t v) { return v < mesh.vertices.size(); };
        if (!std::all_of(triangle.begin(), triangle.end(), is_known)) continue;
        const auto broken =
            std::find_if(triangle.begin(), triangle.end(),
                         [&mesh](std::uint32_t v) { return !is_usable(mesh.vertices[v]); });
        if (broken == triangle.end()) continue;
        const std::uint32_t v = *broken;
        triangle = {v, v, v};
    }
    for (Vec3& vertex : mesh.vertices)
        if (!is_usable(vertex)) vertex = place;
    return mesh;
}

/// Above the numbers of a tree's objects; 0 where these are so large that they are no numbers.
std::size_t objects_of(const NodeTree& tree) {
    constexpr std::size_t most = 1'000'000;
    std::size_t end = 0;
    for (std::size_t node = 0; node < tree.size(); ++node)
        for (const std::uint32_t item : tree.items(node))
            end = std::max(end, std::size_t{item} + 1);
    return end <= most ? end : 0;
}

/// Whether items are alone in leaves.
bool has_single_objects(const NodeTree& tree, const TreeShape& shape) {
    for (std::uint32_t node = 0; node < shape.size(); ++node)
        if (tree.items(node).size() > (shape.is_leaf(node) ? 1 : 0)) return false;
    return !shape.holder.empty();
}

/// What a node is known by in a tree that is built anew: a leaf by its items, others by number.
std::uint64_t node_key(std::uint32_t number, std::span<const std::uint32_t> items) {
    WordHash hash;
    if (items.empty()) hash.add(number);
    for (const std::uint32_t item : items) hash.add((std::uint64_t{item} + 1) << 32);
    return hash.value;
}

/// Of the children and items of a node.
std::uint64_t links_hash(const RecordedNode& node) {
    WordHash hash;
    hash.add(node.children.size());
    for (const std::uint32_t child : node.children) hash.add(child);
    for (const std::uint32_t item : node.items) hash.add(item);
    return hash.value;
}

/// The tree that the record is about.
std::optional<std::uint32_t> tree_told_by(const Record& record) {
    if (const auto* tree = std::get_if<RecordedTree>(&record)) return tree->tree;
    if (const auto* node = std::get_if<RecordedNode>(&record)) return node->tree;
    if (const auto* refit = std::get_if<RecordedRefit>(&record)) return refit->tree;
    return std::nullopt;
}

}  // namespace

RecordedQueries::RecordedQueries(const RecordingFile& file)
    : name_(file.path), reader_(file.bytes, file.path) {
    query_.tells_items = file.summary.item_tests > 0;
    query_.tells_pairs = file.summary.tells_pairs || file.summary.pairs > 0;
}

RecordedQueries::Step RecordedQueries::next() {
    if (ended_) return Step::end;
    if (next_frame_) {
        frame_ = *next_frame_;
        next_frame_.reset();
        for (auto& [number, body] : bodies_) body.last = body.pose;
    }
    query_done_ = false;
    while (const Record* record = reader_.next()) {
        std::visit([&](const auto& r) { take(r); }, *record);
        telling_ = tree_told_by(*record);
        if (query_done_) return Step::query;
        if (next_frame_) return Step::frame;
    }
    ended_ = true;
    // What a program that crashed has told of its last query counts as an end ahead of time.
    if (!in_query_) return Step::frame;
    broke_off_ = true;
    take(RecordedQueryEnd{false, 0});
    ended_ = false;
    return Step::query;
}

void RecordedQueries::changed(TreeState& tree) {
    tree.whole = false;
    ++tree.version;
    ++tree.volume_version;
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
    EngineEvent taken{EngineEvent::Kind::volumes, 0, event.a, event.b};
    const auto tag = static_cast<RecordTag>(event.tag);
    if (tag < RecordTag::items_apart)
        taken.stage = event.tag;
    else if (tag == RecordTag::items_apart)
        taken.kind = EngineEvent::Kind::items_apart;
    else if (tag == RecordTag::items_meet)
        taken.kind = EngineEvent::Kind::items_meet;
    else if (tag == RecordTag::pair)
        taken.kind = EngineEvent::Kind::pair;
    else
        return;  // of a later version
    query_.events.push_back(taken);
}

void RecordedQueries::take(const RecordedSetting& setting) {
    settings_.push_back({shown(setting.key), shown(setting.value)});
    if (setting.key == "tests") exact_tests_ = setting.value == "exact";
    if (setting.key != "tolerance") return;
    double told = 0;
    const char* end = setting.value.data() + setting.value.size();
    const auto [stop, error] = std::from_chars(setting.value.data(), end, told);
    if (error == std::errc() && stop == end && told >= 0 && told <= max_coordinate)
        told_tolerance_ = told;
    else
        note(unusable_, "the tolerance \"" + settings_.back().value + "\" is no length");
}

void RecordedQueries::take(const RecordedMesh& mesh) {
    MeshState& state = meshes_[mesh.mesh];
    auto made = std::make_shared<Mesh>();
    made->vertices.reserve(mesh.coordinates.size() / 3);
    for (std::size_t i = 0; i + 2 < mesh.coordinates.size(); i += 3)
        made->vertices.emplace_back(mesh.coordinates[i], mesh.coordinates[i + 1],
                                    mesh.coordinates[i + 2]);
    made->triangles.reserve(mesh.indices.size() / 3);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        made->triangles.push_back({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
    std::shared_ptr<const Mesh> finite = made;
    if (!std::all_of(made->vertices.begin(), made->vertices.end(), is_usable))
        finite = std::make_shared<const Mesh>(made_finite(*made));
    check_mesh(*finite, name_ + ": mesh " + std::to_string(mesh.mesh));
    const Box box = bounding_box(*finite);
    state.name = shown(mesh.name);
    const bool is_same = state.mesh && finite == made && state.mesh->vertices == made->vertices &&
                         state.mesh->triangles == made->triangles &&
                         state.coordinate_bytes == mesh.coordinate_bytes;
    if (is_same) return;
    if (!state.rest || state.rest->vertices.size() != finite->vertices.size() ||
        state.rest->triangles != finite->triangles)
        state.rest = finite;
    state.mesh = std::move(made);
    state.finite = std::move(finite);
    state.coordinate_bytes = mesh.coordinate_bytes;
    state.reach = std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
    state.told_at = frame_;
    ++state.version;
    // Which triangles there are is in the shape.
    for (auto& [number, tree] : trees_)
        if (tree.mesh == mesh.mesh) changed(tree);
}

void RecordedQueries::take(const RecordedTree& tree) {
    TreeState& state = trees_[tree.tree];
    const int version = state.version + 1, volume_version = state.volume_version + 1;
    std::map<std::uint64_t, EarlierNode> before;
    for (std::uint32_t i = 0; i < state.tree.size(); ++i) {
        const TreeNode& node = state.tree[i];
        const NodeState& of_node = state.node_states[i];
        before[node_key(node.number, state.tree.items(i))] = {of_node.volume, node.told_at,
                                                              of_node.links, node.links_at};
    }
    state = {};
    state.before = std::move(before);
    state.name = shown(tree.name);
    state.mesh = tree.mesh;
    state.tree.has_objects = tree.mesh == record_none;
    state.directions = tree.directions;
    state.version = version;
    state.volume_version = volume_version;
}

void RecordedQueries::take(const RecordedNode& node) {
    TreeState& state = known(trees_, node.tree, "tree");
    TreeNode made;
    made.number = node.node;
    made.parent = node.parent;
    made.id = node.id;
    const std::uint64_t links = links_hash(node);
    const std::uint32_t known_at = state.tree.index_of(node.node);
    changed(state);
    // Since the tree was last used, a node that is recorded again is another one of this number.
    if (known_at != no_index && state.node_states[known_at].epoch != epoch_) {
        NodeState& of_node = state.node_states[known_at];
        of_node.epoch = epoch_;
        if (std::exchange(of_node.links, links) != links)
            state.tree.relink(known_at, node.parent, frame_, node.children, node.items);
        return set_volume(state, known_at, node.volume);
    }
    const auto old = state.before.find(node_key(node.node, node.items));
    made.links_at =
        old != state.before.end() && old->second.links == links ? old->second.links_at : frame_;
    const std::size_t before = state.tree.size();
    state.tree.add(std::move(made), shown(node.name), node.children, node.items);
    if (state.tree.size() == before) return;
    state.node_states.push_back({links, epoch_, 0});
    set_volume(state, static_cast<std::uint32_t>(before), node.volume);
}

void RecordedQueries::take(const RecordedRefit& refit) {
    TreeState& state = known(trees_, refit.tree, "tree");
    const std::uint32_t index = state.tree.index_of(refit.node);
    if (index == no_index)
        return note(contradictions_, "node " + std::to_string(refit.node) + ", which tree " +
                                         std::to_string(refit.tree) +
                                         " does not have, was refitted");
    ++state.volume_version;
    set_volume(state, index, refit.volume);
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
    // A body that is announced again stays where it is.
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
    if (!frame_told_) {
        frame_told_ = true;
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
    bodies_of_query_ = {query.body_a, query.body_b};
    for (const std::uint32_t number : bodies_of_query_) {
        const std::uint32_t of = known(bodies_, number, "body").tree;
        const std::uint32_t mesh = trees_.at(of).mesh;
        if (mesh != record_none && !meshes_.contains(mesh) && without_mesh_.insert(of).second)
            note(unusable_, "tree " + std::to_string(of) + " is of mesh " + std::to_string(mesh) +
                                ", which was not told, so that results are not judged");
    }
    query_.events.clear();
}

void RecordedQueries::take(const RecordedQueryEnd& end) {
    if (!in_query_) fail("a query ends that did not begin");
    in_query_ = false;
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
    // A body against itself stands where it stands.
    query_.b_to_a = query_.self ? Pose{} : relative_pose(bodies[0]->pose, bodies[1]->pose);
    query_.tolerance = tolerance_of(share, length + placing) + askew * (length + distances);
    query_.triangle_tolerance =
        tolerance_of(share, length_of_meshes + placing) + askew * (length_of_meshes + distances);
    query_.tolerance_slope = told_tolerance_ ? 0 : share + askew;
    const double of_numbers = share * (length + placing), of_poses = askew * (length + distances);
    query_.tolerance_cause = told_tolerance_ && *told_tolerance_ >= of_poses
                                 ? ToleranceCause::setting
                             : of_poses > of_numbers ? ToleranceCause::pose
                             : placing > length      ? ToleranceCause::distance
                                                     : ToleranceCause::reach;
    query_.b_to_a_before.reset();
    if (query_.placed && bodies[0]->last && bodies[1]->last)
        query_.b_to_a_before = relative_pose(*bodies[0]->last, *bodies[1]->last);
}

void RecordedQueries::set_volume(TreeState& tree, std::uint32_t index,
                                 const RecordedVolume& volume) {
    WordHash told;
    told.add(static_cast<std::uint64_t>(volume.kind));
    for (const double value : volume.values) told.add(std::bit_cast<std::uint64_t>(value));
    int told_at = frame_;
    const std::uint64_t last = std::exchange(tree.node_states[index].volume, told.value);
    // An engine may tell all again, also those that it forgot to change.
    if (last == told.value) return;
    if (last == 0) {
        // Of a tree that is built anew: the volume may be the one that it had.
        const auto old =
            tree.before.find(node_key(tree.tree[index].number, tree.tree.items(index)));
        if (old != tree.before.end() && old->second.volume == told.value)
            told_at = old->second.told_at;
    }
    std::string fault;
    NodeVolume made = node_volume(volume, tree.directions, fault);
    tree.has_numbers = tree.has_numbers || std::any_of(volume.values.begin(), volume.values.end(),
                                                       [](double value) { return value != 0; });
    tree.has_long =
        tree.has_long || std::any_of(volume.values.begin(), volume.values.end(), is_long);
    tree.single =
        tree.single && std::all_of(volume.values.begin(), volume.values.end(), is_of_32_bits);
    tree.tree.set_volume(index, std::move(made), told_at, std::move(fault),
                         scenes::reach_of(volume, tree.directions));
}

bool RecordedQueries::is_single(const TreeState& tree) const {
    const auto mesh = meshes_.find(tree.mesh);
    const bool has_mesh = mesh != meshes_.end();
    if (has_mesh && mesh->second.coordinate_bytes == 4) return true;
    // Numbers that are short in any case say nothing of the engine's.
    return tree.single && tree.has_numbers && (tree.has_long || !has_mesh);
}

double RecordedQueries::mesh_reach(const TreeState& tree) const {
    const auto mesh = meshes_.find(tree.mesh);
    return mesh != meshes_.end() ? mesh->second.reach : 0;
}

double RecordedQueries::reach_of(const TreeState& tree) const {
    if (tree.reach_version != tree.volume_version) {
        tree.reach = 0;
        for (std::size_t i = 0; i < tree.tree.size(); ++i)
            tree.reach = std::max(tree.reach, tree.tree[i].reach);
        tree.reach_version = tree.volume_version;
    }
    return std::max(tree.reach, mesh_reach(tree));
}

double RecordedQueries::tolerance_of(double share, double length) const {
    // This program's own rounding is not the engine's.
    return told_tolerance_ ? std::max(*told_tolerance_, double_tolerance * length) : share * length;
}

NodeTolerance RecordedQueries::node_tolerance_of(const TreeState& tree) const {
    const double share = is_single(tree) ? single_tolerance : double_tolerance;
    return {tolerance_of(share, mesh_reach(tree)), told_tolerance_ ? double_tolerance : share};
}

double RecordedQueries::tolerance_of(const TreeState& tree) const {
    return tolerance_of(is_single(tree) ? single_tolerance : double_tolerance, reach_of(tree));
}

EngineSide RecordedQueries::side_of(std::uint32_t tree) {
    TreeState& state = trees_.at(tree);
    const auto mesh = meshes_.find(state.mesh);
    const Mesh* of = mesh == meshes_.end() ? nullptr : mesh->second.mesh.get();
    if (!state.whole) {
        state.shape = tree_shape(state.tree, of ? of->triangles.size() : objects_of(state.tree));
        state.single_objects = has_single_objects(state.tree, state.shape);
        state.whole = true;
    }
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
        fail(std::string(what) + " " + std::to_string(number) + " is used before it is told");
    return found->second;
}

void RecordedQueries::fail(const std::string& what) const {
    throw InputError(name_ + ": " + what + " (frame " + std::to_string(frame_) + ").");
}

}  // namespace scb::scenes
