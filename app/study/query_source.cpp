#include "app/study/query_source.h"

#include <algorithm>

#include "app/study/recorded_query.h"
#include "core/analysis/level_overlaps.h"
#include "core/base/text_format.h"
#include "core/platform/input_files.h"
#include "core/platform/number_list.h"
#include "scb/error.h"
#include "scenes/recordings/recording_input.h"

namespace scb::app {
namespace {

constexpr const char* record_again =
    "record it again, or, where it is a baseline, see what `scb golden check` says";

/// The options with which the trace was recorded, as the command line would say them.
struct RecordedOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    QueryOptions query;
    QueryLimits limits;
};

RecordedOptions recorded_options(const TraceHeader& header, const SceneOptions& given) {
    RecordedOptions recorded;
    recorded.scene.names = header.source;
    recorded.scene.models_dir = given.models_dir;
    recorded.hierarchy.volumes = volume_kind_name(header.volume);
    recorded.hierarchy.growth = header.growth;
    recorded.hierarchy.margin = header.margin;
    recorded.hierarchy.split = header.split;
    recorded.query.test = overlap_test_name(header.options.overlap.test);
    recorded.query.frames = auto_frames;
    recorded.query.threshold = header.options.overlap.threshold;
    recorded.query.descent = header.options.descent;
    if (is_of_distance(header.kind)) {
        recorded.query.distance = {header.distance, std::nullopt};
        if (header.kind == QueryKind::within) recorded.query.distance->within = header.tolerance;
    }
    recorded.limits.max_pairs = static_cast<std::int64_t>(header.options.max_pairs);
    if (header.options.stop_level >= 0)
        recorded.limits.levels = std::to_string(header.options.stop_level);
    return recorded;
}

std::string text_of(const MeshFingerprint& mesh) {
    return counted(mesh.triangles, "triangle", "triangles") + " and " +
           counted(mesh.vertices, "vertex", "vertices");
}

/// "when the mesh of A had ..., and cone has another of ..."
std::string mesh_words(const TraceBody& then, const MeshFingerprint& now,
                       const std::string& scene) {
    if (text_of(then.mesh) == text_of(now))
        return "with another mesh of " + then.name + ": it had " + text_of(now) + " as that of " +
               scene + " has, but other coordinates or indices";
    return "when the mesh of " + then.name + " had " + text_of(then.mesh) + ", and " + scene +
           " has another of " + text_of(now);
}

/// Why the scene of a trace cannot be opened, without contents of its files: a trace may come from
/// a stranger and name any file.
std::string plain_reason(const InputError& error, const SceneOptions& scene) {
    std::string there;
    for (const std::string& name : scene.names) {
        std::error_code ignored;
        std::filesystem::path file = name;
        if (!std::filesystem::exists(file, ignored))
            file = std::filesystem::path(scene.models_dir) / name;
        // Messages about missing files and built-in scenes reveal no file contents.
        if (!std::filesystem::exists(file, ignored)) return error.what();
        // The message begins with the faulty file.
        if (there.empty() || std::string_view(error.what()).starts_with(file.string() + ":"))
            there = file.string();
    }
    return there + " is not, or no longer, the scene or mesh that it was; `scb stats " + there +
           "` says why.";
}

}  // namespace

QuerySource::QuerySource(const SceneOptions& scene, const HierarchyOptions& hierarchy,
                         const QueryOptions& query, const QueryLimits& limits, bool recorded) {
    if (scene.is_trace()) {
        open_trace(scene, query.frames);
        return;
    }
    if (recorded && scene.is_recording()) {
        input_ =
            std::make_unique<scenes::TestInput>(std::make_shared<const scenes::Recording>(
                                                    scenes::read_recording(scene.recording_file())),
                                                query.frames, query.bodies);
        return;
    }
    query_ = open_query(scene, hierarchy, query, limits);
    header_ = trace_header(scene, query_);
}

QuerySource::QuerySource(std::shared_ptr<const scenes::Recording> recording,
                         const QueryOptions& query)
    : input_(
          std::make_unique<scenes::TestInput>(std::move(recording), query.frames, query.bodies)) {}

std::size_t QuerySource::body_index(std::size_t side) const {
    return is_recording() ? recorded()->sides()[side] : side == 0 ? query_.a : query_.b;
}

BodyAtFrame QuerySource::body(std::size_t side, int frame) const {
    if (is_recording()) return recorded()->body(side, frame);
    const std::size_t index = body_index(side);
    const scenes::Body& body = query_.scene.bodies[index];
    if (!trees_[side]) trees_[side] = std::make_shared<const Tree>(query_.hierarchy(index));
    // The scene owns the mesh.
    return {body.name,
            {std::shared_ptr<const Mesh>(), &query_.mesh(index)},
            trees_[side],
            scenes::pose_at(body.motion, frame)};
}

namespace {

/// "1.2" of "1.2.3": another minor version may build other nodes.
std::string minor_version(const std::string& version) {
    return version.substr(0, version.find('.', version.find('.') + 1));
}

}  // namespace

void QuerySource::open_trace(const SceneOptions& scene, const std::string& frames) {
    const std::string& path = scene.names[0];
    note_input(path);
    input_ = std::make_unique<scenes::TestInput>(path, frames, "", scene.selection);
    std::vector<int> wanted = input_->frames();
    trace_path_ = path;
    const TraceHeader& header = input_->header();
    if (minor_version(header.scb_version) != minor_version(SCB_VERSION))
        throw InputError(path + " was recorded by scb " + header.scb_version + ", and this is " +
                         SCB_VERSION + ", whose nodes may be others; " + record_again + ".");
    RecordedOptions recorded = recorded_options(header, scene);
    const bool is_of_meshes = header.source.size() == 2;
    if (!is_of_meshes) recorded.query.bodies = header.bodies[0].name + "," + header.bodies[1].name;
    try {
        query_ = open_query(recorded.scene, recorded.hierarchy, recorded.query, recorded.limits);
    } catch (const InputError& error) {
        throw InputError(path + ": the query that it recorded cannot be opened from here: " +
                         plain_reason(error, recorded.scene));
    }
    if (is_of_meshes) {
        // The first mesh has the identity pose, the frames have the poses of the second.
        for (const scenes::PoseKey& key : input_->poses())
            check_rigid(key.pose, path + ": frame " + std::to_string(key.frame));
        query_.scene.bodies[1].motion.told = input_->poses();
        query_.scene.frames = input_->poses().back().frame + 1;
    }
    // A and B are aliases for bodies of other names; a trace has the names themselves.
    const std::vector<scenes::Body>& bodies = query_.scene.bodies;
    if (!is_of_meshes && (bodies[query_.a].name != header.bodies[0].name ||
                          bodies[query_.b].name != header.bodies[1].name))
        throw InputError(path + ": " + query_.scene.name +
                         " has no bodies of the names that it recorded; " + record_again + ".");
    for (std::size_t side = 0; side < 2; ++side) {
        const MeshFingerprint now = fingerprint(query_.mesh(side == 0 ? query_.a : query_.b));
        const TraceBody& then = header.bodies[side];
        if (now != then.mesh)
            throw InputError(path + " was recorded " + mesh_words(then, now, query_.scene.name) +
                             "; " + record_again + ".");
    }
    if (frames == auto_frames) {
        const int own = query_.scene.default_frame;
        const bool has_own = std::binary_search(wanted.begin(), wanted.end(), own);
        wanted = {has_own ? own : wanted.front()};
    }
    query_.frames = std::move(wanted);
}

std::uint64_t QuerySource::test_count(int frame) const {
    return is_recording() ? recorded()->test_count(frame) : query_.collide(frame).n_v;
}

const QueryTrace& QuerySource::frame(int number) {
    if (is_recording()) return recorded()->frame(number);
    if (!input_) {
        query_.trace(number, made_);
        return made_;
    }
    const QueryTrace& frame = input_->frame(number);
    const Pose now = query_.b_to_a(number);
    if (now.rotation != frame.b_to_a.rotation || now.translation != frame.b_to_a.translation)
        throw InputError(trace_path_ + ": at frame " + std::to_string(number) + " of " +
                         query_.scene.name +
                         " the bodies are elsewhere than when it was recorded; record it again.");
    return frame;
}

QueryTrace QuerySource::frame_again(int number) const {
    if (is_recording()) return recorded()->rewound()->frame(number);
    return traced_query(query_, number);
}

Attribution QuerySource::attribution(const QueryTrace& frame) const {
    if (is_recording()) return recorded()->attribution();
    if (is_of_distance(header().kind))
        return attribute(header(), frame,
                         tested_pairs(query_.distance_steps(header(), frame), frame,
                                      outcomes_of(header(), frame)));
    const AnyHierarchy &a = query_.hierarchy(query_.a), &b = query_.hierarchy(query_.b);
    return attribute(
        a, b, header(), frame,
        all_contacts(a, query_.mesh(query_.a), b, query_.mesh(query_.b), header(), frame));
}

std::vector<std::size_t> QuerySource::level_overlaps(const QueryTrace& frame,
                                                     std::size_t most) const {
    if (is_recording()) return recorded()->level_overlaps(most);
    const BodyAtFrame a = body(0, frame.frame), b = body(1, frame.frame);
    return scb::level_overlaps(query_.hierarchy(query_.a), a.tree->shape(),
                               query_.hierarchy(query_.b), b.tree->shape(), frame.b_to_a,
                               header().options.overlap, most);
}

void refuse_recorded_distances(const TraceHeader& header) {
    if (header.engine && is_of_distance(header.kind))
        throw InputError(header.source.front() +
                         ": these queries are of distances, and this command is for queries of "
                         "overlap; `scb inspect` judges them, and `scb render traversal` and `scb "
                         "trace --events` show their tests.");
}

void QuerySource::refuse_distances() const {
    refuse_recorded_distances(header());
    if (!trace_path_.empty() && is_of_distance(header().kind))
        throw InputError(trace_path_ +
                         ": its queries are of distances, and this command is for queries of "
                         "overlap; `scb trace --events`, `scb view` and `scb render traversal` "
                         "show their tests, and `scb diff` compares them.");
}

void note_left_out(const scenes::RecordedTrace& recorded, const Note& note) {
    const TraceHeader& header = recorded.header();
    const std::uint64_t count = header.engine->left_out;
    if (count == 0) return;
    note("scb: " + recorded.recording().file->path + ": " + std::to_string(count) +
         (count == 1 ? " later query of " : " later queries of ") + header.bodies[0].name +
         " and " + header.bodies[1].name + (count == 1 ? " is" : " are") +
         " left out, since the first query of each frame counts; --query and --tag select others.");
}

}  // namespace scb::app
