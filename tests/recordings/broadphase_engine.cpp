#include "tests/recordings/broadphase_engine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#define SCB_RECORD_ON
#include <scb_record.h>

namespace scb {
namespace {

using Index = std::uint32_t;
using Box = std::array<double, 6>;  // lower, upper

constexpr Index object_count = 40;

/// Objects on a circle that drift through each other.
Box box_of(Index object, int frame) {
    const double angle = 0.7 * object + 0.15 * frame * (1 + object % 3);
    const double x = 6 * std::cos(angle), y = 6 * std::sin(angle), z = 0.3 * (object % 5);
    return {x - 0.8, y - 0.8, z - 0.4, x + 0.8, y + 0.8, z + 0.4};
}

bool overlap(const Box& a, const Box& b) {
    for (std::size_t i = 0; i < 3; ++i)
        if (a[i] > b[i + 3] || b[i] > a[i + 3]) return false;
    return true;
}

struct Node {
    Box box{};
    std::vector<Index> children;
    Index object = SCB_RECORD_NONE;
};

struct Broadphase {
    std::vector<Node> nodes;
    std::vector<Box> boxes;
    BroadphaseBug bug{};
    scb_recorder& recorder;

    Index build(std::vector<Index> objects) {
        const auto number = static_cast<Index>(nodes.size());
        nodes.emplace_back();
        Box box = boxes[objects[0]];
        for (const Index object : objects)
            for (std::size_t i = 0; i < 3; ++i) {
                box[i] = std::min(box[i], boxes[object][i]);
                box[i + 3] = std::max(box[i + 3], boxes[object][i + 3]);
            }
        nodes[number].box = box;
        if (objects.size() == 1) {
            nodes[number].object = objects[0];
            return number;
        }
        const std::size_t axis = box[3] - box[0] >= box[4] - box[1] ? 0 : 1;
        std::stable_sort(objects.begin(), objects.end(),
                         [&](Index a, Index b) { return boxes[a][axis] < boxes[b][axis]; });
        const auto middle = objects.begin() + static_cast<std::ptrdiff_t>(objects.size() / 2);
        const Index left = build({objects.begin(), middle});
        const Index right = build({middle, objects.end()});
        nodes[number].children = {left, right};
        return number;
    }

    void record() const {
        scb_record_tree(&recorder, 0, "world", SCB_RECORD_NONE, nullptr, 0);
        for (Index i = 0; i < nodes.size(); ++i) {
            scb_record_node_data data = {};
            data.parent = SCB_RECORD_NONE;
            data.children = nodes[i].children.data();
            data.child_count = static_cast<Index>(nodes[i].children.size());
            data.items = &nodes[i].object;
            data.item_count = nodes[i].children.empty() ? 1 : 0;
            data.volume.kind = SCB_RECORD_AABB;
            data.volume.count = 6;
            data.volume.values = nodes[i].box.data();
            scb_record_node(&recorder, 0, i, &data);
        }
    }

    void visit(Index i, Index j) {
        const Node &m = nodes[i], &n = nodes[j];
        const bool meet = overlap(m.box, n.box);
        scb_record_test(&recorder, i, j, meet ? 0 : 1);
        if (!meet) return;
        if (i == j) {
            for (std::size_t s = 0; s < m.children.size(); ++s)
                for (std::size_t t = s; t < m.children.size(); ++t)
                    visit(m.children[s], m.children[t]);
        } else if (!m.children.empty()) {
            for (const Index child : m.children) visit(child, j);
        } else if (!n.children.empty()) {
            for (const Index child : n.children) visit(i, child);
        } else if (bug != BroadphaseBug::pair_order || m.object < n.object) {
            scb_record_pair(&recorder, m.object, n.object);
        }
    }
};

}  // namespace

void record_broadphase(BroadphaseBug bug, bool extents, const std::string& path) {
    scb_recorder recorder;
    scb_record_open(&recorder, path.c_str(), "a broadphase");
    scb_record_setting(&recorder, "results", "pairs");
    scb_record_stage(&recorder, 1, "boxes apart");
    for (int frame = 0; frame < 4; ++frame) {
        Broadphase world{{}, {}, bug, recorder};
        for (Index object = 0; object < object_count; ++object) {
            const bool stale = bug == BroadphaseBug::leaf_not_updated && object == 5 && frame >= 2;
            world.boxes.push_back(box_of(object, stale ? 1 : frame));
        }
        std::vector<Index> objects(object_count);
        std::iota(objects.begin(), objects.end(), 0u);
        world.build(objects);
        scb_record_frame(&recorder, static_cast<Index>(frame));
        world.record();
        if (frame == 0) scb_record_body(&recorder, 0, "world", 0);
        for (Index object = 0; extents && object < object_count; ++object) {
            const Box box = box_of(object, frame);
            scb_record_volume extent = {};
            extent.kind = SCB_RECORD_AABB;
            extent.count = 6;
            extent.values = box.data();
            scb_record_object(&recorder, 0, object, &extent);
        }
        scb_record_query(&recorder, 0, 0);
        world.visit(0, 0);
        scb_record_query_end(&recorder, 1, 0);
    }
    scb_record_close(&recorder);
}

}  // namespace scb
