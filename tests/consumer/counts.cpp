// Prints the counts of many queries and a hash of their pairs. The mesh and the poses are the same
// bits however this file is compiled: sums are of integers, and no sum follows a product that is
// rounded.
#include <scb/any_collide.h>
#include <scb/any_packed.h>
#include <scb/collide.h>
#include <scb/error.h>
#include <scb/level_cover.h>
#include <scb/overlap.h>
#include <scb/triangle_overlap.h>

#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

std::uint64_t hash_of(const std::vector<scb::IndexPair>& pairs) {
    std::uint64_t hash = 14695981039346656037u;
    for (const scb::IndexPair& pair : pairs)
        for (const std::uint32_t index : {pair.a, pair.b}) hash = (hash ^ index) * 1099511628211u;
    return hash;
}

/// A cube of six grids, each vertex moved to a sphere with bumps.
scb::Mesh bumpy_sphere() {
    constexpr int n = 13;
    scb::Mesh mesh;
    std::uint32_t random = 1;
    for (int face = 0; face < 6; ++face)
        for (int i = 0; i <= n; ++i)
            for (int j = 0; j <= n; ++j) {
                const int side = face < 3 ? n : -n;
                int v[3];
                v[face % 3] = side;
                v[(face + 1) % 3] = 2 * i - n;
                v[(face + 2) % 3] = 2 * j - n;
                const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
                random = random * 1664525 + 1013904223;
                const double radius = 1 + (random >> 24) * 0x1p-12;
                mesh.vertices.push_back(
                    {v[0] / length * radius, v[1] / length * radius, v[2] / length * radius});
            }
    for (std::uint32_t face = 0; face < 6; ++face)
        for (std::uint32_t i = 0; i < n; ++i)
            for (std::uint32_t j = 0; j < n; ++j) {
                const std::uint32_t k = (face * (n + 1) + i) * (n + 1) + j;
                mesh.triangles.push_back({k, k + 1, k + n + 2});
                mesh.triangles.push_back({k, k + n + 2, k + n + 1});
            }
    return mesh;
}

/// The rotation of an integer quaternion.
scb::Pose pose(int a, int b, int c, int d, const scb::Vec3& translation) {
    const double n = a * a + b * b + c * c + d * d;
    scb::Pose pose;
    pose.rotation << (a * a + b * b - c * c - d * d) / n, 2 * (b * c - a * d) / n,
        2 * (b * d + a * c) / n, 2 * (b * c + a * d) / n, (a * a - b * b + c * c - d * d) / n,
        2 * (c * d - a * b) / n, 2 * (b * d - a * c) / n, 2 * (c * d + a * b) / n,
        (a * a - b * b - c * c + d * d) / n;
    pose.translation = translation;
    scb::check_rigid(pose, "B");
    return pose;
}

void print(const char* what, const scb::Collision& found) {
    std::printf("%s: %zu pairs %016" PRIx64 ", N_v %" PRIu64 ", N_p %" PRIu64 ", N_u %" PRIu64
                ", depth %d, stages",
                what, found.pairs.size(), hash_of(found.pairs), found.n_v, found.n_p, found.n_u,
                found.depth);
    for (const std::uint64_t count : found.stages) std::printf(" %" PRIu64, count);
    std::printf("\n");
}

void require(bool holds, const std::string& sentence) {
    if (holds) return;
    std::fprintf(stderr, "counts: %s\n", sentence.c_str());
    std::exit(1);
}

/// Has room for more than a pointer, so that a copy would show.
struct OwnObserver {
    std::uint64_t volumes = 0, triangles = 0, hash = 14695981039346656037u;
    int stop_after = 0;

    void volume_test(const scb::Step& step) {
        ++volumes;
        for (const std::uint64_t value :
             {std::uint64_t{step.nodes.a}, std::uint64_t{step.nodes.b}, std::uint64_t(step.depth_a),
              std::uint64_t(step.depth_b), std::uint64_t(step.stage), std::uint64_t(step.parent)})
            hash = (hash ^ value) * 1099511628211u;
        if (stop_after != 0 && volumes == std::uint64_t(stop_after)) throw stop_after;
    }
    void item_test(const scb::ItemStep& test) {
        ++triangles;
        for (const std::uint64_t value : {test.items.a, test.items.b, std::uint32_t(test.hit)})
            hash = (hash ^ value) * 1099511628211u;
    }
};

/// The library's rounding of a coordinate of a pose's point, by operations that no compiler fuses.
double rounded(const scb::Pose& pose, int i, const scb::Vec3& point) {
    volatile double x = pose.rotation(i, 0) * point[0], y = pose.rotation(i, 1) * point[1];
    volatile double z = pose.rotation(i, 2) * point[2], xy = x + y, xyz = xy + z;
    return xyz + pose.translation[i];
}

/// How many of 100 points of B touch the point that they are in A's frame: all, unless the library
/// rounds otherwise, as it would by a copy of its inline functions that was compiled here.
int touching_points(const scb::Pose& b_to_a) {
    int touching = 0;
    std::uint32_t random = 7;
    for (int i = 0; i < 100; ++i) {
        scb::Vec3 point;
        for (int axis = 0; axis < 3; ++axis) {
            random = random * 1664525 + 1013904223;
            point[axis] = random / 3.0;
        }
        scb::Mesh a, b;
        b.vertices = {point};
        a.vertices = {
            {rounded(b_to_a, 0, point), rounded(b_to_a, 1, point), rounded(b_to_a, 2, point)}};
        a.triangles = b.triangles = {{0, 0, 0}};
        const auto hierarchy_a = scb::build_hierarchy<scb::Ball>(a),
                   hierarchy_b = scb::build_hierarchy<scb::Ball>(b);
        touching +=
            int(scb::collide<scb::Ball>({hierarchy_a, a}, {hierarchy_b, b}, b_to_a).pairs.size());
    }
    return touching;
}

/// Makes the compiler give this program copies of its own of inline functions that the library has
/// too.
void emit_inline_functions() {
    scb::TriangleCorners (*volatile corners)(const scb::Pose&, const scb::TriangleCorners&) =
        &scb::transform_corners;
    scb::Vec3 (*volatile point)(const scb::Pose&, const scb::Vec3&) = &scb::transform_point;
    double (*volatile product)(const scb::Vec3&, const scb::Vec3&) = &scb::dot;
    require(corners && point && product, "functions are nowhere.");
}

}  // namespace

int main() {
    emit_inline_functions();
    const scb::Mesh mesh = bumpy_sphere();
    std::printf("%zu triangles\n", mesh.triangles.size());
    const scb::Pose poses[] = {pose(1, 0, 0, 0, {1.75, 0.5, 0.25}),
                               pose(3, 1, -2, 5, {0.5, 1.5, -1}),
                               pose(7, -3, 1, 2, {0, 0, 2.09375}), pose(2, 5, 1, -1, {0.125, 0, 0}),
                               pose(1, 1, 1, 1, {3, 0, 0})};
    const auto kinds = scb::all_volume_kinds();
    for (const scb::SplitMethod split : {scb::SplitMethod::section_3, scb::SplitMethod::cost}) {
        scb::BuildOptions build;
        build.split = split;
        const auto hierarchies = scb::build_hierarchies(mesh, kinds, build);
        const auto& balls = std::get<scb::Hierarchy<scb::Scb>>(hierarchies[0]);
        for (const auto& hierarchy : hierarchies) {
            const std::string fault = scb::validate(hierarchy, mesh);
            require(fault.empty(), fault);
        }
        double area = 0;
        for (const scb::Scb& volume : balls.volumes)
            area = std::max(area, scb::surface_area(volume));
        std::printf("%s: largest area %a\n", std::string(scb::split_method_name(split)).c_str(),
                    area);

        for (const scb::Pose& b_to_a : poses) {
            std::printf("%d of 100 points touch\n", touching_points(b_to_a));
            for (std::size_t i = 0; i < kinds.size(); ++i)
                print(std::string(scb::volume_kind_name(kinds[i])).c_str(),
                      scb::collide(hierarchies[i], mesh, hierarchies[i], mesh, b_to_a));

            const scb::Collider<scb::Scb> side{balls, mesh};
            scb::CollideOptions options;
            for (const scb::OverlapTest test : scb::all_overlap_tests()) {
                options.overlap.test = test;
                print(std::string(scb::overlap_test_name(test)).c_str(),
                      collide(side, side, b_to_a, options));
            }
            options.overlap = {};
            for (const scb::DescentRule rule : scb::all_descent_rules()) {
                options.descent = rule;
                print(std::string(scb::descent_rule_name(rule)).c_str(),
                      collide(side, side, b_to_a, options));
            }

            OwnObserver observer;
            const scb::Collision seen = collide(side, side, b_to_a, {}, observer);
            require(observer.volumes == seen.n_v && observer.triangles == seen.n_p,
                    "the observer missed tests.");
            std::printf("observer: %016" PRIx64 "\n", observer.hash);
            scb::StepRecorder recorder;
            collide(side, side, b_to_a, {}, recorder);
            require(recorder.steps.volumes.size() == seen.n_v, "the recorder missed tests.");
            if (seen.n_v >= 3) {
                observer = {};
                observer.stop_after = 3;
                try {
                    collide(side, side, b_to_a, {}, observer);
                    require(false, "the observer's exception was lost.");
                } catch (int tests) {
                    require(tests == 3, "another exception came.");
                }
            }

            scb::StageCounts ended{};
            for (const std::uint32_t i : scb::level_cover(*balls.topology, 5))
                for (const std::uint32_t j : scb::level_cover(*balls.topology, 5))
                    ++ended[std::size_t(scb::overlap(balls.volumes[i], balls.volumes[j], b_to_a))];
            std::printf("level 5:");
            for (const std::uint64_t count : ended) std::printf(" %" PRIu64, count);
            std::printf("\n");

            for (const scb::PackedLayout& layout : scb::all_packed_layouts()) {
                const scb::AnyPacked packed = scb::pack_any(layout, balls, mesh);
                const std::string fault = scb::validate(packed, mesh);
                require(fault.empty(), fault);
                scb::PackedWorkspace workspace;
                const auto quick =
                    scb::collide_packed(packed, mesh, packed, mesh, b_to_a, {}, &workspace);
                require(quick.pairs == seen.pairs, "a packed layout finds other pairs.");
                std::printf("%s: N_v %" PRIu64 ", N_p %" PRIu64 ", exact %" PRIu64 ", %zu bytes\n",
                            scb::packed_layout_name(layout).c_str(), quick.n_v, quick.n_p,
                            quick.n_exact, scb::bytes_of(packed));
            }
        }
    }
    try {
        scb::Mesh bad = mesh;
        bad.triangles[7][1] = 1u << 30;
        scb::build_hierarchy<scb::Scb>(bad, {}, "bad.ply");
        require(false, "a bad mesh was not refused.");
    } catch (const scb::InputError& error) {
        std::printf("%s\n", error.what());
    }
}
