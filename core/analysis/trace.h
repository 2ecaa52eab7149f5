#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/outcome.h"
#include "core/model/tree.h"
#include "scb/any_collide.h"
#include "scb/any_distance.h"
#include "scb/collide.h"

namespace scb {

/// Identifies a mesh: equal for the same vertices and triangles in the same order, on every
/// machine.
struct MeshFingerprint {
    std::uint32_t triangles = 0, vertices = 0;
    std::uint64_t hash = 0;  ///< of the bits of all coordinates and of all indices

    friend bool operator==(const MeshFingerprint&, const MeshFingerprint&) = default;
};
MeshFingerprint fingerprint(const Mesh& mesh);

/// A body of a trace.
struct TraceBody {
    std::string name;
    MeshFingerprint mesh;
};

/// The names of A and B.
using BodyNames = std::array<std::string, 2>;

/// One parameter of a trace's queries, as text.
struct TraceField {
    std::string name, value;

    friend bool operator==(const TraceField&, const TraceField&) = default;
};

/// Another engine that made the queries of a trace.
struct TraceEngine {
    std::string name;                  ///< the engine's own name, or the recording's
    std::string volumes;               ///< "OBB", "AABB", see volumes_titles
    std::vector<Stage> stages;         ///< stages at which its tests can reject, in its order
    bool objects = false;              ///< its pairs are of objects of unknown shape
    std::vector<TraceField> settings;  ///< as recorded
    std::string selection{};           ///< which queries were selected: "\"lift\"", "tag grasp"
    /// The number of queries that are left out, since they are not the first of their frame.
    std::uint64_t left_out = 0;
    /// By frame: the hashes of the trees of A and B, see Tree::hash.
    std::map<int, std::array<std::uint64_t, 2>> trees{};
};

/// Parameters of a trace's queries.
struct TraceHeader {
    std::string scb_version;  ///< of the program that recorded it
    /// How the user named the scene, to open it again. A location, not an identity: not compared.
    std::vector<std::string> source;
    std::string scene;
    QueryKind kind = QueryKind::collide;
    std::array<TraceBody, 2> bodies;  ///< A and B; in a self query the same body twice
    VolumeKind volume = VolumeKind::scb;
    BallGrowth growth = BallGrowth::ritter;
    double margin = 0;
    SplitMethod split = SplitMethod::section_3;
    CollideOptions options;
    DistanceOptions distance{};  ///< of QueryKind::distance
    double tolerance = 0;        ///< of QueryKind::within
    StageTable stages;           ///< the ways in which tests can end
    /// Set if another engine made the queries. The members from `volume` to `options` are then
    /// unused.
    std::optional<TraceEngine> engine{};
};

BodyNames body_names(const TraceHeader& header);
/// The names of A and B in words about a test; in a self query "A" and "B", for the left and the
/// right node.
BodyNames side_names(const TraceHeader& header);
/// Whether distances are bounded, and volumes are not tested for overlap.
bool is_of_distance(QueryKind kind);
/// Whether the found pairs are pairs of nodes: at a level to stop at, or of objects.
bool pairs_are_nodes(const TraceHeader& header);
/// The name of a stage in the header's table.
std::string stage_words(const TraceHeader& header, Stage stage);
/// How the hierarchies were built.
BuildOptions build_options(const TraceHeader& header);

/// One query.
struct QueryTrace {
    int frame = 0;
    Pose b_to_a;
    /// Of QueryKind::distance, the pair of the closest triangles, if any.
    Collision found;
    Steps steps;
    /// The trees of A and B if another engine built them, since it numbers nodes itself; null if
    /// numbers are indices.
    std::array<std::shared_ptr<const Tree>, 2> trees{};
    /// Of QueryKind::distance, the distance of the found pair, in A's frame.
    std::optional<TriangleDistance> nearest{};
    /// The error that this distance may have, see distance_rounding; 0 unless the command set it.
    double rounding = 0;
};

/// The builder's numbers of two nodes. Users see numbers, never the indices of a frame.
IndexPair numbers_of(const QueryTrace& frame, IndexPair nodes);
/// The nodes with these numbers; nothing if one does not exist.
std::optional<IndexPair> nodes_of(const QueryTrace& frame, IndexPair numbers);

/// Queries of one scene, frame by frame, with all their steps.
struct Trace {
    TraceHeader header;
    std::vector<QueryTrace> frames;  ///< ascending by number, each once
};

/// The pair of triangles that a test found; in a self query the lower index first.
IndexPair pair_of(const TraceHeader& header, const ItemStep& test);

/// The outcomes of a frame's steps.
Outcomes outcomes_of(const TraceHeader& header, const QueryTrace& frame);

/// Whether A's meshes are the same, and B's. If an engine is involved, only the numbers of vertices
/// and triangles are compared, since its coordinates may have 32 bits.
bool same_meshes(const TraceHeader& a, const TraceHeader& b);

/// The first common frame at which two engines' trees of A (side 0) or B (1) differ.
std::optional<int> other_tree_at(const TraceEngine& a, const TraceEngine& b, std::size_t side);
/// Whether node indices mean the same in both. They do not if the splits differ, if trees of two
/// engines differ at a common frame, or if only one trace is an engine's.
bool same_nodes(const TraceHeader& a, const TraceHeader& b);

/// The parameters in a fixed order: scene, bodies, meshes, "query" of a self query, split, volume;
/// growth, margin, test and threshold if they affect the volume; descent, max pairs, level. For
/// another engine: scene, bodies, meshes, engine, volume, the trees at the first frame, and its
/// settings. Version and source are left out.
std::vector<TraceField> fields_of(const TraceHeader& header);

}  // namespace scb
