#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scb {

/// A source file by its path from the project's root, and its text.
struct SourceFile {
    std::string path, text;
};

/// What the `#include` lines of a file break of the rules between rooms: a sentence for each line,
/// "core/fit/fit.cpp:7: core/fit must not include core/collide (scb/collide.h)."
///
/// Of the top folders, core includes none of the others, scenes and render only core, golden all
/// but app. Inside a folder, includes go from a later line of its table to an earlier one; rooms on
/// one line do not know each other. No other room of core includes core/platform. A public header,
/// which belongs to a room although it lies in core/include, includes public headers only.
/// app/study and app/report include no header that prints.
std::vector<std::string> broken_rules(const SourceFile& file);

/// The public headers that belong to no room, and the rooms' headers that are not there.
std::vector<std::string> homeless_headers(const std::vector<std::string>& public_headers);

/// The names, of folders of the top level, that are neither a folder of rooms nor `tests`.
std::vector<std::string> unknown_folders(const std::vector<std::string>& names);

/// The rooms of these source files that no table names: "core/extra" of "core/extra/x.cpp".
std::vector<std::string> unknown_rooms(const std::vector<SourceFile>& files);

}  // namespace scb
