#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "scb/pose.h"

namespace scb::golden {

/// The identification of the mesh of a body.
struct RecordedMesh {
    std::int64_t triangles = 0, vertices = 0;
    std::string hash;

    friend bool operator==(const RecordedMesh&, const RecordedMesh&) = default;
};

/// The inputs of a case: NAME.meta.json, which is not compared but shows why counts differ. Values
/// that a record does not have, as in older versions, are empty.
struct CaseRecord {
    std::string command;
    std::map<std::string, RecordedMesh> meshes;        ///< by body
    std::map<int, std::map<std::string, Pose>> poses;  ///< by frame and body: body to world
    std::map<std::string, std::string> settings;       ///< "test": "symmetric", ...
};

/// The settings that a record keeps, and their names for people, in the order of messages.
struct RecordedSetting {
    const char* key;
    const char* name;
};
inline constexpr RecordedSetting recorded_settings[] = {
    {"scene", "scene"},
    {"volume", "volume"},
    {"split", "split"},
    {"growth", "growth of balls"},
    {"margin", "margin"},
    {"test", "overlap test"},
    {"threshold", "threshold"},
    {"descent", "descent rule"},
    {"max_pairs", "most pairs"},
    {"level", "level to stop at"},
    {"order", "order of the search"},
    {"tolerance", "tolerance"},
    {"relative_error", "relative error"},
    {"limit", "limit"},
};

/// The record of a run as JSON, from its index.json or the JSON that it printed. A pose is one text
/// of twelve numbers, [R|t] row by row, so that it is one line of the file.
nlohmann::json record_json(const std::string& command, const nlohmann::json& document);

/// Reads NAME.meta.json; an empty record if there is none. Throws InputError.
CaseRecord read_record(const std::filesystem::path& file);

}  // namespace scb::golden
