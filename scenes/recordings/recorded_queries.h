#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/judge/engine_query.h"
#include "core/judge/tree_check.h"
#include "scenes/recordings/body_pose.h"
#include "scenes/recordings/mesh_state.h"
#include "scenes/recordings/recording_file.h"
#include "scenes/recordings/recording_summary.h"
#include "scenes/recordings/tree_state.h"

namespace scb::scenes {

struct BodyState : BodyPose {
    std::string name;
    std::uint32_t tree = 0;
    std::optional<Pose> last;      ///< the pose at the previous frame, if any
    bool placed = false;           ///< a pose was recorded
    bool has_single_pose = false;  ///< the pose has 32-bit numbers
};

/// The tree and the mesh of a body whose pose stretches it.
struct StretchedBody {
    Mat3 stretch = Mat3::Identity();
    std::uint32_t of = record_none;  ///< number of the original tree
    int volume_version = -1;         ///< of that tree
    int version = 0;                 ///< counts how often it was made
    EngineNodes tree;
    std::shared_ptr<const Mesh> mesh, finite;  ///< nullptr: items are no triangles
};

/// Records that an engine would not have written on purpose.
struct OddRecords {
    std::vector<std::string> first;  ///< clauses
    std::uint64_t count = 0;
};

/// Reads a recording step by step, and has the current state after each step.
///
/// Trees are not validated; the judgement reports contradictions. Throws InputError, one sentence
/// that begins with the path of the file, if reading cannot go on: for an invalid mesh, for an
/// unknown tree or body, and if frames do not ascend.
class RecordedQueries {
  public:
    enum class Ended {
        query,  ///< `query` is set
        frame,  ///< all records of `frame` were read
        end,
    };

    /// `file` must outlive this.
    explicit RecordedQueries(const RecordingFile& file);

    Ended next();

    int frame() const { return frame_; }
    /// A tree by its number, in its current state.
    EngineSide side_of(std::uint32_t tree);
    /// A body by its number: its tree and mesh, stretched by its pose.
    EngineSide side_of_body(std::uint32_t body);
    /// The finite mesh of a body, stretched by its pose, see MeshState; nullptr if items are not
    /// triangles.
    std::shared_ptr<const Mesh> finite_mesh(std::uint32_t body);
    /// The finite meshes of the query's bodies.
    std::array<std::shared_ptr<const Mesh>, 2> finite_meshes() {
        return {finite_mesh(bodies_of_query_[0]), finite_mesh(bodies_of_query_[1])};
    }
    /// The query that ended last, valid until the next step.
    const EngineQuery& query() const { return query_; }
    /// The name of the query as recorded, which may have any bytes; mostly empty.
    const std::string& query_name() const { return query_name_; }
    /// The lines of the engine's log in the current frame.
    const std::vector<std::string>& log() const { return log_; }
    /// The numbers of the query's bodies.
    std::array<std::uint32_t, 2> query_bodies() const { return bodies_of_query_; }

    // By number.
    const std::map<std::uint32_t, MeshState>& meshes() const { return meshes_; }
    const std::map<std::uint32_t, TreeState>& trees() const { return trees_; }
    const std::map<std::uint32_t, BodyState>& bodies() const { return bodies_; }
    const std::map<std::uint8_t, std::string>& stages() const { return stages_; }
    /// The stages' numbers in the order in which they were named.
    const std::vector<std::uint8_t>& stage_order() const { return stage_order_; }
    /// The settings so far, in order.
    const std::vector<RecordedSetting>& settings() const { return settings_; }
    /// The tolerance of this tree alone, see EngineQuery::tolerance: by the precision of its
    /// numbers, or by the setting `tolerance`.
    double tolerance_of(const TreeState& tree) const;
    /// The same per node, by the node's own numbers.
    NodeTolerance node_tolerance_of(const TreeState& tree) const;
    /// Whether the file ends within a query.
    bool broke_off() const { return broke_off_; }
    std::string damage() const { return reader_.damage(); }
    /// The incomplete tree, whose record or refit was the last before the file breaks off. Known at
    /// the end.
    std::optional<std::uint32_t> unfinished_tree() const {
        return damage().empty() ? std::nullopt : telling_;
    }
    /// Records that contradict their tree: refits of nodes that the tree does not have.
    const OddRecords& contradictions() const { return contradictions_; }
    /// Records that cannot be used, such as a tolerance that is no length.
    const OddRecords& unusable() const { return unusable_; }
    /// Records of later versions.
    std::uint64_t unknown_records() const { return unknown_records_; }
    /// Whether the setting `tests` states that tests pass no disjoint volumes.
    bool has_exact_tests() const { return exact_tests_; }

  private:
    void take(const Record& record);
    void take(const RecordedEvent& event);
    void take(const RecordedSetting& setting);
    void take(const RecordedStage& stage);
    void take(const RecordedMesh& mesh);
    void take(const RecordedTree& tree);
    void take(const RecordedNode& node);
    void take(const RecordedRefit& refit);
    void take(const RecordedObject& object);
    void take(const RecordedBody& body);
    void take(const RecordedFrame& frame);
    void take(const RecordedPose& pose);
    void take(const RecordedQuery& query);
    void take(const RecordedQueryEnd& end);
    void take(const RecordedMeasure& measure);
    void take(const RecordedAnswer& answer);
    /// Tests of items whose distance is not above what the query looks for count as tests of items
    /// that meet.
    void compare_lengths();
    /// Removes the recorded parents that are not valid.
    void check_parents();
    void take(const RecordedLog& log) { log_.push_back(shown(log.text)); }
    void take(const RecordedEnd&) {}
    void take(const RecordedUnknown&) { ++unknown_records_; }

    const StretchedBody& stretched(std::uint32_t body);
    void note(OddRecords& records, const std::string& what) const;
    bool is_single(const TreeState& tree) const;
    /// The largest |coordinate| of the tree's mesh; and of its mesh and volumes.
    double mesh_reach(const TreeState& tree) const;
    double reach_of(const TreeState& tree) const;
    double tolerance_of(double share, double length) const;
    /// Throws if the number is unknown.
    template <class State>
    State& known(std::map<std::uint32_t, State>& states, std::uint32_t number, const char* what);
    [[noreturn]] void fail(const std::string& what) const;

    std::string name_;
    QuerySelection selection_;
    RecordingReader reader_;
    std::uint32_t next_parent_ = no_index;  ///< of the test of volumes that follows
    std::optional<double> next_length_;     ///< of the test that follows
    std::map<std::uint32_t, MeshState> meshes_;
    std::map<std::uint32_t, TreeState> trees_;
    std::map<std::uint32_t, BodyState> bodies_;
    std::map<std::uint32_t, StretchedBody> stretched_;  ///< by body
    std::map<std::uint8_t, std::string> stages_;
    std::vector<std::uint8_t> stage_order_;
    std::vector<RecordedSetting> settings_;
    std::optional<double> recorded_tolerance_;
    EngineQuery query_;
    std::array<std::uint32_t, 2> bodies_of_query_{};
    std::string query_name_;
    bool is_selected_ = true;  ///< the current query
    std::vector<std::string> log_;
    OddRecords contradictions_, unusable_;
    std::uint64_t unknown_records_ = 0;
    bool exact_tests_ = false, broke_off_ = false;
    std::uint64_t epoch_ = 1;               ///< counts frames and queries
    std::set<std::uint32_t> without_mesh_;  ///< trees whose missing mesh was noted
    std::optional<std::uint32_t> telling_;  ///< the tree of the last record
    std::optional<int> next_frame_;         ///< recorded, but not begun yet
    int frame_ = 0;
    bool frame_recorded_ = false, in_query_ = false, query_done_ = false, ended_ = false;
};

}  // namespace scb::scenes
