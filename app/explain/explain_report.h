#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/explain/explained_pair.h"

namespace scb::app {

/// The explanation for a reader, several lines; `colored`: with the escape codes of a terminal for
/// what is wrong.
std::string explanation_text(const ExplainedPair& pair, bool colored);

/// Parts of it: both volumes, on several lines; the certificate; what the answer is worth.
std::string volumes_text(const ExplainedPair& pair);
std::string exact_text(const ExplainedPair& pair);
std::string answer_text(Answer answer, bool colored);

/// The same in machine form, with all digits: `stage` (per test), `exact`, `answer`, `steps`, ...
nlohmann::ordered_json explanation_json(const ExplainedPair& pair);

/// Parts of it: `certificate`, null where the volumes touch; and `a`, `b`, `pose`, `b_in_a` and
/// `center_distance`, which are added to `json`.
nlohmann::ordered_json certificate_json(const ExplainedPair& pair);
void add_volumes_json(nlohmann::ordered_json& json, const ExplainedPair& pair);

/// JSON as text: on one line (`indent` -1) or on several.
std::string json_text(const nlohmann::ordered_json& json, int indent);

/// "A 412, B 97"; empty for raw volumes.
std::string node_names(const ExplainedPair& pair);

/// What a title calls a scene and two of its nodes, so that no name is there twice: the scene is
/// empty where it is named after both bodies, "cheese with itself" where they are one mesh.
struct PairNames {
    std::string scene, nodes;
};
PairNames pair_names(const std::string& scene, const ExplainedPair& pair);

}  // namespace scb::app
