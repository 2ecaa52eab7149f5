#include "scenes/recordings/trace_recording.h"

#include <utility>

#include "scenes/scene/pose_rows.h"

namespace scb::scenes {
namespace {

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

void add_tree(RecordingWriter& writer, std::uint32_t number, const std::string& name,
              const AnyHierarchy& any) {
    std::visit(
        [&](const auto& hierarchy) {
            const Topology& topology = *hierarchy.topology;
            writer.add(RecordedTree{number, number, name, directions_of(hierarchy.volumes[0])});
            std::vector<std::uint32_t> parents(topology.nodes.size(), record_none);
            for (std::uint32_t i = 0; i < topology.nodes.size(); ++i) {
                const TopologyNode& node = topology.nodes[i];
                RecordedNode recorded_node{number, i, parents[i], i, {}, {}, {}, {}};
                recorded_node.volume = recorded(hierarchy.volumes[i]);
                if (node.is_leaf()) {
                    recorded_node.items.push_back(topology.order[node.first]);
                } else {
                    recorded_node.children = {node.left, node.left + 1};
                    parents[node.left] = parents[node.left + 1] = i;
                }
                writer.add(recorded_node);
            }
        },
        any);
}

}  // namespace

TraceRecording::TraceRecording(const TraceHeader& header, std::array<const Mesh*, 2> meshes,
                               std::array<const AnyHierarchy*, 2> hierarchies)
    : tests_triangles_(header.options.stop_level < 0),
      bodies_(header.kind == QueryKind::self ? 1 : 2) {
    writer_.add(RecordedSetting{"engine", "scb " + header.scb_version});
    if (tests_triangles_) writer_.add(RecordedSetting{"results", "pairs"});
    for (const TraceField& field : fields_of(header))
        writer_.add(RecordedSetting{field.name, field.value});
    for (const Stage stage : stages_of(header.volume, header.options.overlap))
        writer_.add(
            RecordedStage{static_cast<std::uint8_t>(stage), std::string(stage_name(stage))});
    for (std::uint32_t side = 0; side < bodies_; ++side) {
        const std::string& name = header.bodies[side].name;
        writer_.add(recorded(*meshes[side], side, name));
        add_tree(writer_, side, name, *hierarchies[side]);
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
    std::size_t next = 0;
    const auto& triangle_tests = frame.steps.items;
    for (std::uint32_t i = 0; i < frame.steps.volumes.size(); ++i) {
        const Step& test = frame.steps.volumes[i];
        event(static_cast<RecordTag>(test.stage), test.nodes);
        for (; next < triangle_tests.size() && triangle_tests[next].step == i; ++next)
            if (!triangle_tests[next].neighbors)
                event(triangle_tests[next].hit ? RecordTag::items_meet : RecordTag::items_apart,
                      triangle_tests[next].items);
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
