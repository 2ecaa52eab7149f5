#include "app/view/view_columns.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "app/query/query_options.h"
#include "core/platform/number_list.h"
#include "render/figures/figure_words.h"
#include "scb/error.h"
#include "scenes/recordings/recording_input.h"

namespace scb::app {
namespace {

constexpr int most_frames = 20'000;

/// The frames that a scene has poses at.
std::vector<int> page_frames(const scenes::Scene& scene) {
    if (scene.listed.empty() && scene.frames > most_frames)
        throw InputError("the scene has " + std::to_string(scene.frames) +
                         " frames; a page holds the poses of 20,000 at most.");
    return frames_of(scene, "all");
}

/// Collects columns.
class Columns {
  public:
    Columns(const ViewSources& asked, const Note& note) : asked_(asked), note_(note) {}

    /// Queries compared by open_sources, or the query of a trace.
    void add_compared() {
        QueryOptions query = asked_.query;
        const bool traced =
            std::any_of(asked_.scene.names.begin(), asked_.scene.names.end(), scenes::names_trace);
        const bool recorded = std::any_of(asked_.scene.names.begin(), asked_.scene.names.end(),
                                          scenes::names_recording);
        if (asked_.queries == "none")
            throw InputError("--queries none: a comparison needs queries; leave it out.");
        query.frames = asked_.queries != "auto" ? asked_.queries
                       : recorded               ? first_frame(auto_frames)
                       : traced                 ? "all"
                                                : std::to_string(shown_frame(asked_.scene));
        auto sources = std::make_unique<QuerySources>(
            open_sources(asked_.scene, asked_.hierarchy, query, {}, asked_.compare, note_));
        const bool two = sources->size() == 2;
        std::array<QueryLabel, 2> labels;
        if (two) labels = query_labels((*sources)[0].header(), (*sources)[1].header());
        for (std::size_t i = 0; i < sources->size(); ++i) {
            QuerySource& source = (*sources)[i];
            std::vector<std::string> names = asked_.scene.names;
            if (two && names.size() == 2 && asked_.compare.names.empty()) names = {names[i]};
            add(source, two ? labels[i].caption : render::volume_title(source.header()), names);
        }
        subject_.sources.push_back(std::move(sources));
    }

    /// A scene with each kind of volumes.
    void add_scene(const SceneOptions& scene) {
        const bool recorded = scene.is_recording() && asks_for_recorded(asked_.compare.given);
        if (asked_.queries == "none" || !(recorded ? add_recorded(scene) : add_queries(scene)))
            add_levels(scene);
    }

    /// Adds the scene at the frame of the first column, if the scene has it.
    void add_scene_at_frame(SceneOptions scene) {
        if (!subject_.columns.empty() && scene.frames.empty()) {
            const std::vector<int> frames = page_frames(scene.load());
            if (std::binary_search(frames.begin(), frames.end(), subject_.frame))
                scene.frames = std::to_string(subject_.frame);
        }
        add_scene(scene);
    }

    ViewSubject subject() && {
        finish();
        return std::move(subject_);
    }

  private:
    std::string first_frame(const std::string& otherwise) const {
        return asked_.scene.frames.empty() ? otherwise : asked_.scene.frames;
    }
    static int shown_frame(const SceneOptions& scene) { return scene.frame_of(scene.load()); }

    /// Returns whether there are two bodies to query.
    bool add_queries(const SceneOptions& scene) {
        QueryOptions query = asked_.query;
        const std::vector<VolumeKind> kinds = asked_.hierarchy.kinds();
        {
            const scenes::Scene loaded = scene.load();
            if (loaded.bodies.size() < 2 || (loaded.bodies.size() > 2 && query.bodies.empty())) {
                if (asked_.queries != "auto")
                    throw InputError("--queries " + asked_.queries + ": the scene has " +
                                     (loaded.bodies.size() < 2 ? "one body" : "several bodies") +
                                     ", and the page shows queries of two; " +
                                     (loaded.bodies.size() < 2
                                          ? "leave it out."
                                          : "name two of them with --bodies, or leave it out."));
                return false;
            }
            query.frames =
                asked_.queries == "auto" ? std::to_string(scene.frame_of(loaded)) : asked_.queries;
            note_doubts(asked_.hierarchy, kinds, note_);
            note_doubts(scene, loaded, query, kinds, note_);
        }
        auto sources = std::make_unique<QuerySources>();
        for (const VolumeKind kind : kinds) {
            HierarchyOptions of_kind = asked_.hierarchy;
            of_kind.volumes = volume_kind_name(kind);
            sources->emplace_back(scene, of_kind, query, QueryLimits{}, false);
        }
        if (sources->front().query().is_self())
            throw InputError("--bodies " + query.bodies +
                             ": the page shows queries of two bodies; see a body against itself "
                             "with `scb render rejections` and `scb inspect`.");
        for (QuerySource& source : *sources)
            add(source, std::string(render::volume_title(source.query().kind)), scene.names);
        subject_.sources.push_back(std::move(sources));
        return true;
    }

    /// Returns whether a recorded query exists at the frame.
    bool add_recorded(const SceneOptions& scene) {
        QueryOptions query = asked_.query;
        query.frames = first_frame(auto_frames);
        if (asked_.queries != "auto")
            throw InputError("--queries " + asked_.queries +
                             ": of a recording the page has the query of one frame; name that "
                             "with --frames.");
        const scenes::Recording recording = scenes::read_recording(scene.recording_file());
        const std::vector<scenes::QueriedPair>& pairs = recording.pairs;
        if (query.bodies.empty()) {
            if (pairs.size() != 1 || recording.scene.bodies.size() != 2) return false;
            const std::vector<int>& frames = pairs[0].frames;
            if (!scene.frames.empty() && std::find(frames.begin(), frames.end(),
                                                   scene.frame_of(recording.scene)) == frames.end())
                return false;
        }
        auto sources = std::make_unique<QuerySources>();
        sources->emplace_back(scene, asked_.hierarchy, query, QueryLimits{}, true);
        QuerySource& source = sources->front();
        refuse_recorded_distances(source.header());
        note_left_out(*source.recorded(), note_);
        add(source, recording.engine + ", " + source.header().engine->volumes, scene.names);
        subject_.sources.push_back(std::move(sources));
        return true;
    }

    void add_levels(const SceneOptions& scene) {
        if (!asked_.query.bodies.empty())
            throw InputError("--bodies " + asked_.query.bodies +
                             ": the page has no query of two bodies here; leave it out.");
        auto level = std::make_unique<LevelSubject>(
            level_subject(scene, asked_.hierarchy, "all", asked_.compare.given, note_));
        for (LevelTrees& kind : level->trees) {
            ViewColumn column;
            column.title = kind.title;
            column.scene = &level->scene;
            column.places.resize(kind.bodies.size());
            std::iota(column.places.begin(), column.places.end(), std::size_t{0});
            column.bodies = kind.bodies;
            column.names = scene.names;
            if (!level->recorded) column.kind = kind.name;
            add(std::move(column),
                level->recorded ? std::vector{level->frame} : page_frames(level->scene),
                level->frame);
        }
        subject_.levels.push_back(std::move(level));
    }

    void add(QuerySource& source, const std::string& title, const std::vector<std::string>& names) {
        ViewColumn column;
        column.title = title;
        column.scene = &source.scene();
        column.places = {source.body_index(0), source.body_index(1)};
        column.query = &source;
        column.names = names;
        if (source.header().kind == QueryKind::within && !source.is_recording())
            throw InputError(names[0] +
                             ": its queries find all triangles within a distance, and the page "
                             "shows the smallest distance; see them with `scb render traversal`.");
        const std::vector<int>& queried = source.frames();
        int first = queried.front();
        // Recorded trees belong to one frame.
        std::vector<int> frames = {first};
        if (source.is_recording()) {
            if (queried.size() != 1)
                throw InputError("of a recording the page has one frame; give one with --frames.");
        } else {
            column.kind = volume_kind_name(source.query().kind);
            frames = page_frames(*column.scene);
            if (!asked_.scene.frames.empty())
                first = asked_.scene.frame_of(*column.scene);
            else if (std::binary_search(queried.begin(), queried.end(),
                                        column.scene->default_frame))
                first = column.scene->default_frame;
        }
        for (std::size_t side = 0; side < 2; ++side)
            column.bodies.push_back(source.body(side, first));
        add(std::move(column), frames, first);
    }

    void add(ViewColumn&& column, const std::vector<int>& frames, int first) {
        if (subject_.columns.empty()) {
            subject_.frames = frames;
            subject_.frame = first;
        } else {
            std::vector<int> common;
            std::set_intersection(subject_.frames.begin(), subject_.frames.end(), frames.begin(),
                                  frames.end(), std::back_inserter(common));
            if (common.empty())
                throw InputError(
                    "the two have no frame in common; name one that is in both with --frames.");
            subject_.frames = std::move(common);
        }
        for (const BodyAtFrame& body : column.bodies)
            subject_.deepest = std::max(subject_.deepest, depth(body.tree->shape()));
        subject_.columns.push_back(std::move(column));
    }

    void finish() {
        const ViewColumn& first = subject_.columns.front();
        if (!std::binary_search(subject_.frames.begin(), subject_.frames.end(), subject_.frame))
            subject_.frame = subject_.frames.front();
        for (ViewColumn& column : subject_.columns)
            for (std::size_t b = 0; b < column.bodies.size() && !column.is_recorded(); ++b)
                column.bodies[b].pose =
                    pose_at(column.scene->bodies[column.places[b]].motion, subject_.frame);
        for (const ViewColumn& column : subject_.columns) {
            if (&column == &first) continue;
            subject_.same_nodes &= column.bodies.size() == first.bodies.size();
            if (column.query && first.query) {
                const TraceHeader &a = first.query->header(), &b = column.query->header();
                subject_.same_nodes &= same_meshes(a, b) && scb::same_nodes(a, b);
            } else {
                subject_.same_nodes &= column.scene == first.scene;
            }
        }
    }

    const ViewSources& asked_;
    const Note& note_;
    ViewSubject subject_;
};

}  // namespace

ViewSubject view_subject(const ViewSources& asked, const Note& note) {
    const std::vector<std::string>& names = asked.scene.names;
    const auto count = [&names](bool (*of)(const std::string&)) {
        return std::count_if(names.begin(), names.end(), of);
    };
    Columns columns(asked, note);
    const bool traced = count(scenes::names_trace) > 0;
    if (traced) refuse_for_trace(asked.compare.given, names[0]);
    if (traced || !asked.compare.names.empty() ||
        (names.size() == 2 && count(scenes::names_recording) == 2)) {
        columns.add_compared();
    } else if (names.size() == 2 && count(scenes::names_scene) == 2) {
        for (const std::string& name : names) {
            SceneOptions one = asked.scene;
            one.names = {name};
            columns.add_scene_at_frame(one);
        }
    } else {
        columns.add_scene(asked.scene);
    }
    return std::move(columns).subject();
}

}  // namespace scb::app
