#pragma once

#include <map>
#include <string>

#include "core/judge/query_check.h"
#include "scenes/recordings/pose_search.h"

namespace scb::scenes {

// Clauses of which the report of a judgement is made.

/// The names of stages by their numbers.
using StageNames = std::map<std::uint8_t, std::string>;

/// "nodes 3 of A and 4 of B".
/// "nodes do not contain what is below them".
std::string fault_words(TreeFault fault);
std::string pair_words(const std::string& what, std::uint32_t a, std::uint32_t b);
/// "frame 3, left and right".
std::string query_words(const QueryName& query);
/// ", test 12"; empty for no_index.
std::string test_words(std::uint32_t number);
/// "overlap" of stage 0; "stage 5" where it has no name.
std::string stage_words(const StageNames& stages, std::uint8_t stage);
/// "tree 0 \"arm\"".
std::string tree_words(const RecordedQueries& recording, std::uint32_t tree);
/// Why a pair is missed or false, of triangles or of objects.
std::string words_of(const EngineQuery& query, PairCause cause);
/// Which pair that is, and at which nodes and test of volumes, from 0, the problem is.
std::string words_of(const EngineQuery& query, const PairProblem& problem, std::uint32_t test,
                     const StageNames& stages);

}  // namespace scb::scenes
