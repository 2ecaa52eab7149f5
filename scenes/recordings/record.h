#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace scb::scenes {

// The records of a recording, as scb_record.h writes them and README.md of this folder describes
// them. They are not validated, since recordings of broken engines are read, too.

/// No mesh, no parent.
inline constexpr std::uint32_t record_none = UINT32_MAX;

/// The first byte of a record. Tags below `items_apart` are tests of two volumes, by the stage at
/// which they ended.
enum class RecordTag : std::uint8_t {
    volumes_overlap = 0,
    items_apart = 128,
    items_meet = 129,
    pair = 130,
    parent = 131,
    length = 132,
    setting = 192,
    stage,
    mesh,
    tree,
    node,
    refit,
    body,
    frame,
    pose,
    query,
    query_end,
    end,
    object,
    log,
    measure,
    answer,
};
/// Records from this tag on have a length; all others have 9 bytes.
inline constexpr std::uint8_t first_long_tag = 192;

/// A test of two volumes or of two items (triangles, objects), a pair that a query reported, or
/// a fact about the next test. `parent`: `a` is the number of the next test's parent in the query,
/// from 0. `length`: the bound or distance of the next test, see length_of.
struct RecordedEvent {
    std::uint8_t tag = 0;
    std::uint32_t a = 0, b = 0;

    bool operator==(const RecordedEvent&) const = default;
};

/// The bound of the next test of volumes, or the distance of the next test of items; any bits.
inline RecordedEvent recorded_length(double length) {
    const auto bits = std::bit_cast<std::uint64_t>(length);
    return {static_cast<std::uint8_t>(RecordTag::length), static_cast<std::uint32_t>(bits),
            static_cast<std::uint32_t>(bits >> 32)};
}
inline double length_of(const RecordedEvent& event) {
    return std::bit_cast<double>(std::uint64_t{event.b} << 32 | event.a);
}

struct RecordedSetting {
    std::string key, value;

    bool operator==(const RecordedSetting&) const = default;
};

/// The name of a stage, 1 to 127, at which tests of two volumes reject.
struct RecordedStage {
    std::uint8_t stage = 0;
    std::string name;

    bool operator==(const RecordedStage&) const = default;
};

struct RecordedMesh {
    std::uint32_t mesh = 0;
    std::string name;
    std::uint8_t coordinate_bytes = 8;   ///< 4 or 8, as the engine had them
    std::vector<double> coordinates;     ///< three per vertex
    std::vector<std::uint32_t> indices;  ///< three per triangle

    bool operator==(const RecordedMesh&) const = default;
};

/// The kinds of volumes, and their numbers.
enum class RecordedKind : std::uint8_t {
    none,
    aabb,     ///< lower corner, upper corner
    obb,      ///< center, three axes, half sides
    ball,     ///< center, radius
    capsule,  ///< two ends, radius
    rss,      ///< a corner of the rectangle, its two sides, radius
    kdop,     ///< per direction d of the tree, the least and the greatest x.d
    scb,      ///< center, radius, normal, e, f
    scb2,     ///< the same, second normal, its e, its f
    hull,     ///< points
};
inline constexpr std::size_t recorded_kind_count = 10;

struct RecordedVolume {
    RecordedKind kind = RecordedKind::none;
    std::vector<double> values;

    bool operator==(const RecordedVolume&) const = default;
};

/// A tree, or the same tree built anew: the nodes follow.
struct RecordedTree {
    std::uint32_t tree = 0, mesh = record_none;
    std::string name;
    std::vector<double> directions;  ///< of its k-DOPs, three numbers each

    bool operator==(const RecordedTree&) const = default;
};

struct RecordedNode {
    std::uint32_t tree = 0, node = 0, parent = record_none;
    std::uint64_t id = 0;  ///< the engine's own identity of the node
    std::string name;
    std::vector<std::uint32_t> children, items;
    RecordedVolume volume;

    bool operator==(const RecordedNode&) const = default;
};

/// The volume of a node from here on.
struct RecordedRefit {
    std::uint32_t tree = 0, node = 0;
    RecordedVolume volume;

    bool operator==(const RecordedRefit&) const = default;
};

/// The extent of an object, in the frame of the tree whose leaf has it, from here on.
struct RecordedObject {
    std::uint32_t tree = 0, object = 0;
    RecordedVolume volume;

    bool operator==(const RecordedObject&) const = default;
};

struct RecordedBody {
    std::uint32_t body = 0, tree = 0;
    std::string name;

    bool operator==(const RecordedBody&) const = default;
};

struct RecordedFrame {
    std::uint32_t frame = 0;

    bool operator==(const RecordedFrame&) const = default;
};

/// Where a body is from here on: the rows of [R|t].
struct RecordedPose {
    std::uint32_t body = 0;
    std::array<double, 12> rows{};

    bool operator==(const RecordedPose&) const = default;
};

/// A query of two bodies begins; events follow.
struct RecordedQuery {
    std::uint32_t body_a = 0, body_b = 0;
    bool has_label = false;  ///< the record has a name and tags, which may be empty
    std::string name{};      ///< the engine's own
    std::vector<std::string> tags{};

    bool operator==(const RecordedQuery&) const = default;
};

struct RecordedQueryEnd {
    std::uint8_t complete = 1;      ///< 0: the query did not find all pairs
    std::uint64_t nanoseconds = 0;  ///< 0: not measured

    bool operator==(const RecordedQueryEnd&) const = default;
};

/// A line of the engine's log, in the current frame.
struct RecordedLog {
    std::string text;

    bool operator==(const RecordedLog&) const = default;
};

/// What a query measures.
enum class RecordedAim : std::uint8_t { overlap, distance, within };
inline constexpr std::size_t recorded_aim_count = 3;

/// The current query measures distances.
struct RecordedMeasure {
    std::uint8_t aim = 0;       ///< a RecordedAim
    double limit = HUGE_VAL;    ///< nothing beyond this distance is looked for
    double relative_error = 0;  ///< the answer may be so much too large

    bool operator==(const RecordedMeasure&) const = default;
};

/// The distance that the current query found.
struct RecordedAnswer {
    double distance = 0;
    std::uint32_t item_a = record_none, item_b = record_none;
    std::vector<double> points;  ///< a point of A and a point of B in the world; or empty

    bool operator==(const RecordedAnswer&) const = default;
};

/// The recorder was closed.
struct RecordedEnd {
    bool operator==(const RecordedEnd&) const = default;
};

/// A record of a newer version: kept as it is.
struct RecordedUnknown {
    std::uint8_t tag = 0;
    std::vector<std::uint8_t> bytes;

    bool operator==(const RecordedUnknown&) const = default;
};

struct Record
    : std::variant<RecordedEvent, RecordedSetting, RecordedStage, RecordedMesh, RecordedTree,
                   RecordedNode, RecordedRefit, RecordedBody, RecordedFrame, RecordedPose,
                   RecordedQuery, RecordedQueryEnd, RecordedEnd, RecordedObject, RecordedLog,
                   RecordedMeasure, RecordedAnswer, RecordedUnknown> {
    using variant::variant;

    /// Bytes that a newer version appended to the record.
    std::vector<std::uint8_t> appended{};

    bool operator==(const Record&) const = default;
};

}  // namespace scb::scenes
