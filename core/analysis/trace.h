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
#include "scb/query.h"

namespace scb {

/// Tells one mesh from another: the same numbers for the same vertices and triangles in the same
/// order, on every machine.
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

/// One line of what was asked, as text.
struct TraceField {
    std::string name, value;

    friend bool operator==(const TraceField&, const TraceField&) = default;
};

/// Another engine, of whose queries there is a trace.
struct TraceEngine {
    std::string name;                  ///< as it calls itself, or the recording's
    std::string volumes;               ///< "OBB", "AABB", see volumes_titles
    std::vector<Stage> stages;         ///< at which its tests can reject, in its order
    bool objects = false;              ///< its pairs are of objects that nothing is known of
    std::vector<TraceField> settings;  ///< as it told them
    /// By frame, of A and B: the hashes of the trees, see Tree::hash.
    std::map<int, std::array<std::uint64_t, 2>> trees{};
};

/// What the queries of a trace were asked.
struct TraceHeader {
    std::string scb_version;  ///< of the program that recorded it
    /// How the user named the scene, so that it can be opened again. Says where it was, not what
    /// it is: it takes no part in comparisons.
    std::vector<std::string> source;
    std::string scene;
    QueryKind kind = QueryKind::collide;
    std::array<TraceBody, 2> bodies;  ///< A and B; of a self query the same body twice
    VolumeKind volume = VolumeKind::scb;
    BallGrowth growth = BallGrowth::ritter;
    double margin = 0;
    SplitMethod split = SplitMethod::section_3;
    CollideOptions options;
    StageTable stages;  ///< the ways in which tests can end
    /// Set where another engine made the queries: what stands between the bodies and this then says
    /// nothing.
    std::optional<TraceEngine> engine{};
};

BodyNames body_names(const TraceHeader& header);
/// The names of A and B in words about a test: of a self query "A" and "B", the left and the right
/// node.
BodyNames side_names(const TraceHeader& header);
/// Whether the pairs that were found are such of nodes: those of a level, or of objects.
bool pairs_are_nodes(const TraceHeader& header);
/// The name of a stage in the header's table.
std::string stage_words(const TraceHeader& header, Stage stage);
/// How the hierarchies were built.
BuildOptions build_options(const TraceHeader& header);

/// One query.
struct TraceFrame {
    int frame = 0;
    Pose b_to_a;
    Collision found;
    Steps steps;
    /// Of A and B where they are another engine's, which has numbers of its own for their nodes;
    /// null where numbers are indices.
    std::array<std::shared_ptr<const Tree>, 2> trees{};
};

/// The numbers of two nodes, as whoever made the query calls them: these are for users, and the
/// indices in a frame are not.
IndexPair numbers_of(const TraceFrame& frame, IndexPair nodes);
/// The nodes of two such numbers; nothing where there is no such node.
std::optional<IndexPair> nodes_of(const TraceFrame& frame, IndexPair numbers);

/// Queries of one scene, frame by frame, with all that they did.
struct Trace {
    TraceHeader header;
    std::vector<TraceFrame> frames;  ///< ascending by number, each once
};

/// The pair of triangles that a test found: of a self query the lower one first.
IndexPair pair_of(const TraceHeader& header, const ItemStep& test);

/// The outcomes of a frame's steps.
Outcomes outcomes_of(const TraceHeader& header, const TraceFrame& frame);

/// Whether the meshes of A, and those of B, are the same; of another engine, which may have its
/// coordinates in 32 bits, whether they have as many vertices and triangles.
bool same_meshes(const TraceHeader& a, const TraceHeader& b);

/// The first frame that both have at which an engine's tree of A (side 0) or B (1) is another than
/// the other engine's.
std::optional<int> other_tree_at(const TraceEngine& a, const TraceEngine& b, std::size_t side);
/// Whether the index of a node means the same in both: not where splits, or the trees of two
/// engines at a frame that both have, are others.
bool same_nodes(const TraceHeader& a, const TraceHeader& b);

/// What was asked, in a fixed order: scene, bodies, meshes, "query" of a self query, split, volume,
/// growth, margin, test and threshold where they mean anything to the volume; descent, pairs at
/// most, level. Of another engine scene, bodies, meshes, engine, volume, the trees at the first
/// frame, and its settings. Neither version nor source.
std::vector<TraceField> fields_of(const TraceHeader& header);

}  // namespace scb
