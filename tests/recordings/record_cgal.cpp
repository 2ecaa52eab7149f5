// CGAL: an AABB_tree of A, asked with each triangle of B by a traversal that records. The tree of B
// is a root with all of its triangles.
#include "tests/peers/cgal_tree.h"
#include "tests/recordings/recorded_engine.h"

namespace scb {
namespace {

using Index = std::uint32_t;

/// The traits of a traversal.
struct Body {
    scb_recorder& recorder;
    CgalTriangles triangles{};
    CgalTree tree{};
    std::map<const CgalNode*, Index> numbers{};
    Index asked = 0;  ///< triangle of B

    bool go_further() const { return true; }
    bool do_intersect(const CgalTriangle& query, const CgalNode& node) const {
        const bool meet = tree.traits().do_intersect_object()(query, node.bbox());
        scb_record_test(&recorder, numbers.at(&node), asked + 1, !meet);
        return meet;
    }
    Index item(const CgalPrimitive& primitive) const {
        return static_cast<Index>(primitive.id() - triangles.cbegin());
    }
    void intersection(const CgalTriangle& query, const CgalPrimitive& primitive) const {
        const bool meet = tree.traits().do_intersect_object()(query, primitive);
        scb_record_items(&recorder, item(primitive), asked, meet);
        if (meet) scb_record_pair(&recorder, item(primitive), asked);
    }

    /// A node of `count` triangles. A node of two or three has triangles in place of children.
    Index record(const CgalNode& node, std::size_t count) {
        const auto number = static_cast<Index>(numbers.size());
        numbers.emplace(&node, number);
        std::vector<Index> children, items;
        if (count <= 3) items.push_back(item(node.left_data()));
        if (count == 2) items.push_back(item(node.right_data()));
        if (count > 3) children.push_back(record(node.left_child(), count / 2));
        if (count > 2) children.push_back(record(node.right_child(), count - count / 2));
        const CGAL::Bbox_3& box = node.bbox();
        record_node(recorder, 0, number, children, items, SCB_RECORD_AABB,
                    {box.xmin(), box.ymin(), box.zmin(), box.xmax(), box.ymax(), box.zmax()});
        return number;
    }
};

}  // namespace

RecordedQuery record_cgal(scb_recorder& recorder, const PeerMesh& a, const PeerMesh& b) {
    const auto body = std::make_shared<Body>(Body{recorder});
    scb_record_stage(&recorder, 1, "triangle of B outside");
    record_body(recorder, 0, a);
    place(a, identity_pose(), body->triangles);
    body->tree.insert(body->triangles.cbegin(), body->triangles.cend());
    body->tree.build();
    body->record(*body->tree.root_node(), a.triangles.size());
    record_triangles_as_nodes(recorder, 1, b);
    return [body, &b](const PeerPose& at_a, const PeerPose& at_b) {
        CgalTriangles placed;
        place(b, relative(at_a, at_b), placed);
        for (body->asked = 0; body->asked < placed.size(); ++body->asked)
            body->tree.traversal(placed[body->asked], *body);
    };
}

}  // namespace scb
