#include "scenes/recordings/trace_block.h"

#include <zlib.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <new>

#include "core/distance/volume_gap.h"
#include "scb/any_distance.h"
#include "scenes/recordings/byte_stream.h"
#include "scenes/recordings/trace_answer.h"
#include "scenes/scene/scene.h"

namespace scb::scenes {
namespace {

// How a volume test ended, in the lower six bits of a byte. `divided` includes pairs that are left
// over.
enum Symbol : std::uint8_t { divided, leaves_apart, leaves_meet, rejected_first, neighbors = 62 };
constexpr std::uint8_t of_b = 0x80;     // set on the first test after a division of B's node
constexpr std::uint8_t is_root = 0x40;  // set on a root test of a self query
constexpr std::uint8_t symbol_bits = 0x3f;
static_assert(stage_count == 28 && static_cast<int>(Stage::overlapping) == 0,
              "stages are written as their numbers: another list needs another version, one that "
              "only grew does not");

std::uint8_t symbol_of(Stage outcome) {
    if (is_rejection(outcome))
        return static_cast<std::uint8_t>(rejected_first + static_cast<int>(outcome) - 1);
    switch (outcome) {
        case Stage::triangles_apart:
            return leaves_apart;
        case Stage::triangles_meet:
        case Stage::found:
            return leaves_meet;
        case Stage::neighbors:
            return neighbors;
        default:
            return divided;
    }
}

/// Writes the number that belongs to a node, if the reader does not know it yet.
void tell(ByteWriter& news, std::map<std::uint32_t, std::uint32_t>& known, std::uint32_t node,
          std::uint32_t value, std::uint32_t& last) {
    if (!known.try_emplace(node, value).second) return;
    news.signed_varint(static_cast<std::int64_t>(value) - last);
    last = value;
}

/// A query of distances divides pairs of nodes in an order that does not follow from the tests, and
/// measures triangles some time after the test of their leaves.
bool has_own_order(const TraceHeader& header) { return is_of_distance(header.kind); }

std::span<const Stage> stages_of(const TraceHeader& header) {
    return is_of_distance(header.kind) ? distance_stages(header.volume)
                                       : stages_of(header.volume, header.options.overlap);
}

/// N_u of a query with these tests.
std::uint64_t transform_count(const TraceHeader& header, const Collision& found) {
    if (!is_of_distance(header.kind))
        return transform_count(header.volume, found.stages, header.options.overlap);
    return found.n_v *
           with_volume_type(header.volume, []<Volume V>() { return transforms_per_gap<V>(); });
}

/// Rebuilds a frame's tests from symbols and news.
struct FrameBuilder {
    const TraceHeader& header;
    std::array<TraceNodes, 2>& nodes;
    ByteReader& news;
    QueryTrace& frame;
    ByteReader parents{{}};                ///< see has_own_order
    std::vector<std::uint32_t> pending{};  ///< tests whose pairs are divided later
    std::vector<bool> is_open{};           ///< the same by test, if queries have their own order
    std::uint32_t last_root = 0;
    std::set<std::uint32_t> roots{};
    std::string failure{};

    /// The number in [begin, end) that belongs to a node, and to no other node.
    std::uint32_t learn(std::map<std::uint32_t, std::uint32_t>& known,
                        std::set<std::uint32_t>& taken, std::uint32_t node, std::uint32_t& last,
                        std::uint32_t begin, std::uint32_t end) {
        const auto found = known.find(node);
        if (found != known.end()) return found->second;
        const std::int64_t change = news.signed_varint();
        const bool fits = change >= static_cast<std::int64_t>(begin) - last &&
                          change < static_cast<std::int64_t>(end) - last;
        if (!fits || !news.ok) {
            failure = "an index is out of range";
            return begin;
        }
        last = static_cast<std::uint32_t>(last + change);
        if (!taken.insert(last).second) failure = "two nodes share a child or a triangle";
        known.emplace(node, last);
        return last;
    }

    std::uint32_t triangle_of(std::size_t body, std::uint32_t node) {
        TraceNodes& n = nodes[body];
        if (n.left.contains(node)) failure = "a node is a leaf and is divided";
        return learn(n.triangle, n.triangles, node, n.last_triangle, 0,
                     header.bodies[body].mesh.triangles);
    }

    /// The left child; children come after their parents, two by two, the first pair at 1.
    std::uint32_t left_of(std::size_t body, std::uint32_t node) {
        TraceNodes& n = nodes[body];
        if (n.triangle.contains(node)) failure = "a node is a leaf and is divided";
        const std::uint32_t last_node = 2 * header.bodies[body].mesh.triangles - 2;
        const std::uint32_t left =
            learn(n.left, n.lefts, node, n.last_left, node + 1, std::max(node + 1, last_node));
        if (left % 2 == 0) failure = "an index is out of range";
        return left;
    }

    /// The test that was divided next; nothing, and a failure, if there is none.
    std::optional<std::uint32_t> next_parent() {
        if (!has_own_order(header)) {
            if (pending.empty()) {
                failure = "there are tests after the last one";
                return std::nullopt;
            }
            const std::uint32_t last = pending.back();
            pending.pop_back();
            return last;
        }
        const std::uint64_t back = parents.varint();
        const std::size_t next = frame.steps.volumes.size();
        if (back == 0 || back > next || !is_open[next - back]) {
            failure = "a test has a parent that was not divided";
            return std::nullopt;
        }
        is_open[next - back] = false;
        return static_cast<std::uint32_t>(next - back);
    }

    /// Whether pairs were left that a query divides before it ends.
    bool is_unfinished() const {
        // The smallest distance may be known before.
        if (header.kind == QueryKind::distance) return false;
        return !pending.empty() || std::find(is_open.begin(), is_open.end(), true) != is_open.end();
    }

    /// A root test of a self query: a left child against its sibling.
    void visit_root(std::uint8_t symbol) {
        if (header.kind != QueryKind::self || !pending.empty()) {
            failure = "a test without a parent stands within a query";
            return;
        }
        const std::int64_t change = news.signed_varint();
        const std::uint64_t depth = news.varint();
        const std::int64_t last_node = 2 * std::int64_t{header.bodies[0].mesh.triangles} - 2;
        if (change > last_node || change < -last_node) {
            failure = "an index is out of range";
            return;
        }
        const std::int64_t left = last_root + change;
        if (left < 1 || left % 2 == 0 || left + 1 > last_node ||
            !roots.insert(static_cast<std::uint32_t>(left)).second) {
            failure = "an index is out of range";
            return;
        }
        last_root = static_cast<std::uint32_t>(left);
        const int level = static_cast<int>(std::min<std::uint64_t>(depth, 0x10000));
        visit(symbol, {last_root, last_root + 1}, level, level, no_step);
    }

    void visit(std::uint8_t symbol, IndexPair pair, int depth_a, int depth_b,
               std::uint32_t parent) {
        Stage stage = Stage::overlapping;
        if (symbol >= rejected_first && symbol != neighbors) {
            const int number = symbol - rejected_first + 1;
            stage = static_cast<Stage>(number);
            const auto stages = stages_of(header);
            if (std::find(stages.begin(), stages.end(), stage) == stages.end())
                failure = "a stage does not belong to its overlap test";
        }
        if (depth_a > std::numeric_limits<std::uint16_t>::max() ||
            depth_b > std::numeric_limits<std::uint16_t>::max())
            failure = "a depth is out of range";
        const int stop = header.options.stop_level;
        if (stop >= 0 && (depth_a > stop || depth_b > stop ||
                          (symbol == divided && depth_a == stop && depth_b == stop)))
            failure = "there are tests below the level to stop at";
        if (!has_own_order(header) && frame.found.pairs.size() >= header.options.max_pairs)
            failure = "there are tests after the last pair";
        if (!failure.empty()) return;
        const auto step = static_cast<std::uint32_t>(frame.steps.volumes.size());
        frame.steps.volumes.push_back({pair, static_cast<std::uint16_t>(depth_a),
                                       static_cast<std::uint16_t>(depth_b), stage, parent});
        Collision& found = frame.found;
        ++found.n_v;
        ++found.stages[static_cast<std::size_t>(stage)];
        if (has_own_order(header)) {
            is_open.push_back(symbol == divided);
        } else {
            // Queries of distances do not count their depth.
            found.depth = std::max(found.depth, depth_a + depth_b);
            if (symbol == divided) pending.push_back(step);
        }
        if (symbol == neighbors && header.kind != QueryKind::self)
            failure = "there are neighbors in a query of two bodies";
        if (symbol != leaves_apart && symbol != leaves_meet && symbol != neighbors) return;
        if (header.options.stop_level >= 0) {
            if (symbol != leaves_meet)
                failure = "a test of triangles belongs to nodes that are no leaves";
            found.pairs.push_back(pair);
            return;
        }
        const IndexPair triangles = {triangle_of(0, pair.a), triangle_of(1, pair.b)};
        frame.steps.items.push_back({triangles, step, symbol == leaves_meet, symbol == neighbors});
        if (symbol == neighbors) return;
        ++found.n_p;
        if (symbol != leaves_meet || header.kind == QueryKind::distance) return;
        found.pairs.push_back(pair_of(header, frame.steps.items.back()));
    }
};

}  // namespace

std::vector<std::uint8_t> frame_bytes(const TraceHeader& header, const QueryTrace& frame,
                                      std::array<TraceNodes, 2>& nodes) {
    const Outcomes outcomes = outcomes_of(header, frame);
    const std::vector<Step>& tests = frame.steps.volumes;
    ByteWriter plain, parents, news;
    plain.varint(static_cast<std::uint64_t>(frame.frame));
    plain.varint(frame.found.n_u);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) plain.real(frame.b_to_a.rotation(row, column));
    for (int row = 0; row < 3; ++row) plain.real(frame.b_to_a.translation[row]);
    plain.varint(tests.size());
    std::size_t triangles = 0, siblings = 0;
    std::uint32_t last_root = 0;
    for (std::size_t i = 0; i < tests.size(); ++i) {
        std::uint8_t symbol = symbol_of(outcomes[i]);
        const std::uint32_t parent = tests[i].parent;
        if (parent == no_step && header.kind == QueryKind::self) {
            symbol |= is_root;
            news.signed_varint(std::int64_t{tests[i].nodes.a} - last_root);
            news.varint(tests[i].depth_a);
            last_root = tests[i].nodes.a;
        } else if (parent != no_step && siblings++ % 2 == 0) {
            parents.varint(i - parent);
            const IndexPair divided_pair = tests[parent].nodes;
            if (outcomes[parent] == Stage::divided_a) {
                tell(news, nodes[0].left, divided_pair.a, tests[i].nodes.a, nodes[0].last_left);
            } else {
                symbol |= of_b;
                tell(news, nodes[1].left, divided_pair.b, tests[i].nodes.b, nodes[1].last_left);
            }
        }
        plain.byte(symbol);
        if (outcomes[i] != Stage::triangles_apart && outcomes[i] != Stage::triangles_meet &&
            outcomes[i] != Stage::neighbors)
            continue;
        const IndexPair pair = frame.steps.items[triangles++].items;
        tell(news, nodes[0].triangle, tests[i].nodes.a, pair.a, nodes[0].last_triangle);
        tell(news, nodes[1].triangle, tests[i].nodes.b, pair.b, nodes[1].last_triangle);
    }
    if (has_own_order(header)) {
        plain.varint(parents.bytes.size());
        plain.append(parents.bytes);
    }
    plain.append(news.bytes);
    if (header.kind == QueryKind::distance) write_answer(plain, frame);
    return std::move(plain.bytes);
}

std::string read_frame(const TraceHeader& header, std::span<const std::uint8_t> bytes,
                       std::array<TraceNodes, 2>& nodes, QueryTrace& frame) {
    ByteReader plain{bytes};
    frame.steps.volumes.clear();
    frame.steps.items.clear();
    frame.found = {};
    frame.nearest.reset();
    frame.rounding = 0;
    const std::uint64_t number = plain.varint();
    frame.found.n_u = plain.varint();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            frame.b_to_a.rotation(row, column) = plain.real();
    for (int row = 0; row < 3; ++row) frame.b_to_a.translation[row] = plain.real();
    if (!(rigidity_defect(frame.b_to_a) < 1e-6) || !frame.b_to_a.translation.allFinite())
        return "a pose is not rigid";
    const auto symbols = plain.take(plain.varint());
    // If the triangles of the seed intersect, the query makes no test.
    const bool may_be_empty = header.kind == QueryKind::self || header.distance.seed;
    if (!plain.ok || (symbols.empty() && !may_be_empty)) return "a frame has no tests";
    if (number >= most_frames) return "the number of a frame is out of range";
    frame.frame = static_cast<int>(number);
    frame.steps.volumes.reserve(symbols.size());

    FrameBuilder builder{header, nodes, plain, frame};
    if (has_own_order(header)) builder.parents = {plain.take(plain.varint())};
    std::size_t next = 0;
    if (header.kind != QueryKind::self && !symbols.empty())
        builder.visit(symbols[next++], {0, 0}, 0, 0, no_step);
    bool is_cut = false;
    while (next < symbols.size() && builder.failure.empty()) {
        if ((symbols[next] & is_root) != 0) {
            builder.visit_root(symbols[next++] & symbol_bits);
            continue;
        }
        const std::optional<std::uint32_t> parent = builder.next_parent();
        if (!parent) return builder.failure;
        const Step p = frame.steps.volumes[*parent];
        const bool divides_a = (symbols[next] & of_b) == 0;
        const std::uint32_t left =
            divides_a ? builder.left_of(0, p.nodes.a) : builder.left_of(1, p.nodes.b);
        const int depth_a = p.depth_a + (divides_a ? 1 : 0),
                  depth_b = p.depth_b + (divides_a ? 0 : 1);
        is_cut = next + 1 == symbols.size();
        for (std::uint32_t child = 0; child < 2 && next < symbols.size(); ++child) {
            const std::uint8_t symbol =
                child == 0 ? symbols[next] & static_cast<std::uint8_t>(~of_b) : symbols[next];
            ++next;
            builder.visit(
                symbol,
                divides_a ? IndexPair{left + child, p.nodes.b} : IndexPair{p.nodes.a, left + child},
                depth_a, depth_b, *parent);
        }
    }
    if (!builder.failure.empty()) return builder.failure;
    if (header.kind == QueryKind::distance)
        if (std::string failure = read_answer(plain, header, frame); !failure.empty())
            return failure;
    if (!builder.parents.bytes.empty() || !plain.bytes.empty())
        return "a frame is longer than its tests";
    Collision& found = frame.found;
    found.complete = is_of_distance(header.kind) || found.pairs.size() < header.options.max_pairs;
    if (found.complete && (builder.is_unfinished() || is_cut))
        return "the tests end before the query did";
    if (found.n_u != transform_count(header, found)) return "its counts differ from its tests";
    std::sort(found.pairs.begin(), found.pairs.end());
    return {};
}

std::vector<std::uint8_t> pack(std::span<const std::uint8_t> plain) {
    std::vector<std::uint8_t> packed;
    for (const int strategy : {Z_DEFAULT_STRATEGY, Z_HUFFMAN_ONLY}) {
        z_stream stream{};
        constexpr int level = 6, window_bits = -15, memory_level = 8;
        if (deflateInit2(&stream, level, Z_DEFLATED, window_bits, memory_level, strategy) != Z_OK)
            throw std::bad_alloc();
        packed.resize(deflateBound(&stream, static_cast<uLong>(plain.size())));
        stream.next_in = const_cast<Bytef*>(plain.data());
        stream.avail_in = static_cast<uInt>(plain.size());
        stream.next_out = packed.data();
        stream.avail_out = static_cast<uInt>(packed.size());
        const int status = deflate(&stream, Z_FINISH);
        const std::size_t size = stream.total_out;
        deflateEnd(&stream);
        assert(status == Z_STREAM_END && "deflateBound is enough");
        static_cast<void>(status);
        packed.resize(size);
        // Huffman codes alone take at least a bit per byte.
        if (plain.size() <= most_unpacked * size + 1024) break;
    }
    return packed;
}

std::optional<std::vector<std::uint8_t>> unpack(std::span<const std::uint8_t> packed,
                                                std::size_t size) {
    if (size > most_unpacked * packed.size() + 1024 || packed.size() > (std::size_t{1} << 31))
        return std::nullopt;
    std::vector<std::uint8_t> plain(size);
    z_stream stream{};
    stream.next_in = const_cast<Bytef*>(packed.data());
    stream.avail_in = static_cast<uInt>(packed.size());
    if (inflateInit2(&stream, -15) != Z_OK) throw std::bad_alloc();
    stream.next_out = plain.data();
    stream.avail_out = static_cast<uInt>(plain.size());
    const int status = inflate(&stream, Z_FINISH);
    const bool whole = status == Z_STREAM_END && stream.avail_in == 0 && stream.avail_out == 0;
    inflateEnd(&stream);
    if (!whole) return std::nullopt;
    return plain;
}

std::uint32_t checksum(std::span<const std::uint8_t> bytes) {
    return static_cast<std::uint32_t>(crc32_z(0, bytes.data(), bytes.size()));
}

}  // namespace scb::scenes
