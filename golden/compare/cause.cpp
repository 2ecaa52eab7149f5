#include "golden/compare/cause.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

#include "core/base/text_format.h"

namespace scb::golden {
namespace {

void add(std::string& sentences, const std::string& sentence) {
    if (sentence.empty()) return;
    sentences += (sentences.empty() ? "" : " ") + sentence;
}

std::string setting_sentences(const CaseRecord& before, const CaseRecord& after) {
    std::string sentences;
    for (const RecordedSetting& setting : recorded_settings) {
        const auto was = before.settings.find(setting.key), is = after.settings.find(setting.key);
        // A setting of only one side belongs to another test or volume, which is named.
        if (was == before.settings.end() || is == after.settings.end()) continue;
        if (was->second == is->second) continue;
        add(sentences, "The " + std::string(setting.name) + " changed: " + is->second +
                           " instead of " + was->second + ".");
    }
    return sentences;
}

std::vector<std::string> words_of(const std::string& command) {
    std::istringstream in(command);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

/// The difference of two commands: the words between their common begin and end, with the name of
/// an option before its value.
std::string command_sentence(const std::string& before, const std::string& after) {
    if (before.empty() || after.empty() || before == after) return "";
    const std::vector<std::string> was = words_of(before), is = words_of(after);
    const std::size_t least = std::min(was.size(), is.size());
    std::size_t start = 0, end = 0;
    while (start < least && was[start] == is[start]) ++start;
    while (end < least - start && was[was.size() - 1 - end] == is[is.size() - 1 - end]) ++end;
    if (start > 0 && was[start - 1].starts_with("--") && start < was.size() - end &&
        start < is.size() - end)
        --start;
    const auto between = [&](const std::vector<std::string>& words) {
        std::string text;
        for (std::size_t i = start; i < words.size() - end; ++i)
            text += (text.empty() ? "" : " ") + words[i];
        return text;
    };
    const std::string old = between(was), now = between(is);
    if (old.empty() && now.empty()) return "";
    if (old.empty()) return "The command changed: `" + now + "` is new.";
    if (now.empty()) return "The command changed: `" + old + "` is gone.";
    return "The command changed: `" + now + "` instead of `" + old + "`.";
}

/// "320 triangles instead of 1,280"
std::string mesh_change(const RecordedMesh& before, const RecordedMesh& after) {
    const auto change = [](std::int64_t was, std::int64_t is, const char* one, const char* many) {
        return counted(static_cast<std::uint64_t>(is), one, many) + " instead of " +
               count_text(static_cast<std::uint64_t>(was));
    };
    if (before.triangles != after.triangles)
        return change(before.triangles, after.triangles, "triangle", "triangles");
    if (before.vertices != after.vertices)
        return change(before.vertices, after.vertices, "vertex", "vertices");
    return "as many triangles and vertices, but not the same";
}

std::string mesh_sentences(const CaseRecord& before, const CaseRecord& after) {
    std::string sentences;
    // Bodies often have one mesh.
    std::vector<std::pair<std::string, std::vector<std::string>>> changes;  // and the bodies that
                                                                            // have them
    for (const auto& [body, mesh] : after.meshes) {
        const auto old = before.meshes.find(body);
        if (old == before.meshes.end() || old->second == mesh) continue;
        const std::string change = mesh_change(old->second, mesh);
        const auto same = std::find_if(changes.begin(), changes.end(),
                                       [&](const auto& c) { return c.first == change; });
        if (same == changes.end())
            changes.push_back({change, {body}});
        else
            same->second.push_back(body);
    }
    for (const auto& [change, bodies] : changes) {
        std::string names = bodies[0];
        for (std::size_t i = 1; i < bodies.size(); ++i)
            names += (i + 1 == bodies.size() ? " and " : ", ") + bodies[i];
        add(sentences, (bodies.size() > 1 ? "The meshes of bodies " : "The mesh of body ") + names +
                           " changed: " + change + ".");
    }
    return sentences;
}

/// Bodies that only one of two records has.
std::string body_sentences(const CaseRecord& before, const CaseRecord& after) {
    std::string sentences;
    if (before.meshes.empty() || after.meshes.empty()) return sentences;
    for (const auto& [body, mesh] : before.meshes)
        if (!after.meshes.contains(body)) add(sentences, "Body " + body + " is gone.");
    for (const auto& [body, mesh] : after.meshes)
        if (!before.meshes.contains(body)) add(sentences, "Body " + body + " is new.");
    return sentences;
}

/// Names frames only if the recorded frames differ from each other.
std::string pose_sentences(const CaseRecord& before, const CaseRecord& after) {
    const auto scene_of = [](const CaseRecord& record) {
        const auto scene = record.settings.find("scene");
        return scene == record.settings.end() ? std::string() : scene->second;
    };
    // Bodies of two scenes have nothing in common except names.
    if (scene_of(before) != scene_of(after)) return "";
    std::map<std::string, std::vector<std::pair<int, std::string>>> motions;  // by body
    for (const auto& [frame, bodies] : after.poses) {
        const auto old = before.poses.find(frame);
        if (old == before.poses.end()) continue;
        for (const auto& [body, pose] : bodies)
            if (const auto was = old->second.find(body); was != old->second.end())
                motions[body].emplace_back(frame, motion_words(was->second, pose));
    }
    std::string sentences;
    for (const auto& [body, frames] : motions) {
        const auto first = std::find_if(frames.begin(), frames.end(),
                                        [](const auto& frame) { return !frame.second.empty(); });
        if (first == frames.end()) continue;
        const bool alike = std::all_of(frames.begin(), frames.end(), [&](const auto& frame) {
            return frame.second == first->second;
        });
        const std::string frame =
            alike ? "" : "In frame " + std::to_string(first->first) + ", body ";
        add(sentences, (alike ? "Body " : frame) + body + " " + first->second + ".");
    }
    return sentences;
}

}  // namespace

Cause cause_of(const CaseRecord& before, const CaseRecord& after) {
    Cause cause;
    cause.has_settings = !before.settings.empty() && !after.settings.empty();
    cause.sentences = setting_sentences(before, after);
    const std::string meshes = mesh_sentences(before, after);
    cause.other_meshes = !meshes.empty();
    add(cause.sentences, meshes);
    add(cause.sentences, body_sentences(before, after));
    add(cause.sentences, pose_sentences(before, after));
    // Older baselines, which have no settings, may spell the same command differently.
    if (cause.sentences.empty() && cause.has_settings)
        cause.sentences = command_sentence(before.command, after.command);
    return cause;
}

namespace {

constexpr double degrees_per_radian = 57.29577951308232;
constexpr double rounding = 1e-6;

}  // namespace

std::string motion_words(const Pose& before, const Pose& after) {
    const Vec3 moved = after.translation - before.translation;
    // The matrices of two rotations an angle t apart are 2 sqrt(2) sin(t / 2) apart. Unlike the arc
    // cosine of a trace, this is exact for small angles.
    const double apart = (after.rotation - before.rotation).norm();
    const double angle = 2 * std::asin(std::min(1.0, apart / std::sqrt(8.0)));
    const double largest = std::max(moved.cwiseAbs().maxCoeff(), angle);
    std::string lengths;
    for (int axis = 0; axis < 3; ++axis)
        if (moved[axis] != 0 && std::abs(moved[axis]) > rounding * largest)
            lengths +=
                (lengths.empty() ? "" : ", ") + format("%.4g along ", moved[axis]) + "xyz"[axis];
    std::string turn;
    if (angle != 0 && angle > rounding * largest) turn = format("%.4g", angle * degrees_per_radian);
    if (!turn.empty()) turn += turn == "1" ? " degree" : " degrees";
    if (lengths.empty()) return turn.empty() ? "" : "turned: " + turn;
    return "moved: " + lengths + (turn.empty() ? "" : ", " + turn);
}

}  // namespace scb::golden
