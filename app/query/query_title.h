#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
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
/// How hierarchies are built, as JSON.
nlohmann::ordered_json build_json(const BuildOptions& build);

/// The first line of a CSV file of pairs of triangles, or of nodes of a level.
std::string pair_lines_header(const SceneQuery& query);
/// A line for each of these pairs of the chosen bodies.
std::string pair_lines(const SceneQuery& query, int frame, std::span<const IndexPair> pairs);

}  // namespace scb::app
