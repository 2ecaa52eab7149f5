#pragma once

#include <string>

#include "core/analysis/trace_diff.h"

namespace scb {

/// The names of the two traces, to follow "the".
struct TraceNames {
    std::string a = "first", b = "second";
};

/// The outcome of a test and what it led to: "rejected at slab-cylinder", "overlap, passed on to
/// the children of arm's node", "overlap; their triangles (17, 4) intersect", ...
std::string words_of(const TracedTest& test, const BodyNames& bodies);

/// "the nodes (12, 33) at depths (4, 5)".
std::string words_of(const Step& test);

/// "reached from the nodes (5, 33) at depths (3, 5), where arm's node was divided", or "both nodes
/// were"; or "these are the roots".
std::string words_of_parent(const TracedTest& test, const BodyNames& bodies);

/// Three or four lines with line ends: the place, the test of the first trace, the test of the
/// second, and the tests that led there.
std::string words_of(const Parting& parting, const BodyNames& bodies, const TraceNames& names = {});

/// "frame 8, the triangles (17, 4): the second left them out at test 2287, the nodes (20475, 3792)
/// at depths (12, 11): rejected at ball-slab". `of_nodes`: whether the pair is a pair of nodes.
std::string words_of(const LostPair& lost, bool of_nodes, const BodyNames& bodies,
                     const TraceNames& names = {});

}  // namespace scb
