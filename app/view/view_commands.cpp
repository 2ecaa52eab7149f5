#include "app/view/view_commands.h"

#include <algorithm>

#include "app/cli/command_text.h"
#include "scenes/recordings/recording_input.h"

namespace scb::app {
namespace {

using ColumnList = std::vector<const ViewColumn*>;

std::string words_of(const std::vector<std::string>& names) {
    std::string words;
    for (const std::string& name : names) words += " " + file_word(name);
    return words;
}

bool is_traced(const ViewColumn& column) { return scenes::names_trace(column.names[0]); }
/// Whether the file has the query's parameters.
bool is_from_file(const ViewColumn& column) { return column.is_recorded() || is_traced(column); }

/// The names for commands: a file may be elsewhere when the command is run.
std::string names_of(const ViewOptions& options, const ViewColumn& column) {
    std::vector<std::string> names = column.names;
    const std::vector<std::string>& known = options.level.scene.names;
    for (std::string& name : names)
        for (std::size_t i = 0; i < known.size() && i < options.names_in_commands.size(); ++i)
            if (name == known[i]) name = options.names_in_commands[i];
    return words_of(names);
}

bool shows_distances(const ViewColumn& column) {
    return column.query && is_of_distance(column.query->header().kind);
}

bool compares_tests(const ViewOptions& options) {
    return overlap_test_of(options.compare.substr(0, options.compare.find(','))).has_value();
}

std::string test_words(const ViewOptions& options, const ViewColumn& column) {
    if (!compares_tests(options)) return options.tests;
    return " --test " + std::string(overlap_test_name(column.query->query().options.overlap.test));
}

/// The words for the query of one column, without frames and descent.
std::string query_words(const ViewOptions& options, const ViewColumn& column) {
    const std::string words = names_of(options, column) + options.scene + options.bodies;
    if (is_from_file(column)) return words;
    return words + " --volume " + column.kind + options.hierarchies + test_words(options, column);
}

/// The same for a picture of one or two columns' queries; empty for more columns.
std::string queries_words(const ViewOptions& options, const ColumnList& columns) {
    const ViewColumn &first = *columns.front(), &last = *columns.back();
    if (columns.size() == 1) return query_words(options, first);
    if (columns.size() > 2) return "";
    if (first.names != last.names)
        return names_of(options, first) + names_of(options, last) + options.scene + options.bodies;
    const bool kinds = options.compare.empty();
    return names_of(options, first) + options.scene + options.bodies + " --compare " +
           (kinds ? first.kind + "," + last.kind : options.compare) + options.hierarchies +
           (compares_tests(options) ? "" : options.tests);
}

/// Commands for pictures of levels: one per scene, with all its kinds of volumes.
std::vector<std::string> level_commands(const ViewOptions& options, const ColumnList& columns) {
    std::vector<std::pair<std::string, std::vector<std::string>>> scenes;  // and their volumes
    for (const ViewColumn* column : columns) {
        const std::string words = (is_traced(*column) ? words_of(column->query->header().source)
                                                      : names_of(options, *column)) +
                                  options.scene + (column->is_recorded() ? " " : "");
        auto scene = std::find_if(scenes.begin(), scenes.end(),
                                  [&words](const auto& known) { return known.first == words; });
        if (scene == scenes.end()) scene = scenes.insert(scene, {words, {}});
        std::vector<std::string>& kinds = scene->second;
        if (!column->is_recorded() &&
            std::find(kinds.begin(), kinds.end(), column->kind) == kinds.end())
            kinds.push_back(column->kind);
    }
    std::vector<std::string> commands;
    for (auto& [words, kinds] : scenes) {
        if (words.ends_with(' ')) words.pop_back();
        std::string volumes;
        for (const std::string& kind : kinds)
            volumes += (volumes.empty() ? " --volume " : ",") + kind;
        commands.push_back("scb render levels" + words + volumes +
                           (kinds.empty() ? "" : options.hierarchies) + options.levels);
    }
    return commands;
}

/// The columns of each picture of queries: all columns, or the columns of each scene.
std::vector<ColumnList> compared(const ViewOptions& options, const ColumnList& all) {
    const bool scenes = options.has_two_scenes();
    std::vector<ColumnList> groups;
    for (const ViewColumn* column : all) {
        if (!column->query) continue;
        if (groups.empty() || (scenes && groups.back().front()->names != column->names))
            groups.emplace_back();
        groups.back().push_back(column);
    }
    return groups;
}

}  // namespace

std::map<std::string, std::vector<std::string>> view_commands(const ViewOptions& options,
                                                              const ViewSubject& subject) {
    std::map<std::string, std::vector<std::string>> commands;
    if (options.level.scene.recorded)
        commands["verdicts"] = {"scb inspect" + options.of_packed + options.layout};
    if (options.level.scene.given) return commands;
    ColumnList all;
    for (const ViewColumn& column : subject.columns) all.push_back(&column);
    commands["levels"] = level_commands(options, all);
    for (const ColumnList& columns : compared(options, all)) {
        if (shows_distances(*columns.front())) {
            for (const ViewColumn* column : columns) {
                const std::string own = query_words(options, *column) + options.distances;
                // A trace has its kind.
                const bool of_file = is_from_file(*column);
                if (!of_file) commands["pairs"].push_back("scb render distance" + own);
                commands["traversal"].push_back("scb render traversal" + own +
                                                (of_file ? "" : " --kind distance"));
            }
            continue;
        }
        const std::string words = queries_words(options, columns);
        for (const auto& [mode, picture] : {std::pair{"rejections", "rejections"},
                                            {"pairs", "pairs"},
                                            {"tests", "pairs --heat volumes"},
                                            {"wasted", "pairs --heat wasted"}})
            if (!words.empty())
                commands[mode].push_back(std::string("scb render ") + picture + words +
                                         options.descent);
        // Each of these pictures shows one query.
        for (const ViewColumn* column : columns) {
            const std::string own = query_words(options, *column) + options.descent;
            commands["traversal"].push_back("scb render traversal" + own);
            commands["verdicts"].push_back("scb inspect" + own);
        }
    }
    return commands;
}

std::string explain_command(const ViewOptions& options, const ViewColumn& column) {
    if (column.query && options.level.scene.recorded) return "scb explain" + options.of_packed;
    if (!column.query || column.is_recorded() || options.level.scene.given ||
        shows_distances(column))
        return "";
    return "scb explain" + query_words(options, column);
}

}  // namespace scb::app
