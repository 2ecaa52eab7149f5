#include "scenes/recordings/trace_recording.h"

#include <utility>

#include "scenes/scene/pose_rows.h"

namespace scb::scenes {
namespace {

/// The stage at which packed tests reject: lanes do not say which bound rejects.
constexpr std::uint8_t packed_stage = 1;

void append(std::vector<double>& values, const Vec3& v) {
    values.insert(values.end(), {v[0], v[1], v[2]});
}

RecordedVolume recorded(const Obb& box) {
    RecordedVolume volume{RecordedKind::obb, {}};
    append(volume.values, box.center);
    for (int i = 0; i < 3; ++i) append(volume.values, box.axes.col(i));
    append(volume.values, box.half);
    return volume;
}

template <bool exact>
RecordedVolume recorded(const BasicAabb<exact>& box) {
    // As an oriented box, since corners would be rounded.
    return recorded(Obb{box.center, Mat3::Identity(), box.half});
}

RecordedVolume recorded(const Ball& ball) {
    RecordedVolume volume{RecordedKind::ball, {}};
    append(volume.values, ball.center);
    volume.values.push_back(ball.radius);
    return volume;
}

RecordedVolume recorded(const Scb& scb) {
    RecordedVolume volume{RecordedKind::scb, {}};
    append(volume.values, scb.c);
    volume.values.push_back(scb.r);
    append(volume.values, scb.n);
    volume.values.insert(volume.values.end(), {scb.e, scb.f});
    return volume;
}

RecordedVolume recorded(const Scb2& scb) {
    RecordedVolume volume{RecordedKind::scb2, {}};
    append(volume.values, scb.c);
    volume.values.push_back(scb.r);
    for (const Slab& slab : scb.slabs) {
        append(volume.values, slab.n);
        volume.values.insert(volume.values.end(), {slab.e, slab.f});
    }
    return volume;
}

template <int k>
RecordedVolume recorded(const KDop<k>& dop) {
    RecordedVolume volume{RecordedKind::kdop, {}};
    for (std::size_t i = 0; i < dop.which.size(); ++i)
        volume.values.insert(volume.values.end(), {dop.lower[i], dop.upper[i]});
    return volume;
}

RecordedVolume recorded(const Rss& rss) {
    RecordedVolume volume{RecordedKind::rss, {}};
    append(volume.values, rss.center - rss.half_sides[0] - rss.half_sides[1]);
    for (const Vec3& half : rss.half_sides) append(volume.values, 2 * half);
    volume.values.push_back(rss.radius);
    return volume;
}

RecordedVolume recorded(const Capsule& capsule) {
    RecordedVolume volume{RecordedKind::capsule, {}};
    append(volume.values, capsule.center - capsule.half_axis);
    append(volume.values, capsule.center + capsule.half_axis);
    volume.values.push_back(capsule.radius);
    return volume;
}

template <class V>
std::vector<double> directions_of(const V&) {
    return {};
}

template <int k>
std::vector<double> directions_of(const KDop<k>& dop) {
    std::vector<double> directions;
    for (const int which : dop.which) {
        const auto& d = dop_directions[static_cast<std::size_t>(which)];
        directions.insert(directions.end(), d.begin(), d.end());
    }
    return directions;
}

RecordedMesh recorded(const Mesh& mesh, std::uint32_t number, const std::string& name) {
    RecordedMesh result{number, name, 8, {}, {}};
    for (const Vec3& vertex : mesh.vertices) append(result.coordinates, vertex);
    for (const Triangle& triangle : mesh.triangles)
        result.indices.insert(result.indices.end(), triangle.begin(), triangle.end());
    return result;
}

/// The nodes of a binary hierarchy with their links, parents first.
std::vector<PackedTreeNode> linked_nodes(const Topology& topology) {
    std::vector<PackedTreeNode> nodes(topology.nodes.size());
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        const TopologyNode& node = topology.nodes[i];
        nodes[i].node = i;
        if (node.is_leaf()) {
            nodes[i].items = {topology.order[node.first]};
        } else {
            nodes[i].children = {node.left, node.left + 1};
            nodes[node.left].parent = nodes[node.left + 1].parent = i;
        }
    }
    return nodes;
}

void add_tree(RecordingWriter& writer, std::uint32_t number, const std::string& name,
              const TracedBody& body) {
    std::visit(
        [&](const auto& hierarchy) {
            writer.add(RecordedTree{number, number, name, directions_of(hierarchy.volumes[0])});
            for (const PackedTreeNode& node :
                 body.packed ? body.packed->nodes : linked_nodes(*hierarchy.topology))
                writer.add(RecordedNode{number,
                                        node.node,
                                        node.parent,
                                        node.node,
                                        {},
                                        node.children,
                                        node.items,
                                        recorded(hierarchy.volumes[node.node])});
        },
        *body.hierarchy);
}

}  // namespace

TraceRecording::TraceRecording(const TraceHeader& header, const std::array<TracedBody, 2>& bodies,
                               const std::string& layout)
    : tests_triangles_(header.options.stop_level < 0),
      is_packed_(!layout.empty()),
      bodies_(header.kind == QueryKind::self ? 1 : 2) {
    writer_.add(RecordedSetting{"engine", "scb " + (is_packed_ ? layout : header.scb_version)});
    if (tests_triangles_) writer_.add(RecordedSetting{"results", "pairs"});
    for (const TraceField& field : fields_of(header))
        if (!is_packed_ || (field.name != "test" && field.name != "descent"))
            writer_.add(RecordedSetting{field.name, field.value});
    if (is_packed_) {
        writer_.add(RecordedSetting{"version", header.scb_version});
        writer_.add(RecordedStage{packed_stage, "any bound"});
    }
    for (const Stage stage : stages_of(header.volume, header.options.overlap))
        if (!is_packed_)
            writer_.add(
                RecordedStage{static_cast<std::uint8_t>(stage), std::string(stage_name(stage))});
    for (std::uint32_t side = 0; side < bodies_; ++side) {
        const std::string& name = header.bodies[side].name;
        writer_.add(recorded(*bodies[side].mesh, side, name));
        add_tree(writer_, side, name, bodies[side]);
        writer_.add(RecordedBody{side, side, name});
    }
}

void TraceRecording::add(const QueryTrace& frame, const std::array<Pose, 2>& poses) {
    writer_.add(RecordedFrame{static_cast<std::uint32_t>(frame.frame)});
    for (std::uint32_t side = 0; side < bodies_; ++side)
        writer_.add(RecordedPose{side, rows_of(poses[side])});
    writer_.add(RecordedQuery{0, bodies_ - 1});
    const auto event = [&](RecordTag tag, IndexPair pair) {
        writer_.add(RecordedEvent{static_cast<std::uint8_t>(tag), pair.a, pair.b});
    };
    const auto& items = frame.steps.items;
    std::size_t next = 0;
    const auto add_items = [&](std::uint32_t step) {
        for (; next < items.size() && items[next].step == step; ++next)
            if (!items[next].neighbors)
                event(items[next].hit ? RecordTag::items_meet : RecordTag::items_apart,
                      items[next].items);
    };
    add_items(no_step);
    for (std::uint32_t i = 0; i < frame.steps.volumes.size(); ++i) {
        const Step& test = frame.steps.volumes[i];
        // Packed queries traverse in no order that shows the parents.
        if (is_packed_ && test.parent != no_step) event(RecordTag::parent, {test.parent, 0});
        const bool overlaps = test.stage == Stage::overlapping;
        event(is_packed_ && !overlaps ? static_cast<RecordTag>(packed_stage)
                                      : static_cast<RecordTag>(test.stage),
              test.nodes);
        add_items(i);
    }
    if (tests_triangles_)
        for (const IndexPair pair : frame.found.pairs) event(RecordTag::pair, pair);
    writer_.add(RecordedQueryEnd{frame.found.complete && tests_triangles_, 0});
}

std::string TraceRecording::finish() {
    writer_.add(RecordedEnd{});
    return writer_.finish();
}

}  // namespace scb::scenes
