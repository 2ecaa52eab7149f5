#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/analysis/trace_diff.h"
#include "core/analysis/trace_words.h"

namespace scb::scenes {

/// A count of two traces, by its name.
struct CountRow {
    std::string name;
    std::uint64_t a, b;
};
/// The rows of two counts in the order of the difference's stages.
std::vector<CountRow> count_rows(const TraceDiff& d, const TraceCounts& a, const TraceCounts& b);

/// How two traces differ, as lines: the parameters that differ, the frames, the counts, the pairs
/// that only one found, and the first test at which they part. Names at most `most` frames
/// of each kind.
std::string trace_diff_text(const TraceDiff& d, const TraceNames& names, std::size_t most = 10);

/// "11 pairs only in the first, 0 pairs only in the second"; empty if both found the same, or if
/// the pairs cannot be compared.
std::string lost_pairs_text(const TraceDiff& d, const TraceNames& names);

/// "frame 8: distance 0.25 of the triangles (17, 4) in the first, 0.5 of (18, 4) in the second";
/// empty if both have the same distance of the same triangles, or are of another kind.
std::string answer_text(const FrameDifference& frame, const TraceNames& names);

}  // namespace scb::scenes
