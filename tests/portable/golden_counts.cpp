#include "tests/portable/golden_counts.h"

#include <bit>
#include <cstdio>
#include <vector>

#include "core/volumes/shape.h"
#include "scb/any_distance.h"
#include "scb/any_packed.h"
#include "scenes/scene/builtin.h"
#include "tests/core/hierarchy/built_mesh.h"

namespace scb {
namespace {

/// Frames of a built-in scene.
struct Frames {
    const char* scene;
    std::vector<int> frames;
};

/// Few enough for an emulated CPU. The spheres are apart, cross, and lie one in the other, close to
/// each other everywhere; the poses of the knots differ by rounding only. In the last scenes, parts
/// lie on each other.
const std::vector<Frames>& chosen_frames() {
    static const std::vector<Frames> chosen = {
        {"spheres-l1", {0, 125, 250, 251}},
        {"knots-l1", {0, 333}},
        {"knots-l2", {125}},
        {"knots-l3", {250}},
        {"flat-plate", {40}},
        {"thin-cylinder", {0}},
        {"cone", {80, 90}},
        {"soup", {35, 50}},
        {"stack", {20}},
        {"shaft-in-bore", {25}},
        {"box-grid", {30}},
    };
    return chosen;
}

class Hash {
  public:
    void add(std::uint64_t number) {
        for (int byte = 0; byte < 8; ++byte, number >>= 8)
            value_ = (value_ ^ (number & 0xff)) * 0x100000001b3;
    }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number + 0.0)); }  // 0 for -0
    void add(const Vec3& v) {
        for (int i = 0; i < 3; ++i) add(v[i]);
    }
    void add(const Scb& s) {
        add(s.c);
        add(s.r);
        add(s.n);
        add(s.e);
        add(s.f);
    }
    void add(const Scb2& s) {
        add(s.c);
        add(s.r);
        for (const Slab& slab : s.slabs) {
            add(slab.n);
            add(slab.e);
            add(slab.f);
        }
    }
    void add(const Ball& b) {
        add(b.center);
        add(b.radius);
    }
    void add(const Obb& b) {
        add(b.center);
        for (int i = 0; i < 3; ++i) add(Vec3(b.axes.col(i)));
        add(b.half);
    }
    void add(const ConvexShape& shape) {
        add(shape.center);
        add(shape.rounding);
        for (int i = 0; i < 3; ++i)
            for (const double side : {1.0, -1.0}) add(shape.support_point(side * Vec3::Unit(i)));
    }

    std::string text() const {
        char digits[17];
        std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(value_));
        return digits;
    }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325;
};

std::string hash_of(const Mesh& mesh) {
    Hash hash;
    for (const Vec3& v : mesh.vertices) hash.add(v);
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t corner : t) hash.add(std::uint64_t{corner});
    return hash.text();
}

std::string hash_of(const AnyHierarchy& hierarchy) {
    Hash hash;
    const Topology& topology = topology_of(hierarchy);
    for (const TopologyNode& node : topology.nodes)
        for (const std::uint64_t number :
             {std::uint64_t{node.first}, std::uint64_t{node.count}, std::uint64_t{node.left}})
            hash.add(number);
    for (const std::uint32_t triangle : topology.order) hash.add(std::uint64_t{triangle});
    std::visit(
        [&](const auto& some) {
            for (const auto& volume : some.volumes) hash.add(shape_of(volume));
        },
        hierarchy);
    return hash.text();
}

std::string hash_of(const std::vector<IndexPair>& pairs) {
    Hash hash;
    for (const IndexPair& pair : pairs) {
        hash.add(std::uint64_t{pair.a});
        hash.add(std::uint64_t{pair.b});
    }
    return hash.text();
}

std::string count(std::string_view name, std::uint64_t number) {
    return " " + std::string(name) + "=" + std::to_string(number);
}

std::string collision_text(const Collision& found) {
    std::string text = count("v", found.n_v) + count("p", found.n_p) + count("u", found.n_u) +
                       count("depth", static_cast<std::uint64_t>(found.depth)) +
                       count("pairs", found.pairs.size()) + " " + hash_of(found.pairs) + ";";
    for (std::size_t stage = 0; stage < stage_count; ++stage)
        if (found.stages[stage] != 0)
            text += count(stage_name(static_cast<Stage>(stage)), found.stages[stage]);
    return text;
}

std::string model_lines(const std::string& scene, const std::string& name, const BuiltMesh& model) {
    const std::string start = scene + " " + name + " ";
    std::string lines = start + "mesh:" + count("vertices", model.mesh.vertices.size()) +
                        count("triangles", model.mesh.triangles.size()) + " " +
                        hash_of(model.mesh) + "\n";
    for (const VolumeKind kind : all_volume_kinds()) {
        const AnyHierarchy& hierarchy = model.hierarchies[static_cast<std::size_t>(kind)];
        lines += start + std::string(volume_kind_name(kind)) + ":" +
                 count("nodes", topology_of(hierarchy).nodes.size()) + " " + hash_of(hierarchy) +
                 "\n";
    }
    const auto by_cost = build_hierarchy<Scb>(model.mesh, {.split = SplitMethod::cost});
    lines += start + "scb split by cost:" + count("nodes", by_cost.volumes.size()) + " " +
             hash_of(AnyHierarchy(by_cost)) + "\n";
    return lines;
}

/// The queries of one volume kind in one frame.
std::string query_lines(const std::string& start, VolumeKind kind, const BuiltMesh& a,
                        const BuiltMesh& b, const Pose& b_to_a) {
    std::string lines;
    const auto index = static_cast<std::size_t>(kind);
    for (const OverlapTest test : all_overlap_tests()) {
        // Of balls and boxes the overlap options say nothing.
        if (kind != VolumeKind::scb && test != OverlapTest::corrected) continue;
        for (const DescentRule rule : all_descent_rules()) {
            CollideOptions options;
            options.overlap.test = test;
            options.descent = rule;
            lines += start + " " + std::string(volume_kind_name(kind));
            if (kind == VolumeKind::scb) lines += " " + std::string(overlap_test_name(test));
            lines += " " + std::string(descent_rule_name(rule)) + ":" +
                     collision_text(collide(a.hierarchies[index], a.mesh, b.hierarchies[index],
                                            b.mesh, b_to_a, options)) +
                     "\n";
        }
    }
    return lines;
}

/// The same queries on packed hierarchies.
std::string packed_lines(const std::string& start, const BuiltMesh& a, const BuiltMesh& b,
                         const Pose& b_to_a) {
    std::string lines;
    const std::span<const VolumeKind> kinds = all_volume_kinds();
    for (std::size_t kind = 0; kind < kinds.size(); ++kind)
        for (const PackedLayout& layout : all_packed_layouts()) {
            if (!can_pack(kinds[kind])) continue;
            const auto packed = [&](const BuiltMesh& built) {
                return pack_any(layout, built.hierarchies[kind], built.mesh);
            };
            const PackedCollision found =
                collide_packed(packed(a), a.mesh, packed(b), b.mesh, b_to_a);
            const std::string volume = kinds[kind] == VolumeKind::scb
                                           ? ""
                                           : std::string(volume_kind_name(kinds[kind])) + " ";
            lines += start + " " + volume + packed_layout_name(layout) + ":" +
                     count("v", found.n_v) + count("p", found.n_p) + count("exact", found.n_exact) +
                     count("pairs", found.pairs.size()) + " " + hash_of(found.pairs) + "\n";
        }
    return lines;
}

template <class Found>
std::string distance_text(const Found& found) {
    Hash hash;
    hash.add(found.found.distance);
    hash.add(found.found.point_a);
    hash.add(found.found.point_b);
    return " distance:" + count("v", found.n_v) + count("p", found.n_p) +
           count("a", found.triangles->a) + count("b", found.triangles->b) + " " + hash.text() +
           "\n";
}

/// Distances by some volumes and by packed hierarchies. Of bodies that are near everywhere none, or
/// by one layout: they take long on an emulated CPU.
std::string distance_lines(const std::string& start, const BuiltMesh& a, const BuiltMesh& b,
                           const Pose& b_to_a) {
    std::string lines;
    if (start == "spheres-l1 250" || start == "spheres-l1 251") return lines;
    const bool few = start.starts_with("knots") || start.starts_with("flat-plate");
    for (const VolumeKind kind : {VolumeKind::scb2, VolumeKind::obb}) {
        if (few) break;
        const auto index = static_cast<std::size_t>(kind);
        lines += start + " " + std::string(volume_kind_name(kind)) +
                 distance_text(
                     distance(a.hierarchies[index], a.mesh, b.hierarchies[index], b.mesh, b_to_a));
    }
    constexpr auto two_slabs = static_cast<std::size_t>(VolumeKind::scb2);
    for (const PackedLayout& layout : all_packed_layouts()) {
        if (few && packed_layout_name(layout) != "quantized8") continue;
        lines += start + " " + packed_layout_name(layout) +
                 distance_text(distance_packed(
                     pack_any(layout, a.hierarchies[two_slabs], a.mesh), a.mesh,
                     pack_any(layout, b.hierarchies[two_slabs], b.mesh), b.mesh, b_to_a));
    }
    return lines;
}

std::string scene_lines(const Frames& chosen) {
    const scenes::Scene scene = scenes::load_builtin(*scenes::find_builtin(chosen.scene));
    std::vector<BuiltMesh> models;
    std::string lines;
    for (const scenes::NamedMesh& named : scene.meshes) {
        models.emplace_back(named.mesh);
        lines += model_lines(scene.name, named.name, models.back());
    }
    const scenes::Body &a = scene.bodies[0], &b = scene.bodies[1];
    for (const int frame : chosen.frames) {
        const Pose b_to_a =
            relative_pose(scenes::pose_at(a.motion, frame), scenes::pose_at(b.motion, frame));
        for (const VolumeKind kind : all_volume_kinds())
            lines += query_lines(scene.name + " " + std::to_string(frame), kind, models[a.mesh],
                                 models[b.mesh], b_to_a);
        lines += packed_lines(scene.name + " " + std::to_string(frame), models[a.mesh],
                              models[b.mesh], b_to_a);
        lines += distance_lines(scene.name + " " + std::to_string(frame), models[a.mesh],
                                models[b.mesh], b_to_a);
    }
    return lines;
}

/// Cuts the first line off `rest`; of nothing the line is "the end".
std::string_view next_line(std::string_view& rest) {
    if (rest.empty()) return "the end";
    const std::size_t length = rest.find('\n');
    const std::string_view line = rest.substr(0, length);
    rest.remove_prefix(length == std::string_view::npos ? rest.size() : length + 1);
    return line;
}

}  // namespace

std::string golden_counts() {
    std::string text =
        "# SCENE MODEL mesh: vertices, triangles, hash\n"
        "# SCENE MODEL KIND: nodes, hash of topology and volumes\n"
        "# SCENE FRAME KIND [TEST] RULE: N_v, N_p, N_u, depth, triangle pairs, their hash; tests "
        "per stage\n"
        "# SCENE FRAME LAYOUT: N_v, N_p, of these undecided by floats, triangle pairs, their "
        "hash\n"
        "# SCENE FRAME KIND or LAYOUT distance: N_v, N_p, triangles of A and B, hash of the "
        "distance "
        "and the points\n";
    for (const Frames& chosen : chosen_frames()) text += scene_lines(chosen);
    return text;
}

std::string first_difference(std::string_view expected, std::string_view found) {
    if (expected == found) return {};
    for (int number = 1;; ++number) {
        const bool at_end = expected.empty() || found.empty();
        const std::string_view a = next_line(expected), b = next_line(found);
        if (a != b || at_end)
            return "line " + std::to_string(number) + "\n  expected: " + std::string(a) +
                   "\n  found:    " + std::string(b) + "\n";
    }
}

}  // namespace scb
