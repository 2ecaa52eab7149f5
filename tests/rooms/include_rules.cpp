#include "tests/rooms/include_rules.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>

namespace scb {
namespace {

using Floors = std::vector<std::vector<std::string>>;

// From the ground up.
const Floors folders = {{"core"}, {"scenes", "render"}, {"golden"}, {"app"}};

const std::map<std::string, Floors> rooms = {
    // core/include: scb_record.h alone, which includes no other header of core. The headers in
    // core/include/scb belong to the rooms of public_headers. core/platform: see may_include.
    {"core",
     {{"include"},
      {"base"},
      {"geometry", "volumes"},
      {"platform"},
      {"fit", "overlap"},
      {"hierarchy"},
      {"explain", "traverse"},
      {"collide"},
      {"distance"},
      {"packed"},
      {"model"},
      {"analysis"},
      {"judge"}}},
    {"scenes", {{"shapes"}, {"meshes"}, {"scene"}, {"recordings"}}},
    {"render", {{"gl", "files"}, {"view"}, {"overlay"}, {"plots", "draw"}, {"figures"}, {"web"}}},
    {"golden", {{"suite"}, {"compare"}, {"report", "run"}}},
    {"app",
     {{"report"},
      {"study", "cli"},
      {"shards"},
      {"query", "reference"},
      {"pictures", "config"},
      {"timing", "explain", "merge", "distance"},
      {"view"},
      {"golden"},
      {"inspect"},
      {"python"}}},
};

// To which room of core a public header belongs.
const std::map<std::string, std::vector<std::string>> public_headers = {
    {"base", {"vec", "pose", "error", "simd_level"}},
    {"geometry", {"mesh", "triangle_distance", "triangle_overlap"}},
    {"volumes",
     {"scb", "scb2", "ball", "obb", "aabb", "convex", "fit_points", "kdop", "rss", "capsule",
      "volume", "placement"}},
    {"fit", {"fit"}},
    {"overlap", {"stage", "step", "overlap_options", "overlap"}},
    {"hierarchy", {"topology", "hierarchy", "any_hierarchy", "level_cover"}},
    {"traverse", {"observer", "step_recorder"}},
    {"collide", {"collide", "any_collide"}},
    {"distance", {"distance", "any_distance"}},
    {"packed",
     {"packed_scb", "packed_scb2", "node_codec", "packed_layout", "packed_hierarchy",
      "packed_front", "packed_collide", "packed_distance", "any_packed"}},
};

std::optional<std::size_t> floor_of(const Floors& floors, const std::string& room) {
    for (std::size_t i = 0; i < floors.size(); ++i)
        if (std::find(floors[i].begin(), floors[i].end(), room) != floors[i].end()) return i;
    return std::nullopt;
}

struct Place {
    std::string folder, room;  ///< room: empty for what lies in the folder itself
    bool is_public = false;
};

std::string room_of_public_header(const std::string& name) {
    for (const auto& [room, headers] : public_headers)
        if (std::find(headers.begin(), headers.end(), name) != headers.end()) return room;
    return {};
}

/// Where a path is, if in one of the folders: "core/fit/fit.h", "scb/fit.h".
std::optional<Place> place_of(std::string path) {
    for (const std::string_view start : {"core/include/scb/", "scb/"})
        if (path.starts_with(start)) {
            path.erase(0, start.size());
            return Place{"core", room_of_public_header(path.substr(0, path.find('.'))), true};
        }
    const std::size_t slash = path.find('/');
    if (slash == std::string::npos) return std::nullopt;
    Place place{path.substr(0, slash), "", false};
    if (!floor_of(folders, place.folder)) return std::nullopt;
    if (const std::size_t next = path.find('/', slash + 1); next != std::string::npos)
        place.room = path.substr(slash + 1, next - slash - 1);
    return place;
}

std::string name_of(const Place& place) {
    return place.room.empty() ? place.folder : place.folder + "/" + place.room;
}

bool prints(const std::string& header) {
    const std::set<std::string> known = {"cstdio", "fstream", "iostream", "ostream",
                                         "print",  "stdio.h", "unistd.h"};
    return known.contains(header);
}

bool may_include(const Place& from, const Place& to) {
    if (from.is_public && !to.is_public) return false;
    if (from.folder != to.folder)
        return *floor_of(folders, from.folder) > *floor_of(folders, to.folder);
    // What lies in the folder itself, app/main.cpp, may see all of it.
    if (from.room == to.room || from.room.empty()) return true;
    // Files and processes are for the other folders: the installed library uses neither.
    if (to.room == "platform") return false;
    const Floors& floors = rooms.at(from.folder);
    const std::optional<std::size_t> above = floor_of(floors, from.room),
                                     below = floor_of(floors, to.room);
    return above && below && *above > *below;
}

/// Whether the files at a place return values and print nothing.
bool returns_values(const Place& place) {
    return place.folder == "app" && (place.room == "study" || place.room == "report");
}

}  // namespace

std::vector<std::string> broken_rules(const SourceFile& file) {
    const std::optional<Place> from = place_of(file.path);
    std::vector<std::string> broken;
    if (!from) return broken;
    std::istringstream lines(file.text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        if (!line.starts_with("#include ")) continue;
        const std::size_t first = line.find_first_of("\"<"), last = line.find_last_of("\">");
        if (first == std::string::npos || last <= first) continue;
        const std::string included = line.substr(first + 1, last - first - 1);
        const std::optional<Place> to = place_of(included);
        if (to && !may_include(*from, *to))
            broken.push_back(file.path + ":" + std::to_string(number) + ": " +
                             (from->is_public ? "a public header of " : "") + name_of(*from) +
                             " must not include " + name_of(*to) + " (" + included + ").");
        if (returns_values(*from) && prints(included))
            broken.push_back(file.path + ":" + std::to_string(number) + ": " + name_of(*from) +
                             " must not print (" + included + ").");
    }
    return broken;
}

std::vector<std::string> homeless_headers(const std::vector<std::string>& names) {
    std::vector<std::string> odd;
    for (const std::string& name : names)
        if (room_of_public_header(name).empty()) odd.push_back("scb/" + name + ".h has no room.");
    for (const auto& [room, headers] : public_headers)
        for (const std::string& name : headers)
            if (std::find(names.begin(), names.end(), name) == names.end())
                odd.push_back("scb/" + name + ".h of core/" + room + " is not there.");
    return odd;
}

std::vector<std::string> unknown_folders(const std::vector<std::string>& names) {
    std::vector<std::string> unknown;
    for (const std::string& name : names)
        if (name != "tests" && !floor_of(folders, name)) unknown.push_back(name);
    return unknown;
}

std::vector<std::string> unknown_rooms(const std::vector<SourceFile>& files) {
    std::set<std::string> unknown;
    for (const SourceFile& file : files) {
        const std::optional<Place> place = place_of(file.path);
        // homeless_headers looks at public headers.
        if (place && !place->is_public && !place->room.empty() &&
            !floor_of(rooms.at(place->folder), place->room))
            unknown.insert(name_of(*place));
    }
    return {unknown.begin(), unknown.end()};
}

}  // namespace scb
