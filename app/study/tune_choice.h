#pragma once

#include <optional>
#include <vector>

#include "app/study/tune_run.h"

namespace scb::app {

/// The rows that may be recommended, the best first. Leaves out rows that miss pairs, and all but
/// the first of equal rows.
std::vector<std::size_t> best_rows(const std::vector<TuneRow>& all,
                                   const std::vector<Work>& counts);

/// A row that no other is measurably quicker than. Candidates are the rows whose intervals overlap
/// the interval of the least median. Chooses the base if it is one, else the one with the least
/// cost. A single run has no intervals: the quickest.
std::size_t least_time_of(const std::vector<TuneRow>& all, const std::vector<std::size_t>& best);

/// The rows to time: the base, also with the other split, the rows with the least cost, the best
/// row of each volume, and the row with the fewest volume tests.
std::vector<std::size_t> timed_rows(const SceneTuning& tuning);

/// For each volume that can be packed, the row with the fewest volume tests: their cost in a layout
/// differs from the cost in the row.
std::vector<std::size_t> packed_rows(const SceneTuning& tuning);

/// See SceneTuning::quicker_layout.
std::optional<std::size_t> quicker_layout_of(const SceneTuning& tuning);

/// The same, without times.
std::optional<std::size_t> cheaper_layout_of(const SceneTuning& tuning);

}  // namespace scb::app
