#include "core/analysis/trace.h"

#include <algorithm>
#include <bit>
#include <charconv>

#include "core/base/text_format.h"
#include "core/base/word_hash.h"
#include "core/collide/index_pairs.h"

namespace scb {
namespace {

std::string number(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

std::string text_of(const MeshFingerprint& mesh) {
    if (mesh.triangles == 0) return "none, but objects";
    return counted(mesh.triangles, "triangle", "triangles") + ", " +
           counted(mesh.vertices, "vertex", "vertices") + ", hash " + hash_text(mesh.hash);
}

}  // namespace

MeshFingerprint fingerprint(const Mesh& mesh) {
    WordHash hash;
    for (const Vec3& v : mesh.vertices)
        for (int i = 0; i < 3; ++i) hash.add(std::bit_cast<std::uint64_t>(v[i]));
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t corner : t) hash.add(corner);
    return {static_cast<std::uint32_t>(mesh.triangles.size()),
            static_cast<std::uint32_t>(mesh.vertices.size()), hash.value};
}

BodyNames body_names(const TraceHeader& header) {
    return {header.bodies[0].name, header.bodies[1].name};
}

BodyNames side_names(const TraceHeader& header) {
    return header.kind == QueryKind::self ? BodyNames{"A", "B"} : body_names(header);
}

BuildOptions build_options(const TraceHeader& header) {
    BuildOptions options;
    options.fit.growth = header.growth;
    options.fit.margin = header.margin;
    options.split = header.split;
    return options;
}

bool is_of_distance(QueryKind kind) {
    return kind == QueryKind::distance || kind == QueryKind::within;
}

bool pairs_are_nodes(const TraceHeader& header) {
    return header.engine ? header.engine->objects : header.options.stop_level >= 0;
}

std::string stage_words(const TraceHeader& header, Stage stage) {
    return std::string(header.stages.row(stage).name);
}

Outcomes outcomes_of(const TraceHeader& header, const QueryTrace& frame) {
    const auto nodes =
        pairs_are_nodes(header) ? std::span(frame.found.pairs) : std::span<const IndexPair>();
    return outcomes_of(frame.steps, nodes);
}

IndexPair pair_of(const TraceHeader& header, const ItemStep& test) {
    const auto [a, b] = test.items;
    return header.kind == QueryKind::self && b < a ? IndexPair{b, a} : test.items;
}

IndexPair numbers_of(const QueryTrace& frame, IndexPair nodes) {
    const auto& [a, b] = frame.trees;
    return {a ? a->number(nodes.a) : nodes.a, b ? b->number(nodes.b) : nodes.b};
}

std::optional<IndexPair> nodes_of(const QueryTrace& frame, IndexPair numbers) {
    const auto& [a, b] = frame.trees;
    const IndexPair nodes{a ? a->node_of(numbers.a) : numbers.a,
                          b ? b->node_of(numbers.b) : numbers.b};
    if (nodes.a == no_index || nodes.b == no_index) return std::nullopt;
    return nodes;
}

bool same_meshes(const TraceHeader& a, const TraceHeader& b) {
    const bool roughly = a.engine || b.engine;
    for (std::size_t side = 0; side < 2; ++side) {
        const MeshFingerprint &of_a = a.bodies[side].mesh, &of_b = b.bodies[side].mesh;
        if (roughly ? of_a.triangles != of_b.triangles || of_a.vertices != of_b.vertices
                    : of_a != of_b)
            return false;
    }
    return true;
}

std::optional<int> other_tree_at(const TraceEngine& a, const TraceEngine& b, std::size_t side) {
    for (const auto& [frame, trees] : a.trees)
        if (const auto of_b = b.trees.find(frame);
            of_b != b.trees.end() && of_b->second[side] != trees[side])
            return frame;
    return std::nullopt;
}

bool same_nodes(const TraceHeader& a, const TraceHeader& b) {
    if (a.engine && b.engine)
        return !other_tree_at(*a.engine, *b.engine, 0) && !other_tree_at(*a.engine, *b.engine, 1);
    return !a.engine && !b.engine && a.split == b.split;
}

std::vector<TraceField> fields_of(const TraceHeader& header) {
    const CollideOptions& options = header.options;
    std::vector<TraceField> fields = {{"scene", header.scene},
                                      {"body A", header.bodies[0].name},
                                      {"body B", header.bodies[1].name},
                                      {"mesh of A", text_of(header.bodies[0].mesh)},
                                      {"mesh of B", text_of(header.bodies[1].mesh)}};
    if (header.engine) {
        fields.push_back({"engine", header.engine->name});
        fields.push_back({"volume", header.engine->volumes});
        for (std::size_t side = 0; side < 2 && !header.engine->trees.empty(); ++side)
            fields.push_back({side == 0 ? "tree of A" : "tree of B",
                              hash_text(header.engine->trees.begin()->second[side])});
        // Settings with the name of one of these fields are left out.
        for (const TraceField& setting : header.engine->settings)
            if (std::none_of(fields.begin(), fields.end(), [&setting](const TraceField& field) {
                    return field.name == setting.name;
                }))
                fields.push_back(setting);
        return fields;
    }
    if (header.kind != QueryKind::collide)
        fields.push_back({"query", std::string(query_kind_name(header.kind))});
    fields.push_back({"split", std::string(split_method_name(header.split))});
    fields.push_back({"volume", std::string(volume_kind_name(header.volume))});
    // Only options that affect these volumes.
    if (has_growth(header.volume))
        fields.push_back({"growth", std::string(ball_growth_name(header.growth))});
    if (has_margin(header.volume)) fields.push_back({"margin", number(header.margin)});
    if (header.volume == VolumeKind::scb && !is_of_distance(header.kind)) {
        fields.push_back({"test", std::string(overlap_test_name(options.overlap.test))});
        if (has_threshold(options.overlap.test))
            fields.push_back({"threshold", number(options.overlap.threshold)});
    }
    fields.push_back({"descent", std::string(descent_rule_name(options.descent))});
    if (header.kind == QueryKind::distance) {
        fields.push_back({"order", std::string(distance_order_name(header.distance.order))});
        fields.push_back({"relative error", number(header.distance.relative_error)});
        fields.push_back({"limit", number(header.distance.limit)});
        // Only what commands set rarely, or not at all.
        if (header.distance.order == DistanceOrder::hybrid &&
            header.distance.heap != DistanceOptions{}.heap)
            fields.push_back({"heap", std::to_string(header.distance.heap)});
        if (header.distance.enough >= 0)
            fields.push_back({"ends at", number(header.distance.enough)});
        if (const auto& seed = header.distance.seed)
            fields.push_back(
                {"begins with", std::to_string(seed->a) + ", " + std::to_string(seed->b)});
    }
    if (header.kind == QueryKind::within) fields.push_back({"tolerance", number(header.tolerance)});
    if (is_of_distance(header.kind)) return fields;
    fields.push_back({"max pairs", std::to_string(options.max_pairs)});
    fields.push_back(
        {"level", options.stop_level < 0 ? "none" : std::to_string(options.stop_level)});
    return fields;
}

}  // namespace scb
