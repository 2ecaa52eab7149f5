#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/trace.h"
#include "scenes/recordings/byte_stream.h"

namespace scb::scenes {

// A trace has every test of this program's own queries. It names the scene in place of meshes and
// hierarchies. Its file is a compact recording (`.scbrec`), see recording_block.h:
//
//     head       the parameters of the queries
//     step       per frame, deflated
//     data       one record, the end, so that a truncated file is noticed
//
// A step has one byte per volume test: how the test ended, whether its triangles intersect, and
// which of the two nodes was divided to get there. Nodes and depths follow from the order of a
// traversal, each node's children and each leaf's triangle. The latter two are written where they
// are first needed, so frames must be read in order. A test takes 0.41 bytes in `spheres-l1` (500
// frames, symmetric, 8.8 million tests).
//
// Queries of distances divide pairs in an order of their own, so their steps also have how many
// tests each pair of children is behind its parent. For the smallest distance, a step ends with the
// distance, its triangles and points, and the rounding of the distance.
//
// scb 1.0 wrote trace files (`.scbtrace`), which are still read. Numbers as in byte_stream.h:
//
//     magic      the eight bytes 89 's' 'c' 'b' 't' 'r' 0d 0a
//     version    fixed32, 1
//     header     its length (varint), then the parameters
//     frames     per frame the length of its block packed and unpacked (varints), and the block,
//                deflated; a packed length of 0 ends the frames
//     checksum   fixed32: zlib's CRC-32 of all bytes before it

/// Whether the bytes start as a trace does, of this version or of 1.0. `compact_start` bytes are
/// enough.
bool starts_as_trace(std::span<const std::uint8_t> bytes);

/// For one body, the links of the nodes met so far.
struct TraceNodes {
    // Not hashed: a file could choose its nodes so that all have one hash.
    std::map<std::uint32_t, std::uint32_t> left;      ///< of divided nodes
    std::map<std::uint32_t, std::uint32_t> triangle;  ///< of leaves
    std::set<std::uint32_t> lefts, triangles;         ///< for a reader: numbers in use
    std::uint32_t last_left = 0, last_triangle = 0;   ///< the latest numbers
};

/// Turns a trace into the bytes of a file, frame by frame: memory holds these bytes and one frame.
/// The same trace always gives the same bytes (with the same zlib).
class TraceWriter {
  public:
    explicit TraceWriter(const TraceHeader& header);

    /// Frames must be added ascending by number, each once, as recorded by collide, distance or
    /// within: counts other than N_u are not stored, since they follow from the tests. Throws
    /// InputError if the frame has more than 2^31 volume tests, or takes more than 2^31 bytes.
    void add(const QueryTrace& frame);
    /// The whole file. Nothing may be added after it.
    std::vector<std::uint8_t> finish();

  private:
    TraceHeader header_;
    std::array<TraceNodes, 2> nodes_;
    ByteWriter out_;
};

/// Reads a trace from the bytes of a file, frame by frame: memory holds one frame.
///
/// Throws InputError, one sentence that starts with `name`, if the bytes are no trace, truncated,
/// longer than a trace, written by a newer scb, do not fit their checksum, or contradict
/// themselves. The constructor finds all of these except contradictions, which only a made-up file
/// has and `next` may find. The results can be trusted: node and triangle indices are within the
/// meshes of the header, frames ascend, the tests form a traversal. A file of n bytes takes O(n log
/// n) time and O(n) memory, and no block unpacks to more than 16 times its size plus 1024 bytes.
class TraceReader {
  public:
    /// `bytes` must outlive the reader.
    TraceReader(std::span<const std::uint8_t> bytes, std::string_view name);

    const TraceHeader& header() const { return header_; }
    /// The next frame, which the next call overwrites; nullptr at the end.
    const QueryTrace* next();

  private:
    /// A frame, deflated.
    struct PackedFrame {
        std::span<const std::uint8_t> packed;
        std::uint64_t plain_size = 0;
    };

    /// Both find the frames, and return the bytes of the header.
    std::span<const std::uint8_t> read_compact(std::string_view bytes);
    std::span<const std::uint8_t> read_version_1_0(std::span<const std::uint8_t> bytes);
    [[noreturn]] void refuse_truncated() const;
    [[noreturn]] void refuse_damaged() const;
    [[noreturn]] void refuse_longer(std::size_t bytes) const;
    [[noreturn]] void contradict(const std::string& what) const;

    std::string name_;
    TraceHeader header_;
    std::vector<PackedFrame> frames_;
    std::size_t next_ = 0;
    std::array<TraceNodes, 2> nodes_;
    QueryTrace frame_;
    int last_frame_ = -1;
};

/// A whole trace at once.
std::vector<std::uint8_t> encode_trace(const Trace& trace);
Trace decode_trace(std::span<const std::uint8_t> bytes, std::string_view name);

}  // namespace scb::scenes
