#include "scenes/recordings/recording.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include "core/platform/input_files.h"
#include "core/platform/number_list.h"
#include "core/platform/utf8.h"
#include "scb/error.h"
#include "scenes/recordings/recording_input.h"

namespace scb::scenes {
namespace {

using Ended = RecordedQueries::Ended;

/// The latest value of a setting, or else the name of the file.
std::string setting_of(const RecordedQueries& queries, const std::string& key,
                       const std::string& path) {
    std::string value;
    for (const RecordedSetting& setting : queries.settings())
        if (setting.key == key) value = setting.value;
    return value.empty() ? std::filesystem::path(path).stem().string() : value;
}

bool is_same(const Pose& a, const Pose& b) {
    return a.rotation == b.rotation && a.translation == b.translation;
}

/// Fills a recording step by step.
class RecordingContents {
  public:
    explicit RecordingContents(Recording& recording) : recording_(recording) {}

    void take(RecordedQueries& queries, Ended ended) {
        const bool is_first = taken_at_ != queries.frame();
        if (is_first) taken_.clear();
        taken_at_ = queries.frame();
        const std::array<std::uint32_t, 2> queried = queries.query_bodies();
        const auto is_late = [&](std::uint32_t number) {
            return queries.bodies().contains(number) && !recording_.bodies.contains(number);
        };
        // A frame may have many queries of many bodies, so most queries concern two bodies only.
        if (is_first || ended == Ended::frame || is_late(queried[0]) || is_late(queried[1]))
            take_bodies(queries, ended);
        else
            for (const std::uint32_t number : queried) take_body(queries, number, true);
        if (ended == Ended::query) take_query(queries);
    }

    /// After the last step.
    void finish(RecordedQueries& queries) {
        Scene& scene = recording_.scene;
        const std::string& path = recording_.file->path;
        // Without bodies, each tree becomes a body.
        if (scene.bodies.empty())
            for (const auto& [number, tree] : queries.trees())
                body_of(queries, number, number).name = name_of(tree, number);
        if (scene.bodies.empty())
            throw InputError(path + ": it has no tree; record one with scb_record_tree.");
        for (const auto& [number, name] : recording_.file->summary.body_names)
            if (const auto body = recording_.bodies.find(number); body != recording_.bodies.end())
                scene.bodies[body->second].name = name;
        scene.name = file_name_of(setting_of(queries, "scene", path));
        scene.file = path;
        scene.listed = recording_.file->summary.frames;
        scene.default_frame = recording_.file->summary.frames.front();
        recording_.engine = setting_of(queries, "engine", path);
        if (askew_)
            recording_.refusal =
                path + ": the pose of '" + printable(askew_->name) + "' at frame " +
                std::to_string(askew_->frame) + " " + fault_ +
                ", so this project cannot query it; `scb inspect` judges the rest.";
        else if (changed_)
            recording_.refusal = path + ": the mesh of '" + printable(changed_->name) +
                                 "' changes at frame " + std::to_string(changed_->frame) +
                                 ", and hierarchies of this project are of one mesh; name one "
                                 "frame with --frames.";
        recording_.changes_meshes = changed_ && !askew_;
    }

  private:
    struct Place {
        std::string name;
        int frame = 0;
    };

    /// All bodies, which get an index in the order of their numbers.
    void take_bodies(RecordedQueries& queries, Ended ended) {
        const std::array<std::uint32_t, 2> queried = queries.query_bodies();
        for (const auto& [number, body] : queries.bodies())
            take_body(queries, number,
                      ended == Ended::frame || number == queried[0] || number == queried[1]);
        Scene& scene = recording_.scene;
        scene.frames = std::max(scene.frames, queries.frame() + 1);
        for (const auto& [number, mesh] : queries.meshes())
            if (mesh.version > 1 && !changed_) changed_ = {mesh.name, queries.frame()};
    }

    /// The pose of a body in a frame is its pose at its first query or, without a query, at the end
    /// of the frame. `is_due`: this is such a time.
    void take_body(RecordedQueries& queries, std::uint32_t number, bool is_due) {
        const auto found = queries.bodies().find(number);
        if (found == queries.bodies().end()) return;
        const BodyState& body = found->second;
        std::vector<PoseKey>& poses = body_of(queries, number, body.tree).motion.told;
        const std::uint32_t mesh = queries.trees().at(body.tree).mesh;
        if (mesh_of_body_.try_emplace(number, mesh).first->second != mesh && !changed_)
            changed_ = {body.name, queries.frame()};
        if (!body.pose_fault.empty()) {
            if (!askew_) fault_ = body.pose_fault;
            if (!askew_) askew_ = {body.name, queries.frame()};
            return;
        }
        // A stretched body has a mesh of its own.
        if (stretches_.try_emplace(number, body.stretch).first->second != body.stretch && !changed_)
            changed_ = {body.name, queries.frame()};
        const bool is_taken = is_due && taken_.insert(number).second;
        if (!poses.empty() && !is_taken) return;
        if (!poses.empty() && poses.back().frame == queries.frame())
            poses.back().pose = body.pose;
        else if (poses.empty() || !is_same(poses.back().pose, body.pose))
            poses.push_back({queries.frame(), body.pose});
    }

    void take_query(const RecordedQueries& queries) {
        const auto [place, added] =
            pairs_.try_emplace(queries.query_bodies(), recording_.pairs.size());
        if (added) recording_.pairs.push_back({queries.query_bodies(), {}, 0, {}});
        QueriedPair& pair = recording_.pairs[place->second];
        const int frame = queries.frame();
        if (!pair.frames.empty() && pair.frames.back() == frame) return;
        const EngineQuery& query = queries.query();
        const auto found =
            query.has_pairs ? EngineEvent::Kind::pair : EngineEvent::Kind::items_meet;
        std::pair<std::size_t, std::size_t> here{};
        for (const EngineEvent& event : query.events) {
            here.first += event.kind == found;
            here.second += event.kind == EngineEvent::Kind::volumes;
        }
        if (pair.frames.empty() || here > pair.most) {
            pair.fullest = frame;
            pair.most = here;
        }
        pair.frames.push_back(frame);
    }

    Body& body_of(RecordedQueries& queries, std::uint32_t number, std::uint32_t tree) {
        Scene& scene = recording_.scene;
        const auto [place, added] = recording_.bodies.try_emplace(number, scene.bodies.size());
        if (!added) return scene.bodies[place->second];
        const auto told = queries.meshes().find(queries.trees().at(tree).mesh);
        const bool has_mesh = told != queries.meshes().end();
        const auto body = queries.bodies().find(number);
        const bool is_stretched = body != queries.bodies().end() && body->second.is_stretched();
        std::size_t mesh = scene.meshes.size();
        if (!is_stretched)
            mesh = meshes_.try_emplace(has_mesh ? told->first : record_none, mesh).first->second;
        if (mesh == scene.meshes.size())
            scene.meshes.push_back(
                {has_mesh ? told->second.name : "objects",
                 is_stretched ? *mesh_of_body(queries, number) : *mesh_of(queries, tree),
                 recording_.file->path});
        scene.bodies.push_back({"", mesh, {}});
        return scene.bodies.back();
    }

    Recording& recording_;
    /// The first body with an unusable pose; the first mesh that changes, or body that gets another
    /// mesh.
    std::optional<Place> askew_, changed_;
    std::string fault_;                                            ///< of the pose of `askew_`
    std::map<std::uint32_t, Mat3> stretches_;                      ///< by body: the first
    int taken_at_ = -1;                                            ///< frame
    std::set<std::uint32_t> taken_;                                ///< bodies with their pose there
    std::map<std::uint32_t, std::size_t> meshes_;                  ///< by number
    std::map<std::uint32_t, std::uint32_t> mesh_of_body_{};        ///< numbers: the first
    std::map<std::array<std::uint32_t, 2>, std::size_t> pairs_{};  ///< by their bodies
};

}  // namespace

Recording read_recording(std::shared_ptr<const RecordingFile> file) {
    Recording recording;
    recording.file = std::move(file);
    RecordedQueries queries(*recording.file);
    RecordingContents contents(recording);
    for (Ended ended = queries.next(); ended != Ended::end; ended = queries.next())
        contents.take(queries, ended);
    contents.finish(queries);
    return recording;
}

Recording read_recording(const std::string& path, const QuerySelection& selection) {
    return read_recording(std::make_shared<const RecordingFile>(path, selection));
}

const QueriedPair& chosen_pair(const Recording& recording, const std::string& bodies) {
    const std::vector<QueriedPair>& pairs = recording.pairs;
    const std::string& path = recording.file->path;
    if (pairs.empty())
        throw InputError(path +
                         ": it has no query; record one with scb_record_query, or see its "
                         "trees with `scb render levels`.");
    const auto name = [&recording](std::uint32_t number) {
        return recording.scene.bodies[recording.bodies.at(number)].name;
    };
    const auto words = [&name](const QueriedPair& pair) {
        return name(pair.bodies[0]) + "," + name(pair.bodies[1]);
    };
    auto chosen = pairs.begin();
    if (!bodies.empty()) {
        const auto has_words = [&](const QueriedPair& pair) { return words(pair) == bodies; };
        chosen = std::find_if(pairs.begin(), pairs.end(), has_words);
        if (std::count_if(pairs.begin(), pairs.end(), has_words) > 1)
            throw InputError("--bodies " + bodies + ": several pairs of bodies of " + path +
                             " have these names, which contain commas; rename a body.");
        if (chosen == pairs.end() && bodies == "A,B" && pairs.size() == 1) chosen = pairs.begin();
    }
    if (chosen == pairs.end() || (bodies.empty() && pairs.size() > 1)) {
        constexpr std::size_t most = 5;
        std::string known;
        for (std::size_t i = 0; i < std::min(pairs.size(), most); ++i)
            known += (i == 0 ? "" : "; ") + words(pairs[i]);
        if (pairs.size() > most)
            known += "; and " + std::to_string(pairs.size() - most) + " other pairs";
        throw InputError((bodies.empty() ? path + ": it has queries of several pairs of bodies"
                                         : "--bodies " + bodies + ": " + path +
                                               " has no query of these bodies") +
                         "; name one of its pairs with --bodies (" + known + ").");
    }
    return *chosen;
}

Scene scene_of_recording(const std::string& path, const std::string& frames,
                         const QuerySelection& selection) {
    Recording recording = read_recording(path, selection);
    if (recording.changes_meshes) {
        std::vector<int> wanted = {recording.scene.default_frame};
        if (frames == auto_frames && !recording.pairs.empty())
            wanted = {recording.pairs.front().fullest};
        else if (!frames.empty() && frames != auto_frames)
            wanted = frames_among(recording.file->summary.frames, frames, recording.file->title(),
                                  "a recording may have");
        if (wanted.size() == 1) return scene_at(recording, wanted[0]);
    }
    if (!recording.refusal.empty()) throw InputError(recording.refusal);
    return std::move(recording.scene);
}

Scene scene_at(const Recording& recording, int frame) {
    Scene scene = recording.scene;
    scene.default_frame = frame;
    RecordedQueries queries(*recording.file);
    // The state that the poses have: at the first query of the frame or, without one, at its end.
    for (Ended ended = queries.next(); ended != Ended::end; ended = queries.next())
        if (queries.frame() == frame) break;
    for (const auto& [number, body] : queries.bodies()) {
        Body& of_scene = scene.bodies[recording.bodies.at(number)];
        const NamedMesh named = {scene.meshes[of_scene.mesh].name, *mesh_of_body(queries, number),
                                 recording.file->path};
        // Bodies may have shared a mesh that they share no longer.
        of_scene.mesh = scene.meshes.size();
        scene.meshes.push_back(named);
    }
    return scene;
}

namespace {

std::shared_ptr<const Mesh> mesh_or_none(std::shared_ptr<const Mesh> mesh) {
    static const auto none = std::make_shared<const Mesh>();
    return mesh ? mesh : none;
}

}  // namespace

std::shared_ptr<const Mesh> mesh_of(const RecordedQueries& queries, std::uint32_t tree) {
    const auto told = queries.meshes().find(queries.trees().at(tree).mesh);
    return mesh_or_none(told == queries.meshes().end() ? nullptr : told->second.finite);
}

std::shared_ptr<const Mesh> mesh_of_body(RecordedQueries& queries, std::uint32_t body) {
    return mesh_or_none(queries.finite_mesh(body));
}

std::string name_of(const TreeState& tree, std::uint32_t number) {
    return tree.name.empty() ? "tree " + std::to_string(number) : tree.name;
}

}  // namespace scb::scenes
