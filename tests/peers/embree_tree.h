#pragma once

#include <embree3/rtcore.h>

#include "scb/triangle_overlap.h"
#include "tests/peers/core_mesh.h"

namespace scb {

/// A node of one's own in a tree that rtcBuildBVH builds.
struct EmbreeNode {
    Box box;  ///< of leaves; of others it is the reader's to fit
    std::uint32_t number = 0, triangle = UINT32_MAX;
    EmbreeNode* children[2] = {};
};

inline void* make_node(RTCThreadLocalAllocator allocator, unsigned, void*) {
    return new (rtcThreadLocalAlloc(allocator, sizeof(EmbreeNode), 16)) EmbreeNode;
}
inline void* make_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* p, std::size_t,
                       void*) {
    EmbreeNode* leaf = static_cast<EmbreeNode*>(make_node(allocator, 0, nullptr));
    leaf->triangle = p->primID;
    leaf->box = {Vec3(p->lower_x, p->lower_y, p->lower_z),
                 Vec3(p->upper_x, p->upper_y, p->upper_z)};
    return leaf;
}
inline void set_children(void* node, void** children, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i)
        static_cast<EmbreeNode*>(node)->children[i] = static_cast<EmbreeNode*>(children[i]);
}

/// The root, which lives as long as the device.
inline EmbreeNode* build(RTCDevice device, const Mesh& mesh) {
    std::vector<RTCBuildPrimitive> primitives;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        Box box;
        for (const Vec3& corner : corners(mesh, i)) box.add(corner);
        const auto low = box.lower.cast<float>(), high = box.upper.cast<float>();
        primitives.push_back({low[0], low[1], low[2], 0, high[0], high[1], high[2], i});
    }
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.maxLeafSize = 1;
    arguments.bvh = rtcNewBVH(device);
    arguments.primitives = primitives.data();
    arguments.primitiveCount = arguments.primitiveArrayCapacity = primitives.size();
    arguments.createNode = make_node;
    arguments.createLeaf = make_leaf;
    arguments.setNodeChildren = set_children;
    arguments.setNodeBounds = [](void*, const RTCBounds**, unsigned, void*) {};
    return static_cast<EmbreeNode*>(rtcBuildBVH(&arguments));
}

}  // namespace scb
