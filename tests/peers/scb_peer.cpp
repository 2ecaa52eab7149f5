#include "scb/any_packed.h"
#include "scb/collide.h"
#include "scb/overlap_options.h"
#include "tests/peers/adapters.h"
#include "tests/peers/core_mesh.h"
#include "tests/peers/peers.h"

namespace scb {
namespace {

/// A mesh, and its reference hierarchy.
struct ReferenceBody {
    explicit ReferenceBody(const PeerMesh& from)
        : mesh(core_mesh(from)), hierarchy(build_hierarchy<Scb>(mesh)) {}

    Mesh mesh;
    Hierarchy<Scb> hierarchy;

    std::size_t bytes() const {
        const Topology& topology = *hierarchy.topology;
        return topology.nodes.size() * (sizeof(TopologyNode) + sizeof(Scb)) +
               topology.order.size() * sizeof topology.order[0];
    }
};

class ReferencePeer : public Peer {
  public:
    ReferencePeer(const PeerMesh& a, const PeerMesh& b, PeerQuery query) : a_(a), b_(b) {
        if (query == PeerQuery::first_contact) options_.max_pairs = 1;
    }

    void query(const PeerPose& a, const PeerPose& b) override {
        found_ = collide<Scb>({a_.hierarchy, a_.mesh}, {b_.hierarchy, b_.mesh},
                              relative_pose(core_pose(a), core_pose(b)), options_);
    }
    std::vector<IndexPair> pairs() const override { return found_.pairs; }
    double bytes() const override { return static_cast<double>(a_.bytes() + b_.bytes()); }

  private:
    ReferenceBody a_, b_;
    CollideOptions options_;
    Collision found_;
};

/// A mesh, and its packed hierarchy.
struct PackedBody {
    PackedBody(const PeerMesh& from, const PackedPeerOptions& options)
        : mesh(core_mesh(from)),
          hierarchy(build_packed_any(
              options.layout, options.two_slabs ? VolumeKind::scb2 : VolumeKind::scb, mesh,
              {.split = options.by_cost ? SplitMethod::cost : SplitMethod::section_3})) {}

    Mesh mesh;
    AnyPacked hierarchy;
};

class PackedPeer : public Peer {
  public:
    PackedPeer(const PeerMesh& a, const PeerMesh& b, PeerQuery query,
               const PackedPeerOptions& options, int threads)
        : a_(a, options), b_(b, options), query_(query) {
        options_.threads = threads;
    }

    void query(const PeerPose& a, const PeerPose& b) override {
        const Pose b_to_a = relative_pose(core_pose(a), core_pose(b));
        if (query_ == PeerQuery::first_contact)
            touch_ = touches(a_.hierarchy, a_.mesh, b_.hierarchy, b_.mesh, b_to_a, options_,
                             &workspace_);
        else
            found_ = collide_packed(a_.hierarchy, a_.mesh, b_.hierarchy, b_.mesh, b_to_a, options_,
                                    &workspace_);
    }
    std::vector<IndexPair> pairs() const override {
        if (query_ == PeerQuery::all_pairs) return found_.pairs;
        return touch_.pair ? std::vector{*touch_.pair} : std::vector<IndexPair>();
    }
    double bytes() const override {
        return static_cast<double>(bytes_of(a_.hierarchy) + bytes_of(b_.hierarchy));
    }

  private:
    PackedBody a_, b_;
    PeerQuery query_;
    PackedOptions options_;
    PackedWorkspace workspace_;
    PackedCollision found_;
    PackedTouch touch_;
};

}  // namespace

PeerKind reference_peer() {
    PeerKind kind;
    kind.name = reference_name;
    kind.title = "SCB, reference";
    kind.method = "`collide` with the overlap test `" +
                  std::string(overlap_test_name(OverlapOptions{}.test)) +
                  "`, doubles, binary trees; all pairs are sorted within the time.";
    kind.own = true;
    kind.prepare = [](const PeerMesh& a, const PeerMesh& b, PeerQuery query) {
        return std::make_unique<ReferencePeer>(a, b, query);
    };
    return kind;
}

PeerKind packed_peer(const PackedPeerOptions& options, int threads) {
    PeerKind kind;
    kind.name = packed_layout_name(options.layout);
    kind.title = (options.two_slabs ? "SCB2, " : "SCB, ") + kind.name +
                 (options.by_cost ? ", split by cost" : "");
    kind.method =
        "`collide_packed`, with a workspace that is kept; all pairs are sorted within "
        "the time" +
        std::string(options.layout.corners == LeafCorners::stored
                        ? ", and its memory has the triangles' corners."
                        : ".");
    kind.own = true;
    kind.prepare = [options, threads](const PeerMesh& a, const PeerMesh& b, PeerQuery query) {
        return std::make_unique<PackedPeer>(a, b, query, options, threads);
    };
    return kind;
}

}  // namespace scb
