#include "scenes/recordings/recorded_bodies.h"

#include <algorithm>

#include "core/judge/engine_tree.h"
#include "scb/error.h"
#include "scenes/text/number_list.h"

namespace scb::scenes {

BodyAtFrame BodyCopies::copy(RecordedQueries& queries, const std::string& name, std::uint32_t tree,
                             const Pose& pose) {
    std::shared_ptr<const VolumeTree>& known =
        trees_[{tree, queries.trees().at(tree).volume_version}];
    if (!known) {
        const EngineSide told = queries.side_of(tree);
        known = volume_tree(*told.tree, *told.shape);
        for (std::string& title : volumes_titles(*told.tree))
            if (std::find(titles_.begin(), titles_.end(), title) == titles_.end())
                titles_.push_back(std::move(title));
    }
    return {name, mesh_of(queries, tree), known, pose, tree};
}

BodyAtFrame BodyCopies::copy(RecordedQueries& queries, const Recording& recording,
                             std::uint32_t body) {
    const BodyState& told = queries.bodies().at(body);
    if (!told.is_rigid())
        throw InputError(
            recording.path + ": the pose of " +
            (told.name.empty() ? "a body" : "'" + told.name + "'") + " at frame " +
            std::to_string(queries.frame()) +
            " is not rigid; `scb inspect` judges the rest, and --frames names others.");
    return copy(queries, recording.scene.bodies[recording.bodies.at(body)].name, told.tree,
                told.pose);
}

std::string BodyCopies::volumes() const {
    std::string text;
    for (const std::string& title : titles_) text += (text.empty() ? "" : " and ") + title;
    return text.empty() ? "no volumes" : text;
}

RecordedBodies bodies_at(const Recording& recording, int frame) {
    RecordedQueries queries(recording.bytes, recording.path, recording.summary);
    using Step = RecordedQueries::Step;
    for (Step step = queries.next(); step != Step::end; step = queries.next())
        if (step == Step::frame && queries.frame() == frame) break;
    RecordedBodies result;
    result.frame = frame;
    BodyCopies copies;
    for (const auto& [number, body] : queries.bodies())
        result.bodies.push_back(copies.copy(queries, recording, number));
    if (result.bodies.empty())
        for (const auto& [number, tree] : queries.trees())
            result.bodies.push_back(copies.copy(queries, name_of(tree, number), number, {}));
    if (result.bodies.empty())
        throw InputError(recording.path + ": at frame " + std::to_string(frame) +
                         " it has no tree yet; name a later one with --frames.");
    result.volumes = copies.volumes();
    return result;
}

RecordedBodies bodies_at(const Recording& recording, const std::string& frames) {
    const std::vector<int>& all = recording.summary.frames;
    if (frames.empty()) return bodies_at(recording, all.front());
    const std::vector<int> wanted =
        frames_among(all, frames, recording.path, "a recording may have");
    if (wanted.size() != 1)
        throw InputError("--frames " + frames + ": this command takes one frame; give one.");
    return bodies_at(recording, wanted[0]);
}

}  // namespace scb::scenes
