#include "app/study/scene_query.h"

#include <cmath>
#include <optional>

#include "app/study/query_timing.h"
#include "core/base/text_format.h"
#include "core/distance/distance_certificate.h"
#include "core/platform/number_list.h"
#include "scb/error.h"

namespace scb::app {
namespace {

/// The pairs of bodies that `names` may mean: names may have commas, so each comma may be the one
/// between the two names.
std::vector<BodyPair> pairs_named(const scenes::Scene& scene, const std::string& names) {
    std::vector<BodyPair> pairs;
    for (std::size_t at = names.find(','); at != std::string::npos; at = names.find(',', at + 1)) {
        const auto a = body_named(scene, names.substr(0, at)),
                   b = body_named(scene, names.substr(at + 1));
        if (a && b) pairs.push_back({*a, *b});
    }
    return pairs;
}

}  // namespace

std::optional<std::size_t> body_named(const scenes::Scene& scene, const std::string& name) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (scene.bodies[i].name == name) return i;
    if (scene.bodies.size() != 2 || (name != "A" && name != "B")) return std::nullopt;
    return name == "A" ? 0 : 1;
}

const Mesh& SceneQuery::mesh(std::size_t body) const {
    return scene.meshes[scene.bodies[body].mesh].mesh;
}

const AnyHierarchy& SceneQuery::hierarchy(std::size_t body) const {
    return hierarchies[scene.bodies[body].mesh];
}

std::array<Pose, 2> SceneQuery::poses(int frame) const {
    return {scenes::pose_at(scene.bodies[a].motion, frame),
            scenes::pose_at(scene.bodies[b].motion, frame)};
}

Pose SceneQuery::b_to_a(int frame) const {
    if (is_self()) return {};
    const auto [of_a, of_b] = poses(frame);
    return relative_pose(of_a, of_b);
}

CollideOptions SceneQuery::mutated_options() const {
    CollideOptions mutated = options;
    mutate(mutation, mutated.overlap);
    return mutated;
}

void SceneQuery::pack(const PackedLayout& layout) {
    packed.clear();
    for (std::size_t m = 0; m < hierarchies.size(); ++m)
        packed.push_back(pack_any(layout, hierarchies[m], scene.meshes[m].mesh,
                                  scene.meshes[m].name, build.threads));
}

void SceneQuery::trace_packed() {
    packed_trees.clear();
    for (std::size_t m = 0; m < packed.size(); ++m)
        packed_trees.push_back(packed_tree(packed[m], *topologies[m].topology));
}

Collision SceneQuery::whole(Collision found, int frame) const {
    if (!found.complete)
        throw InputError("--layout: frame " + std::to_string(frame) + " has more than " +
                         std::to_string(options.max_pairs) +
                         " pairs, and a packed query lists all or none; leave --layout out.");
    return found;
}

Collision SceneQuery::packed_query(int frame) const {
    PackedOptions limits;
    limits.give_up_after = options.max_pairs;
    const auto of = [&](const auto& query) {
        return collision_of(query(packed[scene.bodies[a].mesh], mesh(a),
                                  packed[scene.bodies[b].mesh], mesh(b), b_to_a(frame), limits));
    };
    if (options.max_pairs == 1) return of([](const auto&... sides) { return touches(sides...); });
    return whole(of([](const auto&... sides) { return collide_packed(sides...); }), frame);
}

Collision SceneQuery::collide(int frame) const {
    if (is_packed()) return packed_query(frame);
    Collision found = is_self() ? collide_self(hierarchy(a), mesh(a), joined, mutated_options())
                                : scb::collide(hierarchy(a), mesh(a), hierarchy(b), mesh(b),
                                               b_to_a(frame), mutated_options());
    mutate(mutation, found, kind, options.overlap);
    return found;
}

Collision SceneQuery::packed_query(int frame, StepRecorder& recorder) const {
    const std::size_t of_a = scene.bodies[a].mesh, of_b = scene.bodies[b].mesh;
    const std::size_t first = recorder.steps.volumes.size();
    PackedOptions limits;
    limits.give_up_after = options.max_pairs;
    Collision found =
        whole(collision_of(collide_packed(packed[of_a], mesh(a), packed[of_b], mesh(b),
                                          b_to_a(frame), limits, calls_of(recorder))),
              frame);
    for (std::size_t i = first; i < recorder.steps.volumes.size(); ++i) {
        IndexPair& nodes = recorder.steps.volumes[i].nodes;
        nodes = {packed_trees[of_a].binary.at(nodes.a), packed_trees[of_b].binary.at(nodes.b)};
    }
    return found;
}

Collision SceneQuery::collide(int frame, StepRecorder& recorder) const {
    if (is_packed()) return packed_query(frame, recorder);
    Collision found = is_self()
                          ? collide_self(hierarchy(a), mesh(a), joined, mutated_options(), recorder)
                          : scb::collide(hierarchy(a), mesh(a), hierarchy(b), mesh(b),
                                         b_to_a(frame), mutated_options(), recorder);
    mutate(mutation, found, kind, options.overlap);
    mutate(mutation, recorder.steps);
    return found;
}

Distance SceneQuery::nearest(int frame, const DistanceOptions& limits) const {
    if (!is_packed())
        return scb::distance(hierarchy(a), mesh(a), hierarchy(b), mesh(b), b_to_a(frame), limits);
    return distance_of(distance_packed(packed[scene.bodies[a].mesh], mesh(a),
                                       packed[scene.bodies[b].mesh], mesh(b), b_to_a(frame),
                                       limits));
}

Collision SceneQuery::within(int frame, double tolerance) const {
    if (!is_packed())
        return scb::within(hierarchy(a), mesh(a), hierarchy(b), mesh(b), b_to_a(frame), tolerance,
                           options.descent);
    return collision_of(within_packed(packed[scene.bodies[a].mesh], mesh(a),
                                      packed[scene.bodies[b].mesh], mesh(b), b_to_a(frame),
                                      tolerance));
}

double SceneQuery::rounding(int frame) const {
    return distance_rounding(mesh_tree(a), mesh_tree(b), b_to_a(frame));
}

MeshTree SceneQuery::mesh_tree(std::size_t body) const {
    return {mesh(body), topology_of(hierarchy(body))};
}

QueryKind SceneQuery::query_kind() const {
    if (distance) return distance->kind();
    return is_self() ? QueryKind::self : QueryKind::collide;
}

DistanceSteps SceneQuery::distance_steps(const TraceHeader& header, const QueryTrace& frame) const {
    return scb::distance_steps(hierarchy(a), mesh(a), hierarchy(b), mesh(b), header, frame);
}

void SceneQuery::trace(int frame, QueryTrace& into) const {
    StepRecorder recorder;
    recorder.steps = std::move(into.steps);
    recorder.steps.volumes.clear();
    recorder.steps.items.clear();
    into.frame = frame;
    into.b_to_a = b_to_a(frame);
    into.nearest.reset();
    into.rounding = 0;
    if (!distance) {
        into.found = collide(frame, recorder);
    } else if (distance->within) {
        into.found = scb::within(hierarchy(a), mesh(a), hierarchy(b), mesh(b), into.b_to_a,
                                 *distance->within, options.descent, recorder);
    } else {
        const Distance found = scb::distance(hierarchy(a), mesh(a), hierarchy(b), mesh(b),
                                             into.b_to_a, distance->limits, recorder);
        into.found = {};
        into.found.n_v = found.n_v;
        into.found.n_p = found.n_p;
        into.found.n_u = found.n_u;
        into.found.stages = found.stages;
        if (found.triangles) {
            into.found.pairs = {*found.triangles};
            into.nearest = found.found;
        }
    }
    into.steps = std::move(recorder.steps);
}

void SceneQuery::choose(const BodyPair& pair) {
    std::tie(a, b) = std::pair(pair[0], pair[1]);
    if (is_self()) joined = joined_vertices(mesh(a));
}

std::vector<BodyPair> body_pairs(const scenes::Scene& scene, const std::string& names,
                                 QueriedBodies bodies) {
    const std::string known = name_list(scene.bodies, &scenes::Body::name);
    const std::string title =
        (scene.file.empty() ? "" : scene.file.string() + ": ") + "the scene '" + scene.name + "'";
    if (names.empty()) {
        if (scene.bodies.size() == 2) return {{0, 1}};
        if (scene.bodies.size() < 2)
            throw InputError(title +
                             " has one body, and a collision needs two; give a scene with two, or "
                             "two mesh files, or --bodies " +
                             scene.bodies[0].name + "," + scene.bodies[0].name +
                             " for the body against itself.");
        if (bodies == QueriedBodies::two)
            throw InputError(title + " has the bodies " + known +
                             "; name two of them with --bodies A,B.");
        std::vector<BodyPair> pairs;
        for (std::size_t a = 0; a < scene.bodies.size(); ++a)
            for (std::size_t b = a + 1; b < scene.bodies.size(); ++b) pairs.push_back({a, b});
        return pairs;
    }
    std::vector<BodyPair> pairs = pairs_named(scene, names);
    if (pairs.size() == 1) return pairs;
    if (pairs.size() > 1)
        throw InputError("--bodies " + names +
                         ": several pairs of bodies have these names, which contain commas; rename "
                         "a body in the scene file.");
    for (const std::string& name : split_list(names))
        if (!body_named(scene, name))
            throw InputError("--bodies " + names + ": '" + name + "' is not a body of the scene '" +
                             scene.name + "'; it has " + known + ".");
    throw InputError("--bodies " + names + ": give two bodies, such as " + scene.bodies[0].name +
                     "," + scene.bodies.back().name + "; one twice is the body against itself.");
}

SceneQuery open_query(const SceneOptions& scene, const HierarchyOptions& hierarchy,
                      const QueryOptions& query, const QueryLimits& limits, QueriedBodies bodies) {
    const VolumeKind kind = hierarchy.kind();
    SceneQuery result;
    result.options = query.collide();
    result.mutation = hierarchy.mutation;
    result.build = hierarchy.build();
    result.scene = scene.load(query.frames);
    if (query.distance && result.scene.bodies.size() < 2)
        throw InputError(scene.names[0] +
                         ": it has one body, and a distance is of two; give a scene with two, or "
                         "two mesh files.");
    result.pairs = body_pairs(result.scene, query.bodies, bodies);
    for (const scenes::Body& body : result.scene.bodies)
        if (result.scene.meshes[body.mesh].mesh.triangles.empty())
            throw InputError(scene.names[0] + ": of the objects of '" + body.name +
                             "' there are no triangles, and this program's hierarchies are of "
                             "triangles; ask for what was recorded.");
    result.choose(result.pairs.front());
    result.topologies = scenes::build_topologies(result.scene, result.build.topology());
    result.kind = kind;
    result.distance = query.distance;
    if (result.distance) {
        result.distance->limits.descent = query.descent;
        for (const BodyPair& pair : result.pairs)
            if (pair[0] == pair[1])
                throw InputError("--bodies " + query.bodies +
                                 ": the distance of a body from itself is 0; name two bodies.");
    }
    limits.apply(result.options, scenes::deepest(result.topologies));
    if (query.frames == auto_frames)
        result.frames = {result.scene.default_frame};
    else
        result.frames = frames_of(result.scene, query.frames);
    result.hierarchies = scenes::fit_meshes(result.topologies, kind, result.build);
    for (AnyHierarchy& fitted : result.hierarchies) mutate(result.mutation, fitted);
    return result;
}

TraceHeader trace_header(const SceneOptions& scene, const SceneQuery& query) {
    TraceHeader header;
    header.scb_version = SCB_VERSION;
    header.source = utf8_names(scene.names);
    header.scene = query.scene.name;
    header.kind = query.query_kind();
    if (query.distance) {
        header.distance = query.distance->limits;
        header.tolerance = query.distance->within.value_or(0);
    }
    for (std::size_t side = 0; side < 2; ++side) {
        const std::size_t body = side == 0 ? query.a : query.b;
        header.bodies[side] = {query.scene.bodies[body].name, fingerprint(query.mesh(body))};
    }
    header.volume = query.kind;
    header.growth = query.build.fit.growth;
    header.margin = query.build.fit.margin;
    header.split = query.build.split;
    header.options = query.options;
    return header;
}

namespace {

/// The largest coordinate of a body's position.
double farthest(const scenes::Scene& scene, const scenes::Motion& motion) {
    double most = 0;
    const auto add = [&most](const Pose& pose) {
        most = std::max(most, pose.translation.cwiseAbs().maxCoeff());
    };
    for (const scenes::PoseKey& key : motion.told) add(key.pose);
    // Other paths are straight.
    if (motion.told.empty())
        for (const int frame : {0, scene.frames - 1}) add(scenes::pose_at(motion, frame));
    return most;
}

/// Notes the body whose positions lose the most by rounding, if they lose much.
void note_far_poses(const scenes::Scene& scene, const Note& note) {
    constexpr double far = 1e7;
    const scenes::Body* worst = nullptr;
    double most = 0;
    for (const scenes::Body& body : scene.bodies) {
        const Box box = bounding_box(scene.meshes[body.mesh].mesh);
        const double coordinate = farthest(scene, body.motion);
        if (coordinate <= far * (box.upper - box.lower).norm() || coordinate <= most) continue;
        most = coordinate;
        worst = &body;
    }
    if (worst != nullptr)
        note("scb: " + worst->name +
             format(" is up to %.2g units from the origin; positions there "
                    "are exact only to %.1g units.",
                    most, std::nextafter(most, HUGE_VAL) - most));
}

}  // namespace

void note_poses(const SceneOptions& options, const scenes::Scene& scene, const Note& note) {
    note_far_poses(scene, note);
    if (options.names.size() == 2 && options.pose.empty() && options.poses.empty())
        note("scb: both bodies are at the same pose; --pose moves the second.");
    for (const scenes::Body& body : scene.bodies) {
        const scenes::Motion& motion = body.motion;
        const std::string most = format("%.2g at most", motion.correction);
        if (motion.correction > 0 && motion.log.empty())
            note(
                "scb: the pose of " + body.name +
                " is not quite a rotation; the nearest one is used, which changes its numbers by " +
                most + ".");
        if (motion.correction > 0 && !motion.log.empty())
            note("scb: some poses of " + body.name +
                 " are not quite rotations; the nearest ones are used, which changes their numbers "
                 "by " +
                 most + ", in " + motion.log.string() + ": line " +
                 std::to_string(motion.corrected_line) + ".");
    }
}

void note_doubts(const SceneOptions& options, const scenes::Scene& scene, const QueryOptions& query,
                 const std::vector<VolumeKind>& kinds, const Note& note) {
    note_poses(options, scene, note);
    if (options.is_recording())
        note("scb: of " + options.names[0] +
             " the meshes and poses are taken; the hierarchies are this project's own.");
    note_doubts(query, kinds, note);
}

}  // namespace scb::app
