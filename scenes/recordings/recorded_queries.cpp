#include "scenes/recordings/recorded_queries.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/word_hash.h"
#include "scb/error.h"
#include "scenes/recordings/recorded_volume.h"
#include "scenes/scene/pose_rows.h"
#include "scenes/text/utf8.h"

namespace scb::scenes {
namespace {

/// More are counted.
constexpr std::size_t most_oddities = 20;
/// Shares of the lengths in question, by how exact the engine's numbers are: some units in the last
/// place of products of a few.
constexpr double single_tolerance = 1e-6, double_tolerance = 1e-12;
/// A pose that is nearer to rigid is one, of 64 bits.
constexpr double double_defect = 1e-12;
/// A pose that is farther from rigid is none: see rigidity_defect.
constexpr double most_defect = 1e-4;

bool is_single(double value) {
    return static_cast<double>(static_cast<float>(value)) == value || !std::isfinite(value);
}

/// The rotation nearly at hand, rigid to the last bits: columns made unit vectors at right angles,
/// the first kept.
Pose made_rigid(Pose pose) {
    Vec3 x = pose.rotation.col(0), y = pose.rotation.col(1);
    x /= std::sqrt(squared_norm(x));
    y -= dot(x, y) * x;
    y /= std::sqrt(squared_norm(y));
    pose.rotation.col(0) = x;
    pose.rotation.col(1) = y;
    pose.rotation.col(2) = cross(x, y);
    return pose;
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

/// A name as it is told to people: what is very long is cut.
std::string shown(std::string text) {
    constexpr std::size_t most = 500;
    const bool cut = text.size() > most;
    if (cut) text.resize(most);
    return printable(std::move(text)) + (cut ? "..." : "");
}

/// The tree that the record is about.
std::optional<std::uint32_t> tree_told_by(const Record& record) {
    if (const auto* tree = std::get_if<RecordedTree>(&record)) return tree->tree;
    if (const auto* node = std::get_if<RecordedNode>(&record)) return node->tree;
    if (const auto* refit = std::get_if<RecordedRefit>(&record)) return refit->tree;
    return std::nullopt;
}

}  // namespace

bool BodyState::is_rigid() const { return defect <= most_defect; }

RecordingSummary summary_of(std::string_view bytes, std::string_view name) {
    RecordingSummary summary;
    std::array<bool, 128> is_stage{};
    RecordingReader reader(bytes, name);
    while (const Record* record = reader.next()) {
        if (const auto* event = std::get_if<RecordedEvent>(record)) {
            const auto tag = static_cast<RecordTag>(event->tag);
            summary.volume_tests += tag < RecordTag::items_apart;
            summary.item_tests += tag == RecordTag::items_apart || tag == RecordTag::items_meet;
            summary.pairs += tag == RecordTag::pair;
            if (tag > RecordTag::volumes_overlap && tag < RecordTag::items_apart) {
                if (!is_stage[event->tag]) summary.stages.insert(event->tag);
                is_stage[event->tag] = true;
            }
        } else if (const auto* frame = std::get_if<RecordedFrame>(record)) {
            summary.frames.push_back(static_cast<int>(frame->frame));
        }
        if (const auto* setting = std::get_if<RecordedSetting>(record))
            summary.tells_pairs |= setting->key == "results" && setting->value == "pairs";
        summary.queries += std::holds_alternative<RecordedQuery>(*record);
    }
    if (summary.frames.empty()) summary.frames.push_back(0);
    // Those of a file whose frames do not ascend, too, which cannot be read on.
    std::sort(summary.frames.begin(), summary.frames.end());
    return summary;
}

RecordedQueries::RecordedQueries(std::string_view bytes, std::string_view name,
                                 const RecordingSummary& summary)
    : name_(name), reader_(bytes, name) {
    query_.tells_items = summary.item_tests > 0;
    query_.tells_pairs = summary.tells_pairs || summary.pairs > 0;
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
        return note_odd("a stage has the number " + std::to_string(stage.stage) +
                        ", and stages are 1 to 127");
    if (!stages_.contains(stage.stage)) stage_order_.push_back(stage.stage);
    stages_[stage.stage] = shown(stage.name);
}

void RecordedQueries::take(const RecordedEvent& event) {
    if (!in_query_) {
        note_odd("a test or pair stands outside of queries");
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
    if (setting.key != "tolerance") return;
    double told = 0;
    const char* end = setting.value.data() + setting.value.size();
    const auto [stop, error] = std::from_chars(setting.value.data(), end, told);
    if (error == std::errc() && stop == end && told >= 0 && told <= max_coordinate)
        told_tolerance_ = told;
    else
        note_odd("the tolerance \"" + settings_.back().value + "\" is no length");
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
    check_mesh(*made, name_ + ": mesh " + std::to_string(mesh.mesh));
    const Box box = bounding_box(*made);
    state.name = shown(mesh.name);
    const bool is_same = state.mesh && state.mesh->vertices == made->vertices &&
                         state.mesh->triangles == made->triangles &&
                         state.coordinate_bytes == mesh.coordinate_bytes;
    if (is_same) return;
    state.mesh = std::move(made);
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
    state = {};
    state.name = shown(tree.name);
    state.mesh = tree.mesh;
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
    const std::size_t before = state.tree.size();
    state.tree.add(std::move(made), shown(node.name), node.children, node.items);
    changed(state);
    if (state.tree.size() > before)
        set_volume(state, static_cast<std::uint32_t>(before), node.volume);
}

void RecordedQueries::take(const RecordedRefit& refit) {
    TreeState& state = known(trees_, refit.tree, "tree");
    const std::uint32_t index = state.tree.index_of(refit.node);
    if (index == no_index)
        return note_odd("node " + std::to_string(refit.node) + ", which tree " +
                        std::to_string(refit.tree) + " does not have, was refitted");
    ++state.volume_version;
    set_volume(state, index, refit.volume);
}

void RecordedQueries::take(const RecordedBody& body) {
    known(trees_, body.tree, "tree");
    BodyState& state = bodies_[body.body] = {};
    state.name = shown(body.name);
    state.tree = body.tree;
}

void RecordedQueries::take(const RecordedFrame& frame) {
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
    const Pose told = pose_of(pose.rows);
    body.defect =
        told.translation.cwiseAbs().maxCoeff() <= max_coordinate ? rigidity_defect(told) : HUGE_VAL;
    const bool is_nearly_rigid = body.defect > double_defect && body.defect <= most_defect;
    body.pose = is_nearly_rigid ? made_rigid(told) : told;
    body.placed = true;
}

void RecordedQueries::take(const RecordedQuery& query) {
    if (in_query_)
        fail("a query begins within a query; call scb_record_query_end where a query ends");
    in_query_ = true;
    bodies_of_query_ = {query.body_a, query.body_b};
    for (const std::uint32_t number : bodies_of_query_) {
        const std::uint32_t of = known(bodies_, number, "body").tree;
        const std::uint32_t mesh = trees_.at(of).mesh;
        if (mesh != record_none && !meshes_.contains(mesh) && without_mesh_.insert(of).second)
            note_odd("tree " + std::to_string(of) + " is of mesh " + std::to_string(mesh) +
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
    double share = 0, length = 0, length_of_meshes = 0, defect = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        bodies[k] = &bodies_.at(bodies_of_query_[k]);
        query_.sides[k] = side_of(bodies[k]->tree);
        const TreeState& tree = trees_.at(bodies[k]->tree);
        share = std::max(share, share_of(tree));
        const double away = std::sqrt(squared_norm(bodies[k]->pose.translation));
        length += reach_of(tree) + away;
        length_of_meshes += mesh_reach(tree) + away;
        defect = std::max(defect, bodies[k]->defect);
    }
    query_.rigid = bodies[0]->is_rigid() && bodies[1]->is_rigid();
    query_.b_to_a = query_.rigid ? relative_pose(bodies[0]->pose, bodies[1]->pose) : Pose{};
    if (!query_.rigid) defect = 0;
    query_.tolerance = tolerance_of(share, length) + defect * length;
    query_.triangle_tolerance = tolerance_of(share, length_of_meshes) + defect * length_of_meshes;
    query_.b_to_a_before.reset();
    if (query_.rigid && bodies[0]->last && bodies[1]->last)
        query_.b_to_a_before = relative_pose(*bodies[0]->last, *bodies[1]->last);
}

void RecordedQueries::set_volume(TreeState& tree, std::uint32_t index,
                                 const RecordedVolume& volume) {
    WordHash told;
    told.add(static_cast<std::uint64_t>(volume.kind));
    for (const double value : volume.values) told.add(std::bit_cast<std::uint64_t>(value));
    if (index == tree.told_volumes.size())
        tree.told_volumes.push_back(told.value);
    else if (std::exchange(tree.told_volumes[index], told.value) == told.value)
        return;  // an engine may tell all again, also those that it forgot to change
    std::string fault;
    NodeVolume made = node_volume(volume, tree.directions, fault);
    tree.single = tree.single && std::all_of(volume.values.begin(), volume.values.end(), is_single);
    for (const double value : volume.values)
        if (std::isfinite(value)) tree.reach = std::max(tree.reach, std::abs(value));
    tree.tree.set_volume(index, std::move(made), frame_, std::move(fault));
}

double RecordedQueries::share_of(const TreeState& tree) const {
    const auto mesh = meshes_.find(tree.mesh);
    const bool single = (tree.single && tree.reach > 0) ||
                        (mesh != meshes_.end() && mesh->second.coordinate_bytes == 4);
    return single ? single_tolerance : double_tolerance;
}

double RecordedQueries::mesh_reach(const TreeState& tree) const {
    const auto mesh = meshes_.find(tree.mesh);
    return mesh != meshes_.end() ? mesh->second.reach : 0;
}

double RecordedQueries::reach_of(const TreeState& tree) const {
    return std::max(tree.reach, mesh_reach(tree));
}

double RecordedQueries::tolerance_of(double share, double length) const {
    // This program's own rounding is not the engine's.
    return told_tolerance_ ? std::max(*told_tolerance_, double_tolerance * length) : share * length;
}

double RecordedQueries::tolerance_of(const TreeState& tree) const {
    return tolerance_of(share_of(tree), reach_of(tree));
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
    return {&state.tree, &state.shape, of, state.mesh == record_none && state.single_objects};
}

void RecordedQueries::note_odd(const std::string& what) {
    if (oddities_.size() < most_oddities)
        oddities_.push_back(what + ", at frame " + std::to_string(frame_));
    else
        ++more_oddities_;
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
