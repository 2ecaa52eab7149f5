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
std::vector<CountRow> count_rows(const TraceCounts& a, const TraceCounts& b,
                                 const std::vector<std::string>& stages);

/// How two traces differ, as lines: the parameters that differ, the frames, the counts, the pairs
/// that only one found, and the first test at which they part. Names at most `most` frames
/// of each kind.
std::string trace_diff_text(const TraceDiff& d, const TraceNames& names, std::size_t most = 10);

/// "11 pairs only in the first, 0 pairs only in the second"; empty if both found the same, or if
/// the pairs cannot be compared.
std::string lost_pairs_text(const TraceDiff& d, const TraceNames& names);

}  // namespace scb::scenes
