#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "core/analysis/trace.h"

namespace scb {

/// Counts of one query, or of several together.
struct TraceCounts {
    std::uint64_t pairs = 0, n_v = 0, n_p = 0;
    std::optional<std::uint64_t> n_u;             ///< unknown for other engines
    std::map<std::string, std::uint64_t> stages;  ///< by name, see stage_words; no zeros

    void add(const TraceHeader& header, const QueryTrace& frame);
    /// N_u is compared only if both have it.
    friend bool operator==(const TraceCounts& a, const TraceCounts& b);
};

/// A parameter that differs between two traces. "-" if a trace does not have it.
struct FieldDifference {
    std::string name, a, b;
};

/// The answer of a query for the smallest distance.
struct NearestTriangles {
    double distance = 0;
    IndexPair triangles;
};

/// A common frame that differs.
struct FrameDifference {
    int frame = 0;
    bool poses_differ = false;
    TraceCounts a, b;
    std::uint64_t pairs_only_in_a = 0, pairs_only_in_b = 0;  ///< 0 if pairs are not comparable

    /// Of QueryKind::distance; nothing if the query found no triangles.
    std::optional<NearestTriangles> nearest_a{}, nearest_b{};
    double rounding = 0;  ///< equal distances differ by at most this, see distance_rounding
    bool meshes_differ = false;

    /// Whether the distances differ by more than rounding, or only one query found triangles.
    bool distances_differ() const;
    /// Whether other triangles have this distance. At distance 0, any that intersect are right.
    bool triangles_differ() const;
    bool pairs_differ() const { return pairs_only_in_a + pairs_only_in_b > 0; }
    /// Whether A found pairs and B none.
    bool touches_only_in_a() const { return a.pairs > 0 && b.pairs == 0; }
    bool touches_only_in_b() const { return b.pairs > 0 && a.pairs == 0; }
};

/// A volume test and its context, for users: nodes are numbers, see numbers_of.
struct TracedTest {
    QueryKind kind = QueryKind::collide;
    Step test;
    Stage outcome{};
    std::string stage;  ///< where it ended, see stage_words
    /// The triangle test of two overlapping leaves: the first that hits, else the first.
    std::optional<ItemStep> triangles;
    std::size_t triangle_tests = 0, intersecting = 0;  ///< numbers of triangle tests and of hits
    std::optional<Step> parent;  ///< the test that led to this one; roots have none
    Stage parent_outcome{};
};

/// Where two traces part: the first test that differs, counted from 0, in the first frame that
/// differs.
struct Parting {
    int frame = 0;
    std::size_t test = 0;
    std::optional<TracedTest> a, b;  ///< nothing if that query had already ended
};

/// A pair that one of two queries found and the other did not.
struct LostPair {
    int frame = 0;
    IndexPair pair;            ///< triangles, or numbers of nodes in the query that found it
    bool found_by_a = false;   ///< else by B
    bool other_ended = false;  ///< the other query ended before it was complete
    /// The test by which the other query left out the pair, and its number; its nodes contain the
    /// pair. Nothing if the query had ended before, or has other nodes.
    std::optional<TracedTest> lost_at;
    std::size_t test = 0;
};

/// How two traces differ. A and B are the traces here, not the bodies.
struct TraceDiff {
    /// The number of lost pairs to examine.
    static constexpr std::size_t most_lost = 5;

    QueryKind kind = QueryKind::collide;  ///< of A; two kinds are compared only if both find pairs
    BodyNames bodies;                     ///< as A names them

    std::vector<FieldDifference> asked;
    std::vector<int> only_in_a, only_in_b;  ///< frames
    std::size_t common = 0;                 ///< frames in both
    std::vector<FrameDifference> frames;    ///< of these, frames that differ
    TraceCounts sum_a, sum_b;               ///< over the common frames
    std::vector<std::string> stages;        ///< all stage names of these, in order
    bool nodes_comparable = true;           ///< false if the meshes or the trees differ
    bool meshes_differ = false;
    bool of_engines = false;       ///< whether another engine made one of them
    bool trees_known = true;       ///< false if only one is a recording: a trace has no trees
    std::optional<Parting> first;  ///< of tests; nothing if nodes are not comparable
    bool of_nodes = false;         ///< whether A's pairs are pairs of nodes, see pairs_are_nodes
    /// False if the meshes, the levels to stop at, or the nodes of pairs differ.
    bool pairs_comparable = true;
    std::uint64_t pairs_only_in_a = 0, pairs_only_in_b = 0;
    std::vector<LostPair> lost;  ///< the first of these

    bool equal() const {
        return asked.empty() && only_in_a.empty() && only_in_b.empty() && frames.empty() &&
               pairs_only_in_a == 0 && pairs_only_in_b == 0;
    }
};

/// Returns the frames of a trace one after the other, ascending by number; nullptr at the end. A
/// frame is valid until the next call.
using QueryTraces = std::function<const QueryTrace*()>;

/// Compares the parameters, and then the common frames, even if parameters differ: for two overlap
/// tests on one scene, the question is where they part. Frames differ if poses, counts or tests
/// differ. Node indices do not depend on the volume, so tests are compared for different volumes,
/// too. For different splits, or different trees of other engines, only pairs and counts are
/// compared; for different meshes only counts. Distances are compared up to rounding. Versions of
/// scb are not compared.
///
/// Throws InputError if one finds pairs that intersect, and the other distances or pairs within
/// one.
TraceDiff diff(const TraceHeader& a, const QueryTraces& frames_a, const TraceHeader& b,
               const QueryTraces& frames_b);
TraceDiff diff(const Trace& a, const Trace& b);

/// The volume test `index` of a frame. `outcomes`: outcomes_of the frame.
TracedTest traced_test(const TraceHeader& header, const QueryTrace& frame, const Outcomes& outcomes,
                       std::size_t index);

}  // namespace scb
