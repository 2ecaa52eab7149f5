#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/explain/explained_pair.h"

namespace scb::app {

/// The explanation for a reader, several lines; `colored`: with the escape codes of a terminal for
/// what is wrong.
std::string explanation_text(const ExplainedPair& pair, bool colored);

/// The same in machine form, with all digits: `stage` (per test), `exact`, `answer`, `steps`, ...
nlohmann::ordered_json explanation_json(const ExplainedPair& pair);

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
