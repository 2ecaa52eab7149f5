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
    std::optional<std::uint64_t> n_u;             ///< other engines do not tell
    std::map<std::string, std::uint64_t> stages;  ///< by name, see stage_words; those that occur

    void add(const TraceHeader& header, const TraceFrame& frame);
    /// Where one does not tell N_u, it is not compared.
    friend bool operator==(const TraceCounts& a, const TraceCounts& b);
};

/// Something asked of one trace but not of the other. A value is "-" where it was not asked.
struct FieldDifference {
    std::string name, a, b;
};

/// A frame in both traces that is not the same in them.
struct FrameDifference {
    int frame = 0;
    bool poses_differ = false;
    TraceCounts a, b;
};

/// A volume test and what it belongs to, for users: nodes are the numbers that numbers_of has.
struct TracedTest {
    Step test;
    Stage outcome{};
    std::string stage;  ///< where it ended, see stage_words
    /// Of two leaves that overlap; of several the first that intersect, else the first.
    std::optional<ItemStep> triangles;
    std::size_t triangle_tests = 0, intersecting = 0;  ///< how many there are of them
    std::optional<Step> parent;  ///< of the pair whose division led here; the roots
                                 ///< have none
    Stage parent_outcome{};
};

/// Where two traces part: the same frame and the same test, counted from 0, before which all tests
/// of the frame, and all frames before it, were the same.
struct Parting {
    int frame = 0;
    std::size_t test = 0;
    std::optional<TracedTest> a, b;  ///< nothing where that query had already ended
};

/// A pair that one of two queries found and the other did not.
struct LostPair {
    int frame = 0;
    IndexPair pair;            ///< one of nodes by their numbers, as who found it has them
    bool found_by_a = false;   ///< else by B
    bool other_ended = false;  ///< the other query had its pairs before it was through
    /// The test by which the other query left it out, and its number: what that test was about
    /// contains the pair. Nothing where it had ended before, or has other nodes.
    std::optional<TracedTest> lost_at;
    std::size_t test = 0;
};

/// How two traces differ. A and B are the traces here, not the bodies.
struct TraceDiff {
    /// So many of the pairs that only one of them found are looked into.
    static constexpr std::size_t most_lost = 5;

    BodyNames bodies;  ///< as A names them

    std::vector<FieldDifference> asked;
    std::vector<int> only_in_a, only_in_b;  ///< frames
    std::size_t common = 0;                 ///< frames that are in both
    std::vector<FrameDifference> frames;    ///< of these, those that differ
    TraceCounts sum_a, sum_b;               ///< over the common frames
    std::vector<std::string> stages;        ///< all names of these, in order
    bool nodes_comparable = true;           ///< false where the meshes or the splits differ
    bool meshes_differ = false;
    bool of_engines = false;       ///< whether another engine made one of them
    std::optional<Parting> first;  ///< of tests; nothing where nodes are not comparable
    bool of_nodes = false;  ///< whether pairs are of nodes: a level to stop at was asked of A
    bool pairs_comparable = true;  ///< false where meshes, or levels to stop at, or the nodes that
                                   ///< pairs are of, differ
    std::uint64_t pairs_only_in_a = 0, pairs_only_in_b = 0;
    std::vector<LostPair> lost;  ///< of these, the first ones

    bool equal() const {
        return asked.empty() && only_in_a.empty() && only_in_b.empty() && frames.empty() &&
               pairs_only_in_a == 0 && pairs_only_in_b == 0;
    }
};

/// Gives a trace's frames one after the other, ascending by number; nullptr at the end. A frame
/// need not live longer than until the next call.
using TraceFrames = std::function<const TraceFrame*()>;

/// Compares what was asked, and then the frames that are in both, also where something else was
/// asked: two overlap tests on one scene part somewhere, and where is the question. Frames differ
/// where poses, counts or tests do. Indices of nodes depend on the mesh alone, so tests are
/// compared for different volumes too, but not for different splits, nor for trees of other engines
/// that are not alike, where pairs and counts are
/// compared, nor for different meshes, where counts are. The versions of scb are not compared.
TraceDiff diff(const TraceHeader& a, const TraceFrames& frames_a, const TraceHeader& b,
               const TraceFrames& frames_b);
TraceDiff diff(const Trace& a, const Trace& b);

/// The volume test `index` of a frame. `tree` is outcomes_of's.
TracedTest traced_test(const TraceHeader& header, const TraceFrame& frame, const Outcomes& outcomes,
                       std::size_t index);

}  // namespace scb
