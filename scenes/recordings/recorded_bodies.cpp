#include "scenes/recordings/recorded_bodies.h"

#include <algorithm>

#include "core/model/tree.h"
#include "core/platform/number_list.h"
#include "scb/error.h"

namespace scb::scenes {

std::shared_ptr<const Tree> BodyCopies::tree_of(const EngineSide& side, std::uint32_t tree,
                                                int version, const Mat3& stretch) {
    std::array<double, 9> key{};
    std::copy_n(stretch.data(), key.size(), key.begin());
    std::shared_ptr<const Tree>& known = trees_[{tree, version, key}];
    if (known) return known;
    known = std::make_shared<const Tree>(*side.tree, *side.shape);
    for (std::string& title : volumes_titles(*side.tree))
        if (std::find(titles_.begin(), titles_.end(), title) == titles_.end())
            titles_.push_back(std::move(title));
    return known;
}

BodyAtFrame BodyCopies::copy_tree(RecordedQueries& queries, const std::string& name,
                                  std::uint32_t tree) {
    return {name, mesh_of(queries, tree),
            tree_of(queries.side_of(tree), tree, queries.trees().at(tree).volume_version,
                    Mat3::Identity()),
            Pose{}, tree};
}

BodyAtFrame BodyCopies::copy(RecordedQueries& queries, const Recording& recording,
                             std::uint32_t number) {
    const BodyState& body = queries.bodies().at(number);
    if (!body.pose_fault.empty())
        throw InputError(recording.file->path + ": the pose of " +
                         (body.name.empty() ? "a body" : "'" + body.name + "'") + " at frame " +
                         std::to_string(queries.frame()) + " " + body.pose_fault +
                         "; `scb inspect` judges the rest, and --frames names others.");
    return {recording.scene.bodies[recording.bodies.at(number)].name, mesh_of_body(queries, number),
            tree_of(queries.side_of_body(number), body.tree,
                    queries.trees().at(body.tree).volume_version, body.stretch),
            body.pose, body.tree};
}

std::string BodyCopies::volumes() const {
    std::string text;
    for (const std::string& title : titles_) text += (text.empty() ? "" : " and ") + title;
    return text.empty() ? "no volumes" : text;
}

RecordedBodies bodies_at(const Recording& recording, int frame, Moment moment) {
    RecordedQueries queries(*recording.file);
    using Ended = RecordedQueries::Ended;
    RecordedBodies result;
    result.frame = frame;
    BodyCopies copies;
    std::map<std::uint32_t, BodyAtFrame> queried;
    for (Ended ended = queries.next(); ended != Ended::end; ended = queries.next()) {
        if (queries.frame() != frame) continue;
        if (ended == Ended::frame) break;
        if (moment == Moment::end) continue;
        for (const std::uint32_t number : queries.query_bodies())
            if (queries.bodies().contains(number) && !queried.contains(number))
                queried.emplace(number, copies.copy(queries, recording, number));
    }
    for (const auto& [number, body] : queries.bodies()) {
        const auto at = queried.find(number);
        result.bodies.push_back(at != queried.end() ? at->second
                                                    : copies.copy(queries, recording, number));
    }
    if (result.bodies.empty())
        for (const auto& [number, tree] : queries.trees())
            result.bodies.push_back(copies.copy_tree(queries, name_of(tree, number), number));
    if (result.bodies.empty())
        throw InputError(recording.file->path + ": at frame " + std::to_string(frame) +
                         " it has no tree yet; name a later one with --frames.");
    result.volumes = copies.volumes();
    return result;
}

RecordedBodies bodies_at(const Recording& recording, const std::string& frames) {
    const std::vector<int>& all = recording.file->summary.frames;
    const Moment moment = recording.file->selection.empty() ? Moment::end : Moment::first_query;
    if (frames.empty()) return bodies_at(recording, all.front(), moment);
    const std::vector<int> wanted =
        frames_among(all, frames, recording.file->title(), "a recording may have");
    if (wanted.size() != 1)
        throw InputError("--frames " + frames + ": this command takes one frame; give one.");
    return bodies_at(recording, wanted[0], moment);
}

}  // namespace scb::scenes
