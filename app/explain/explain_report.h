#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/study/explained_pair.h"

namespace scb::app {

/// The explanation as several lines of text; `colored`: marks errors with the escape codes of a
/// terminal.
std::string explanation_text(const ExplainedPair& pair, bool colored);

/// Parts of it: both volumes, on several lines; the certificate; the verdict on the answer.
std::string volumes_text(const ExplainedPair& pair);
std::string exact_text(const ExplainedPair& pair);
std::string answer_text(Answer answer, bool colored);

/// The same in machine form, with all digits: `stage` (per test), `exact`, `answer`, `steps`, ...
nlohmann::ordered_json explanation_json(const ExplainedPair& pair);

/// Parts of it: `certificate`, null if the volumes touch; and `a`, `b`, `pose`, `b_in_a` and
/// `center_distance`, which are added to `json`.
nlohmann::ordered_json certificate_json(const ExplainedPair& pair);
void add_volumes_json(nlohmann::ordered_json& json, const ExplainedPair& pair);

/// JSON as text: on one line (`indent` -1) or on several.
std::string json_text(const nlohmann::ordered_json& json, int indent);

/// "A 412, B 97"; empty for raw volumes.
std::string node_names(const ExplainedPair& pair);

/// Titles of a scene and two of its nodes, without repeated names. The scene is empty if it is
/// named after both bodies, and "cheese with itself" if they are one mesh.
struct PairNames {
    std::string scene, nodes;
};
PairNames pair_names(const std::string& scene, const ExplainedPair& pair);

}  // namespace scb::app
