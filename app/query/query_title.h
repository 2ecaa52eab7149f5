#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/study/scene_query.h"

namespace scb::app {

/// Whether the queries are of several pairs of bodies.
bool is_of_many(const SceneQuery& query);
/// The name of one of the scene's bodies.
const std::string& body_name(const SceneQuery& query, std::size_t body);
/// The chosen bodies: "pin and bracket".
std::string pair_words(const SceneQuery& query);

/// The scene, its bodies with their sizes, and the volumes: the start of a title.
std::string bodies_title(const SceneQuery& query);

/// The same as JSON: "version", "scene", "source", "bodies" and "volume".
nlohmann::ordered_json bodies_json(const SceneOptions& scene, const SceneQuery& query);
/// The names of the chosen bodies, as JSON.
nlohmann::ordered_json pair_json(const SceneQuery& query);
/// How hierarchies are built, as JSON.
nlohmann::ordered_json build_json(const BuildOptions& build);

}  // namespace scb::app
