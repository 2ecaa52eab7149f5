#include "tests/peers/peer_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "tests/peers/peers.h"

namespace scb {
namespace {

/// With three digits that count: "0.0791", "1.24", "352".
std::string number(double value) {
    if (!std::isfinite(value)) return "-";
    char text[32];
    const int digits = value >= 100 ? 0 : value >= 10 ? 1 : value >= 1 ? 2 : value >= 0.1 ? 3 : 4;
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

/// With two digits that count and a sign: "24×", "3.2×", "0.41×".
std::string factor(double value) {
    if (!std::isfinite(value)) return "-";
    char text[32];
    const int digits = value >= 10 ? 0 : value >= 1 ? 1 : 2;
    std::snprintf(text, sizeof text, "%.*f×", digits, value);
    return text;
}

using Groups = std::span<const ComparisonGroup>;

std::string titled(const ComparisonGroup& group, const std::string& title,
                   const std::string& separator) {
    return group.title.empty() ? title : group.title + separator + title;
}

/// For each group of scenes, a table of the peers, one column for each scene.
std::string tables(std::span<const PeerKind> kinds, Groups groups, const std::string& title,
                   const std::function<std::string(const SceneComparison&, std::size_t)>& cell) {
    std::string text;
    for (const ComparisonGroup& group : groups) {
        text += "| " + titled(group, title, ", ") + " |";
        std::string rule = "|---|";
        for (const SceneComparison& scene : group.scenes) {
            text += " " + scene.scene + " |";
            rule += "--:|";
        }
        text += "\n" + rule + "\n";
        for (std::size_t p = 0; p < kinds.size(); ++p) {
            text += "| " + kinds[p].title + " |";
            for (const SceneComparison& scene : group.scenes) text += " " + cell(scene, p) + " |";
            text += "\n";
        }
        text += "\n";
    }
    return text;
}

std::string pair_tables(std::span<const PeerKind> kinds, Groups groups, PeerQuery query) {
    const auto cell = [&](const SceneComparison& scene, std::size_t p) -> std::string {
        const PairDifference& difference = scene.peers[p].difference;
        if (kinds[p].name == reference_name)
            return std::to_string(difference.pairs) +
                   (query == PeerQuery::first_contact ? " of " + std::to_string(difference.frames)
                                                      : "");
        if (difference.none()) return "same";
        std::string text;
        if (difference.missing.count > 0) text = "−" + std::to_string(difference.missing.count);
        if (difference.extra.count > 0)
            text += (text.empty() ? "+" : " +") + std::to_string(difference.extra.count);
        return text;
    };
    return tables(kinds, groups,
                  query == PeerQuery::first_contact ? "frames in contact, of those compared"
                                                    : "pairs, of the frames compared",
                  cell);
}

std::string reasons_of(const UnsharedPairs& unshared, const std::string& what) {
    if (unshared.count == 0) return "";
    std::string text = std::to_string(unshared.count) + " " + what;
    const std::size_t others = unshared.count - unshared.degenerate - unshared.close;
    std::string reasons;
    const auto add = [&reasons](std::size_t count, const std::string& reason) {
        if (count == 0) return;
        reasons += (reasons.empty() ? "" : ", ") + std::to_string(count) + " " + reason;
    };
    add(unshared.degenerate, "with a degenerate triangle");
    add(unshared.close, "that barely meet or miss");
    add(others, "for other reasons");
    return text + " (" + reasons + ")";
}

/// A line for each peer and scene whose pairs are others.
std::string difference_list(std::span<const PeerKind> kinds, Groups groups) {
    std::string text;
    for (const ComparisonGroup& group : groups)
        for (const SceneComparison& scene : group.scenes)
            for (std::size_t p = 0; p < kinds.size(); ++p) {
                const PairDifference& difference = scene.peers[p].difference;
                if (difference.none()) continue;
                const std::string missing = reasons_of(difference.missing, "missing"),
                                  extra = reasons_of(difference.extra, "more");
                text += "- " + scene.scene + ", " + kinds[p].title + ": " + missing +
                        (missing.empty() || extra.empty() ? "" : "; ") + extra + ", of " +
                        std::to_string(difference.pairs) + ".\n";
            }
    return text.empty() ? text : text + "\n";
}

std::string time_tables(std::span<const PeerKind> kinds, Groups groups, const std::string& title,
                        std::vector<double> PeerTimes::*times) {
    const std::optional<std::size_t> baseline = find_peer(kinds, baseline_name);
    const auto cell = [&](const SceneComparison& scene, std::size_t p) {
        const PeerTimes& own = scene.peers[p].times;
        std::string text = number(mean_over(own.*times, 1, 1));
        if (!scene.peers[p].difference.none()) text += "*";
        if (own.stride > 1) text += "†";
        if (baseline && *baseline != p) {
            const PeerTimes& other = scene.peers[*baseline].times;
            text +=
                " (" + factor(speedup(own.*times, own.stride, other.*times, other.stride)) + ")";
        }
        return text;
    };
    return tables(kinds, groups, title, cell);
}

std::string build_tables(std::span<const PeerKind> kinds, Groups groups) {
    return tables(
        kinds, groups, "build both trees, ms; bytes per triangle",
        [](const SceneComparison& scene, std::size_t p) {
            const PeerResult& peer = scene.peers[p];
            return number(peer.build_ms) + "; " +
                   (std::isfinite(peer.bytes) ? std::to_string(std::lround(peer.bytes)) : "-");
        });
}

/// How many times as quick as other peers the layouts are: the least and most over the scenes.
std::string summary(std::span<const PeerKind> kinds, const ComparisonGroup& group) {
    const std::vector<SceneComparison>& scenes = group.scenes;
    std::string text;
    for (const std::string& name : {std::string(baseline_name), std::string(reference_name)}) {
        const std::optional<std::size_t> other = find_peer(kinds, name);
        if (!other) continue;
        for (std::size_t p = 0; p < kinds.size(); ++p) {
            if (!kinds[p].own || kinds[p].name == reference_name) continue;
            text += "- " + titled(group, kinds[p].title, ": ") + " against " + kinds[*other].title +
                    ":";
            for (const auto& [times, order] :
                 {std::pair{&PeerTimes::cold, "cold"}, std::pair{&PeerTimes::warm, "warm"}}) {
                double least = INFINITY, most = 0;
                std::string where;
                for (const SceneComparison& scene : scenes) {
                    const PeerTimes &own = scene.peers[p].times,
                                    &others = scene.peers[*other].times;
                    const double by = speedup(own.*times, own.stride, others.*times, others.stride);
                    if (by < least) where = scene.scene;
                    least = std::min(least, by);
                    most = std::max(most, by);
                }
                text += std::string(times == &PeerTimes::cold ? " " : ", ") + order + " " +
                        factor(least) +
                        (scenes.size() > 1 ? " (" + where + ") to " + factor(most) : "");
            }
            text += " as quick.\n";
        }
    }
    return text;
}

std::string summaries(std::span<const PeerKind> kinds, Groups groups) {
    std::string text;
    for (const ComparisonGroup& group : groups) text += summary(kinds, group);
    return text.empty() ? text : text + "\n";
}

/// How many frames were asked for, and which peers were timed in fewer frames.
std::string frame_list(std::span<const PeerKind> kinds, const ComparisonGroup& group) {
    std::string text;
    for (const SceneComparison& scene : group.scenes) {
        text += "- " + scene.scene + ": " + std::to_string(scene.triangles) +
                " triangles, frames " + std::to_string(scene.frames.front()) + " to " +
                std::to_string(scene.frames.back()) + ", " + std::to_string(scene.frames.size()) +
                " of them; pairs compared in " + std::to_string(scene.peers[0].difference.frames);
        for (std::size_t p = 0; p < kinds.size(); ++p)
            if (const PeerTimes& times = scene.peers[p].times; times.stride > 1)
                text += "; " + kinds[p].name + " timed in " + std::to_string(times.warm.size()) +
                        ", " + std::to_string(times.stride) + " apart";
        text += ".\n";
    }
    return text;
}

std::string frame_lists(std::span<const PeerKind> kinds, Groups groups) {
    std::string text;
    for (const ComparisonGroup& group : groups) text += frame_list(kinds, group);
    return text + "\n";
}

/// What the marks in the tables of times mean, where there are any.
std::string marks(Groups groups) {
    bool other_pairs = false, fewer_frames = false;
    for (const ComparisonGroup& group : groups)
        for (const SceneComparison& scene : group.scenes)
            for (const PeerResult& peer : scene.peers) {
                other_pairs |= !peer.difference.none();
                fewer_frames |= peer.times.stride > 1;
            }
    std::string text;
    if (other_pairs) text += "\\* other pairs than the reference's.";
    if (fewer_frames)
        text += std::string(text.empty() ? "" : " ") +
                "† fewer frames; what is in brackets is over those that both took.";
    return text.empty() ? text : text + "\n\n";
}

}  // namespace

std::optional<std::size_t> find_peer(std::span<const PeerKind> kinds, const std::string& name) {
    for (std::size_t p = 0; p < kinds.size(); ++p)
        if (kinds[p].name == name) return p;
    return std::nullopt;
}

std::string peer_tables(std::span<const PeerKind> kinds, std::span<const ComparisonGroup> groups,
                        PeerQuery query) {
    const bool compared = find_peer(kinds, baseline_name).has_value();
    const std::string by = compared ? " (times as quick as FCL)" : "";
    const std::string first = query == PeerQuery::first_contact ? "first contact, " : "";
    std::string text = pair_tables(kinds, groups, query) + difference_list(kinds, groups) +
                       time_tables(kinds, groups, first + "warm, ms" + by, &PeerTimes::warm) +
                       time_tables(kinds, groups, first + "cold, ms" + by, &PeerTimes::cold) +
                       marks(groups) + build_tables(kinds, groups) + summaries(kinds, groups) +
                       frame_lists(kinds, groups);
    if (query == PeerQuery::first_contact)
        text +=
            "Each query ends at the first contact, if the library can; notes on all pairs do not "
            "apply.\n";
    for (const PeerKind& kind : kinds) text += "- " + kind.title + ": " + kind.method + "\n";
    return text;
}

}  // namespace scb
