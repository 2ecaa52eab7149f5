#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/query/level_trees.h"
#include "app/query/query_sources.h"

namespace scb::app {

/// Hierarchies that stand beside others on a page, one per body, and the queries of two of them.
struct ViewColumn {
    std::string title;
    const scenes::Scene* scene = nullptr;
    std::vector<std::size_t> places;          ///< of the bodies, in Scene::bodies
    std::vector<scenes::BodyAtFrame> bodies;  ///< at the frame that is shown first
    QuerySource* query = nullptr;             ///< of the first two bodies; null: none
    std::vector<std::string> names;           ///< of the scene on a command line
    std::string kind;  ///< as --volume names it; empty of what another engine recorded
    std::vector<std::string> verdict;  ///< on the recorded frame, see verdict_lines; or empty
    std::string explain;  ///< the command that explains a test, but for frame and pair; or empty

    bool is_recorded() const { return kind.empty(); }
};

/// What there is to be seen.
struct ViewSubject {
    std::vector<ViewColumn> columns;
    std::vector<int> frames;  ///< that all columns have poses at
    int frame = 0;            ///< of these, the one that is shown first
    int deepest = 0;          ///< level of all trees
    bool same_nodes = true;   ///< whether a node's index means the same in all columns
    // What the columns refer to.
    std::vector<std::unique_ptr<LevelSubject>> levels;
    std::vector<std::unique_ptr<QuerySources>> sources;
};

/// What a page is made of.
struct ViewSources {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    QueryOptions query;            ///< its frames are those below
    std::string queries = "auto";  ///< frames whose query is wanted; auto: the one that is shown
                                   ///< first, of a trace all; none
    CompareOptions compare;
};

/// One column per kind of volumes, or per query that is compared, or for each of two scenes these.
/// Throws InputError.
ViewSubject view_subject(const ViewSources& asked, const Console& console);

}  // namespace scb::app
