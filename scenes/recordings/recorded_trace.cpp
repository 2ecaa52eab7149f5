#include "scenes/recordings/recorded_trace.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <tuple>

#include "core/judge/engine_trace.h"
#include "core/judge/engine_tree.h"
#include "scb/error.h"
#include "scenes/text/input_files.h"
#include "scenes/text/number_list.h"
#include "scenes/text/utf8.h"

namespace scb::scenes {
namespace {

using Step = RecordedQueries::Step;

std::string setting_of(const RecordedQueries& queries, const std::string& key) {
    std::string value;
    for (const RecordedSetting& setting : queries.settings())
        if (setting.key == key) value = setting.value;
    return value;
}

/// The names of bodies, each told from the others.
std::map<std::uint32_t, std::string> names_of(const RecordedQueries& queries) {
    std::map<std::uint32_t, std::string> names;
    std::set<std::string> taken;
    for (const auto& [number, body] : queries.bodies()) {
        std::string name =
            body.name.empty() ? "body " + std::to_string(number) : printable(body.name);
        while (!taken.insert(name).second) name += " (" + std::to_string(number) + ")";
        names[number] = name;
    }
    return names;
}

bool is_same(const Pose& a, const Pose& b) {
    return a.rotation == b.rotation && a.translation == b.translation;
}

/// Which two bodies were queried, and at which frames, in the order of the first time.
struct QueriedPair {
    std::array<std::uint32_t, 2> bodies{};
    std::vector<int> frames;
    /// The frame to show: the first with the most pairs, or, where none has any, tests.
    int fullest = 0;
    std::pair<std::size_t, std::size_t> most{};

    void add(int frame, const EngineQuery& query) {
        if (!frames.empty() && frames.back() == frame) return;
        std::pair<std::size_t, std::size_t> here{};
        const auto found =
            query.tells_pairs ? EngineEvent::Kind::pair : EngineEvent::Kind::items_meet;
        for (const EngineEvent& event : query.events) {
            here.first += event.kind == found;
            here.second += event.kind == EngineEvent::Kind::volumes;
        }
        if (frames.empty() || here > most) {
            fullest = frame;
            most = here;
        }
        frames.push_back(frame);
    }
};

/// Where a tree has no mesh, its items are objects: one mesh without triangles stands for all.
std::shared_ptr<const Mesh> mesh_of(const RecordedQueries& queries, std::uint32_t tree) {
    static const auto none = std::make_shared<const Mesh>();
    const auto told = queries.meshes().find(queries.trees().at(tree).mesh);
    return told == queries.meshes().end() ? none : told->second.mesh;
}

std::string engine_of(const RecordedQueries& queries, const std::string& path) {
    const std::string told = setting_of(queries, "engine");
    return told.empty() ? std::filesystem::path(path).stem().string() : told;
}

/// "OBB", "AABB and hull".
std::string volumes_of(const std::vector<std::string>& titles) {
    std::string text;
    std::set<std::string> taken;
    for (const std::string& title : titles)
        if (taken.insert(title).second) text += (text.empty() ? "" : " and ") + title;
    return text.empty() ? "no volumes" : text;
}

/// Throws where a body cannot be drawn where it is.
void check_pose(const RecordedQueries& queries, const BodyState& body, const std::string& path) {
    if (!body.is_rigid())
        throw InputError(
            path + ": the pose of " + (body.name.empty() ? "a body" : "'" + body.name + "'") +
            " at frame " + std::to_string(queries.frame()) +
            " is not rigid; `scb inspect` judges the rest, and --frames names others.");
}

/// Fills a scene with what a recording tells, frame after frame.
class SceneOfRecording {
  public:
    explicit SceneOfRecording(const std::string& path) : path_(path) {}

    /// At the first query of a frame, whose poses these are, and at its end.
    void take(const RecordedQueries& queries) {
        const bool again = taken_ == queries.frame();
        taken_ = queries.frame();
        for (const auto& [number, body] : queries.bodies()) {
            std::vector<PoseKey>& poses = body_of(queries, number, body.tree).motion.told;
            if (!body.is_rigid()) {
                if (!askew_) askew_ = {body.name, queries.frame()};
                continue;
            }
            if (poses.empty() || (!again && !is_same(poses.back().pose, body.pose)))
                poses.push_back({queries.frame(), body.pose});
        }
        scene_.frames = std::max(scene_.frames, queries.frame() + 1);
        for (const auto& [number, mesh] : queries.meshes())
            if (mesh.version > 1 && !changed_) changed_ = {mesh.name, queries.frame()};
    }

    Scene finish(const RecordedQueries& queries, const RecordingSummary& summary) {
        // Trees alone stand where they are.
        if (scene_.bodies.empty())
            for (const auto& [number, tree] : queries.trees())
                body_of(queries, number, number).name =
                    tree.name.empty() ? "tree " + std::to_string(number) : tree.name;
        if (scene_.bodies.empty())
            throw InputError(path_ + ": it has no tree; record one with scb_record_tree.");
        for (const auto& [number, name] : names_of(queries))
            scene_.bodies[places_.at(number)].name = name;
        const std::string told = setting_of(queries, "scene");
        scene_.name =
            file_name_of(told.empty() ? std::filesystem::path(path_).stem().string() : told);
        scene_.file = path_;
        scene_.listed = summary.frames;
        scene_.default_frame = summary.frames.front();
        return std::move(scene_);
    }

    /// A body whose pose is not rigid, and the frame.
    const std::optional<std::pair<std::string, int>>& askew() const { return askew_; }
    /// A mesh that was told anew, and the frame: hierarchies of one's own are of one mesh.
    const std::optional<std::pair<std::string, int>>& changed() const { return changed_; }

  private:
    Body& body_of(const RecordedQueries& queries, std::uint32_t number, std::uint32_t tree) {
        const auto [place, added] = places_.try_emplace(number, scene_.bodies.size());
        if (added) {
            const auto told = queries.meshes().find(queries.trees().at(tree).mesh);
            const bool has_mesh = told != queries.meshes().end();
            const auto [mesh, is_new] =
                meshes_.try_emplace(has_mesh ? told->first : record_none, scene_.meshes.size());
            if (is_new)
                scene_.meshes.push_back(
                    {has_mesh ? told->second.name : "objects", *mesh_of(queries, tree), path_});
            scene_.bodies.push_back({"", mesh->second, {}});
        }
        return scene_.bodies[place->second];
    }

    std::string path_;
    Scene scene_;
    std::optional<std::pair<std::string, int>> changed_, askew_;
    int taken_ = -1;                                        ///< frame
    std::map<std::uint32_t, std::size_t> places_, meshes_;  ///< by number
};

}  // namespace

Scene scene_of_recording(std::string_view bytes, const std::string& path, ChangingMeshes changing) {
    const RecordingSummary summary = summary_of(bytes, path);
    RecordedQueries queries(bytes, path, summary);
    SceneOfRecording scene(path);
    for (Step step = queries.next(); step != Step::end; step = queries.next()) scene.take(queries);
    if (scene.askew() && changing == ChangingMeshes::refused)
        throw InputError(path + ": the pose of '" + printable(scene.askew()->first) +
                         "' at frame " + std::to_string(scene.askew()->second) +
                         " is not rigid, so that there is no query of it; `scb inspect` judges the "
                         "rest.");
    if (scene.changed() && changing == ChangingMeshes::refused)
        throw InputError(path + ": its mesh '" + printable(scene.changed()->first) +
                         "' changes at frame " + std::to_string(scene.changed()->second) +
                         ", and hierarchies of this project are of one mesh; leave out what asks "
                         "for them, or record frames of one mesh.");
    return scene.finish(queries, summary);
}

RecordedBodies bodies_of_recording(const std::string& path, const std::string& frames) {
    const RecordingSummary summary = summary_of(recording_bytes(path), path);
    int frame = summary.frames.front();
    if (!frames.empty()) {
        const std::vector<int> wanted =
            frames_among(summary.frames, frames, path, "a recording may have");
        if (wanted.size() != 1)
            throw InputError("--frames " + frames + ": this command takes one frame; give one.");
        frame = wanted[0];
    }
    return bodies_of_recording(path, frame);
}

RecordedBodies bodies_of_recording(const std::string& path, int frame) {
    const std::string bytes = recording_bytes(path);
    const RecordingSummary summary = summary_of(bytes, path);
    RecordedBodies result;
    result.scene = scene_of_recording(bytes, path, ChangingMeshes::allowed);
    result.frame = frame;
    RecordedQueries queries(bytes, path, summary);
    std::vector<std::string> titles;
    std::map<std::uint32_t, std::shared_ptr<const VolumeTree>> trees;
    const auto add = [&](const std::string& name, std::uint32_t tree, const Pose& pose) {
        std::shared_ptr<const VolumeTree>& known = trees[tree];
        if (!known) {
            const EngineSide told = queries.side_of(tree);
            known = volume_tree(*told.tree, *told.shape);
            for (std::string& title : volumes_titles(*told.tree))
                titles.push_back(std::move(title));
        }
        result.bodies.push_back({name, mesh_of(queries, tree), known, pose, tree});
    };
    for (Step step = queries.next(); step != Step::end; step = queries.next())
        if (step == Step::frame && queries.frame() == result.frame) break;
    const std::map<std::uint32_t, std::string> names = names_of(queries);
    for (const auto& [number, body] : queries.bodies()) {
        check_pose(queries, body, path);
        add(names.at(number), body.tree, body.pose);
    }
    if (result.bodies.empty())
        for (const auto& [number, tree] : queries.trees())
            add(tree.name.empty() ? "tree " + std::to_string(number) : tree.name, number, {});
    if (result.bodies.empty())
        throw InputError(path + ": at frame " + std::to_string(result.frame) +
                         " it has no tree yet; name a later one with --frames.");
    result.engine = engine_of(queries, path);
    result.volumes = volumes_of(titles);
    return result;
}

RecordedTrace::RecordedTrace(std::string bytes, const std::string& path, const std::string& bodies,
                             const std::string& frames)
    : path_(path), bytes_(std::move(bytes)), summary_(summary_of(bytes_, path)) {
    scene_ = scene_of_recording(bytes_, path, ChangingMeshes::allowed);
    choose(bodies, frames);
    read_bodies();
    queries_ = std::make_unique<RecordedQueries>(bytes_, path_, summary_);
}

void RecordedTrace::choose(const std::string& bodies, const std::string& frames) {
    std::vector<QueriedPair> pairs;
    RecordedQueries queries(bytes_, path_, summary_);
    for (Step step = queries.next(); step != Step::end; step = queries.next()) {
        if (step != Step::query) continue;
        const auto known = std::find_if(pairs.begin(), pairs.end(), [&](const QueriedPair& pair) {
            return pair.bodies == queries.query_bodies();
        });
        QueriedPair& pair =
            known != pairs.end()
                ? *known
                : pairs.emplace_back(QueriedPair{queries.query_bodies(), {}, 0, {}});
        pair.add(queries.frame(), queries.query());
    }
    if (pairs.empty())
        throw InputError(path_ +
                         ": it has no query; record one with scb_record_query, or see its "
                         "trees with `scb render levels`.");
    const std::map<std::uint32_t, std::string> names = names_of(queries);
    const auto words = [&names](const QueriedPair& pair) {
        return names.at(pair.bodies[0]) + "," + names.at(pair.bodies[1]);
    };
    auto chosen = pairs.begin();
    if (!bodies.empty()) {
        chosen = std::find_if(pairs.begin(), pairs.end(),
                              [&](const QueriedPair& pair) { return words(pair) == bodies; });
        if (chosen == pairs.end() && bodies == "A,B" && pairs.size() == 1) chosen = pairs.begin();
    }
    if (chosen == pairs.end() || (bodies.empty() && pairs.size() > 1)) {
        constexpr std::size_t most = 5;
        std::string known;
        for (std::size_t i = 0; i < std::min(pairs.size(), most); ++i)
            known += (i == 0 ? "" : "; ") + words(pairs[i]);
        if (pairs.size() > most)
            known += "; and " + std::to_string(pairs.size() - most) + " other pairs";
        throw InputError((bodies.empty() ? path_ + ": it has queries of several pairs of bodies"
                                         : "--bodies " + bodies + ": " + path_ +
                                               " has no query of these bodies") +
                         "; name one of its pairs with --bodies (" + known + ").");
    }
    numbers_ = chosen->bodies;
    for (std::size_t side = 0; side < 2; ++side)
        for (std::size_t i = 0; i < scene_.bodies.size(); ++i)
            if (scene_.bodies[i].name == names.at(numbers_[side])) sides_[side] = i;
    frames_ = frames == auto_frames
                  ? std::vector{chosen->fullest}
                  : frames_among(chosen->frames, frames, path_, "a recording may have");
}

bool RecordedTrace::is_wanted(const RecordedQueries& queries) const {
    return queries.query_bodies() == numbers_ &&
           std::binary_search(frames_.begin(), frames_.end(), queries.frame());
}

void RecordedTrace::read_bodies() {
    RecordedQueries queries(bytes_, path_, summary_);
    // By tree and what was told of it.
    std::map<std::tuple<std::uint32_t, int>, std::shared_ptr<const VolumeTree>> trees;
    std::vector<std::string> titles;
    for (Step step = queries.next(); step != Step::end; step = queries.next()) {
        if (step != Step::query || !is_wanted(queries) || bodies_.contains(queries.frame()))
            continue;
        const std::vector<EngineEvent>& events = queries.query().events;
        test_counts_[queries.frame()] = static_cast<std::uint64_t>(std::count_if(
            events.begin(), events.end(),
            [](const EngineEvent& event) { return event.kind == EngineEvent::Kind::volumes; }));
        std::array<BodyAtFrame, 2>& at = bodies_[queries.frame()];
        for (std::size_t side = 0; side < 2; ++side) {
            const BodyState& body = queries.bodies().at(numbers_[side]);
            check_pose(queries, body, path_);
            const TreeState& tree = queries.trees().at(body.tree);
            std::shared_ptr<const VolumeTree>& known = trees[{body.tree, tree.volume_version}];
            if (!known) {
                const EngineSide told = queries.side_of(body.tree);
                known = volume_tree(*told.tree, *told.shape);
                for (std::string& title : volumes_titles(*told.tree))
                    titles.push_back(std::move(title));
            }
            at[side] = {scene_.bodies[sides_[side]].name, mesh_of(queries, body.tree), known,
                        body.pose, body.tree};
        }
    }
    const std::array<BodyAtFrame, 2>& first = bodies_.at(frames_.front());
    header_.source = {path_};
    header_.scene = scene_.name;
    for (std::size_t side = 0; side < 2; ++side)
        header_.bodies[side] = {first[side].name, fingerprint(*first[side].mesh)};
    TraceEngine& engine = header_.engine.emplace();
    engine.name = engine_of(queries, path_);
    engine.volumes = volumes_of(titles);
    std::map<const VolumeTree*, std::uint64_t> hashes;  // lookups only
    for (const auto& [frame, at] : bodies_)
        for (std::size_t side = 0; side < 2; ++side) {
            const auto [hash, added] = hashes.try_emplace(at[side].tree.get());
            if (added) hash->second = tree_hash(*at[side].tree);
            engine.trees[side] = (engine.trees[side] ^ hash->second) * 0x100000001b3;
        }
    const auto are_objects = [](const std::array<BodyAtFrame, 2>& at) {
        return at[0].mesh->triangles.empty() || at[1].mesh->triangles.empty();
    };
    engine.objects = are_objects(first);
    for (const auto& [frame, at] : bodies_)
        if (are_objects(at) != engine.objects)
            throw InputError(path_ +
                             ": a body has triangles at some of these frames, and objects " +
                             "at others such as frame " + std::to_string(frame) +
                             "; name frames of one kind with --frames.");
    for (const RecordedSetting& setting : queries.settings())
        if (setting.key != "engine" && setting.key != "scene" && setting.key != "results")
            engine.settings.push_back({setting.key, setting.value});
    std::vector<std::uint8_t> order = queries.stage_order();
    for (const std::uint8_t number : summary_.stages)
        if (!queries.stages().contains(number)) order.push_back(number);
    // Colors go by numbers: those at which tests ended have the first.
    std::vector<std::uint8_t> used_first = order;
    std::stable_sort(used_first.begin(), used_first.end(), [this](std::uint8_t x, std::uint8_t y) {
        return summary_.stages.contains(x) > summary_.stages.contains(y);
    });
    std::set<std::string> taken = {std::string(stage_name(Stage::overlapping))};
    for (const std::uint8_t number : order) {
        const auto place = std::find(used_first.begin(), used_first.end(), number);
        const auto told = queries.stages().find(number);
        std::string name =
            told != queries.stages().end() ? told->second : "stage " + std::to_string(number);
        // Counts go by names.
        while (!taken.insert(name).second) name += " (" + std::to_string(number) + ")";
        stages_[number] =
            stage_of_engine(static_cast<std::uint8_t>(place - used_first.begin() + 1), name);
        engine.stages.push_back({stages_[number], name});
    }
}

const BodyAtFrame& RecordedTrace::body(std::size_t side, int frame) const {
    return bodies_.at(frame)[side];
}

const TraceFrame& RecordedTrace::frame(int number) {
    while (true) {
        const Step step = queries_->next();
        if (step == Step::end)
            throw InputError(path_ + ": it has no frame " + std::to_string(number) + " any more.");
        if (step == Step::query && queries_->frame() == number && is_wanted(*queries_)) break;
    }
    frame_ = trace_frame(queries_->query(), stages_);
    return frame_;
}

}  // namespace scb::scenes
