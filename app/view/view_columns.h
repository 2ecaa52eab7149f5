#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/study/level_trees.h"
#include "app/study/query_sources.h"

namespace scb::app {

/// A column of a page: hierarchies, one per body, and the queries of two bodies.
struct ViewColumn {
    std::string title;
    const scenes::Scene* scene = nullptr;
    std::vector<std::size_t> places;   ///< of the bodies, in Scene::bodies
    std::vector<BodyAtFrame> bodies;   ///< at the first frame shown
    QuerySource* query = nullptr;      ///< of the first two bodies; null: none
    std::vector<std::string> names;    ///< of the scene on a command line
    std::string kind;                  ///< as in --volume; empty for another engine's recording
    std::vector<std::string> verdict;  ///< on the recorded frame, see verdict_lines; or empty
    std::string explain;  ///< the command that explains a test, without frame and pair; or empty

    bool is_recorded() const { return kind.empty(); }
};

/// The content of a page.
struct ViewSubject {
    std::vector<ViewColumn> columns;
    std::vector<int> frames;  ///< frames at which all columns have poses
    int frame = 0;            ///< the first frame shown
    int deepest = 0;          ///< deepest level of all trees
    bool same_nodes = true;   ///< whether a node has the same index in all columns
    // Owners of the columns' data.
    std::vector<std::unique_ptr<LevelSubject>> levels;
    std::vector<std::unique_ptr<QuerySources>> sources;
};

/// The inputs of a page.
struct ViewSources {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    QueryOptions query;            ///< its frames are replaced by `queries`
    std::string queries = "auto";  ///< frames whose queries the page has; auto: the first frame
                                   ///< shown, or for a trace all frames; none
    CompareOptions compare;
};

/// One column per kind of volumes, or per compared query; of two scenes, these columns for each.
/// Throws InputError.
ViewSubject view_subject(const ViewSources& asked, const Note& note);

}  // namespace scb::app
