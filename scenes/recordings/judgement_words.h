#pragma once

#include <map>
#include <string>

#include "core/judge/query_check.h"
#include "scenes/recordings/pose_search.h"

namespace scb::scenes {

// Clauses for the report of a judgement.

/// The names of stages by their numbers.
using StageNames = std::map<std::uint8_t, std::string>;

/// "nodes do not contain what is below them".
std::string fault_words(TreeFault fault);
/// "nodes 3 of A and 4 of B".
std::string pair_words(const std::string& what, std::uint32_t a, std::uint32_t b);
/// "frame 3, left and right", and the query's name in quotes: "frame 3, arm and shelf ("lift")".
std::string query_words(const QueryName& query);
/// ", test 12"; empty for no_index.
std::string test_words(std::uint32_t number);
/// "overlap" for stage 0; "stage 5" if the stage has no name.
std::string stage_words(const StageNames& stages, std::uint8_t stage);
/// "tree 0 \"arm\"".
std::string tree_words(const RecordedQueries& recording, std::uint32_t tree);
/// Whether the query measures distances.
bool is_of_distance(const EngineQuery& query);
/// "the distance that was found is too large".
std::string fault_words(AnswerFault fault);
/// The numbers of a wrong answer, and what explains it.
std::string words_of(const AnswerProblem& problem);
/// Why a pair of triangles or objects was missed or wrongly reported.
std::string words_of(const EngineQuery& query, PairCause cause);
/// The pair of a problem, with its nodes and its test of volumes, counted from 0.
std::string words_of(const EngineQuery& query, const PairProblem& problem, std::uint32_t test,
                     const StageNames& stages);

}  // namespace scb::scenes
