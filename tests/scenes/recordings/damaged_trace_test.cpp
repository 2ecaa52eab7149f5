#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/base/random.h"
#include "tests/scenes/recordings/recording_block.h"
#include "tests/scenes/recordings/trace_bytes.h"

namespace scb::scenes {
namespace {

/// A small trace, and the same as a file of scb 1.0.
std::array<Bytes, 2> both_files() {
    const Trace trace = small_trace();
    return {encode_trace(trace), trace_file_1_0(trace.header, plain_frames(trace))};
}

TEST(DamagedTrace, TruncatedAtEveryByte) {
    for (const Bytes& bytes : both_files())
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            const Bytes part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
            const std::string sentence = refusal_of(part);
            expect_in(size == 0 ? "file.scbrec is not a trace of scb" : "file.scbrec is truncated",
                      sentence);
        }
}

TEST(DamagedTrace, ForeignNewerLongerDamaged) {
    const std::string text = "solid cube\nfacet normal 0 0 1\n";
    expect_in("is not a trace of scb", refusal_of(Bytes(text.begin(), text.end())));
    const std::string recording = recording_with_block("\xcb\x01");
    expect_in("is not a trace of scb, but a recording of another engine",
              refusal_of(Bytes(recording.begin(), recording.end())));
    for (const Bytes& bytes : both_files()) {
        Bytes newer = bytes;
        newer[8] = 7;
        expect_in("of version 7", refusal_of(newer));
        Bytes longer = bytes;
        longer.insert(longer.end(), 3, 0);
        expect_in("3 bytes after its end", refusal_of(longer));
        Bytes damaged = bytes;
        damaged[bytes.size() / 2] ^= 4;
        expect_in("checksum", refusal_of(damaged));
    }
}

TEST(DamagedTrace, BlocksOfNewerVersionsAreSkippedAndRecordsAreRefused) {
    const Trace trace = small_trace();
    const Bytes bytes = encode_trace(trace);
    constexpr std::size_t end_size = 17;
    for (const std::string_view kind : {"news", "data"}) {
        ByteWriter out{Bytes(bytes.begin(), bytes.end() - end_size)};
        add_block(out, kind, as_bytes("anything"));
        out.append(std::span(bytes).last(end_size));
        if (kind == "news")
            expect_same(trace, decode_trace(out.bytes, "file"));
        else
            expect_in("it has data besides its queries", refusal_of(out.bytes));
    }
}

TEST(DamagedTrace, EveryFlippedBitIsNoticed) {
    for (const Bytes& bytes : both_files())
        for (std::size_t i = 0; i < bytes.size(); ++i)
            for (int bit = 0; bit < 8; ++bit) {
                Bytes flipped = bytes;
                flipped[i] ^= static_cast<std::uint8_t>(1 << bit);
                EXPECT_THROW(decode_trace(flipped, "file"), InputError) << i << " " << bit;
            }
}

/// Reads bytes that somebody made up: they are refused, or are a trace that keeps every promise.
/// Whether they were accepted.
bool survives(const Bytes& bytes) {
    Trace trace;
    try {
        trace = decode_trace(bytes, "file");
    } catch (const InputError&) {
        return false;
    }
    int last = -1;
    for (const QueryTrace& frame : trace.frames) {
        EXPECT_GT(frame.frame, last);
        last = frame.frame;
        const auto& bodies = trace.header.bodies;
        for (const Step& test : frame.steps.volumes) {
            EXPECT_LE(test.nodes.a, 2 * bodies[0].mesh.triangles - 2);
            EXPECT_LE(test.nodes.b, 2 * bodies[1].mesh.triangles - 2);
            EXPECT_LT(static_cast<std::size_t>(test.stage), stage_count);
        }
        for (const ItemStep& test : frame.steps.items) {
            EXPECT_LT(test.items.a, bodies[0].mesh.triangles);
            EXPECT_LT(test.items.b, bodies[1].mesh.triangles);
            EXPECT_LT(test.step, frame.steps.volumes.size());
        }
        if (frame.nearest) {
            EXPECT_EQ(frame.found.pairs.size(), 1u);
            EXPECT_LE(frame.nearest->distance, trace.header.distance.limit);
            EXPECT_GE(frame.nearest->distance, 0);
            EXPECT_TRUE(frame.nearest->point_a.allFinite() && frame.nearest->point_b.allFinite());
        }
        EXPECT_EQ(std::adjacent_find(frame.found.pairs.begin(), frame.found.pairs.end()),
                  frame.found.pairs.end());
        const Outcomes outcomes = outcomes_of(trace.header, frame);
        EXPECT_EQ(outcomes.size(), frame.steps.volumes.size());
    }
    EXPECT_TRUE(diff(trace, trace).equal());
    expect_same(trace, decode_trace(encode_trace(trace), "file"));
    return true;
}

TEST(DamagedTrace, MadeUpFilesAreRefusedOrRead) {
    const auto [compact, of_1_0] = both_files();
    for (const Bytes& bytes : {compact, of_1_0})
        for (std::size_t i = 0; i + 4 < bytes.size(); ++i)
            for (int bit = 0; bit < 8; ++bit) {
                Bytes flipped = bytes;
                flipped[i] ^= static_cast<std::uint8_t>(1 << bit);
                survives(bytes == compact ? with_fitting_checksums(flipped)
                                          : resealed_1_0(flipped));
            }
}

/// Changes some bytes of the frames, again and again.
void expect_safe(const Trace& trace, int trials) {
    const std::vector<Bytes> blocks = plain_frames(trace);
    ASSERT_EQ(file_of(trace.header, blocks), encode_trace(trace));
    Random random(5);
    int accepted = 0, refused = 0;
    for (int trial = 0; trial < trials; ++trial) {
        std::vector<Bytes> changed = blocks;
        for (std::uint32_t changes = 1 + random.below(3); changes > 0; --changes) {
            Bytes& block = changed[random.below(3)];
            const std::uint32_t at = random.below(static_cast<std::uint32_t>(block.size()));
            const auto value = static_cast<std::uint8_t>(random.below(256));
            const std::uint32_t what = random.below(4);
            if (what == 0) block.erase(block.begin() + at);
            if (what == 1) block.insert(block.begin() + at, value);
            if (what == 2) block[at] = value;
            if (what == 3) block[at] ^= static_cast<std::uint8_t>(1 << value % 8);
            if (block.empty()) block.push_back(value);
        }
        ++(survives(file_of(trace.header, changed)) ? accepted : refused);
    }
    EXPECT_GT(accepted, 0);
    EXPECT_GT(refused, trials / 3);
}

TEST(DamagedTrace, MadeUpFramesAreRefusedOrRead) {
    for (const int level : {-1, 4}) {
        TraceHeader header = asking(VolumeKind::scb, OverlapTest::symmetric);
        header.options.stop_level = level;
        expect_safe(small_trace(header), 3000);
    }
}

TEST(DamagedTrace, MadeUpDistancesAreRefusedOrRead) {
    std::vector<Trace> traces = distance_traces(VolumeKind::scb2);
    traces.pop_back();  // it has one frame
    for (const Trace& trace : traces) expect_safe(trace, 500);
}

TEST(DamagedTrace, MadeUpLimitsAreRefusedOrRead) {
    for (const Trace& trace : distance_traces(VolumeKind::ball)) {
        Trace without_frames = trace;
        without_frames.frames.clear();
        const Bytes bytes = encode_trace(without_frames);
        for (std::size_t i = 0; i + 4 < bytes.size(); ++i)
            for (int bit = 0; bit < 8; ++bit) {
                Bytes flipped = bytes;
                flipped[i] ^= static_cast<std::uint8_t>(1 << bit);
                survives(with_fitting_checksums(flipped));
            }
    }
}

TEST(DamagedTrace, LengthsThatNobodyWroteAreRefusedAtOnce) {
    const Trace trace = small_trace();
    const Bytes packed = pack(Bytes(500, 1));
    for (const std::uint64_t length : {std::uint64_t{1} << 20, std::uint64_t{1} << 34,
                                       ~std::uint64_t{0} >> 1, ~std::uint64_t{0}}) {
        ByteWriter start;
        begin_recording(start);
        add_block(start, head_block, header_bytes(trace.header));

        ByteWriter content;
        content.fixed32(static_cast<std::uint32_t>(std::min<std::uint64_t>(length, UINT32_MAX)));
        content.append(packed);
        ByteWriter too_large = start;
        add_block(too_large, step_block, content.bytes);
        add_block(too_large, data_block, Bytes{203, 0, 0, 0, 0});
        expect_in("is not a valid trace", refusal_of(too_large.bytes));

        ByteWriter block = start;
        block.fixed32(static_cast<std::uint32_t>(std::min<std::uint64_t>(length, UINT32_MAX)));
        block.append(as_bytes(step_block));
        block.append(content.bytes);
        expect_in("is truncated", refusal_of(block.bytes));

        const Bytes empty = trace_file_1_0(trace.header, {});
        for (const bool of_unpacked : {true, false}) {
            ByteWriter old{Bytes(empty.begin(), empty.end() - 5)};
            old.varint(of_unpacked ? packed.size() : length);
            old.varint(of_unpacked ? length : 500);
            old.append(packed);
            old.varint(0);
            old.fixed32(0);
            expect_in(of_unpacked ? "is not a valid trace" : "is truncated",
                      refusal_of(resealed_1_0(old.bytes)));
        }

        ByteWriter tests;
        tests.varint(1);
        tests.varint(1);
        for (const double d : {1., 0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0.}) tests.real(d);
        tests.varint(length);
        expect_in("a frame has no tests", refusal_of(file_of(trace.header, {tests.bytes})));
    }
}

/// A frame of these symbols (0: divided, 1: leaves, 2: leaves that meet, 3: rejected; 128 more
/// where B's node was divided) and the differences of indices that come after them. `more_n_u` is
/// what its N_u is off by.
Bytes made_up(const Bytes& symbols, const Bytes& indices, int more_n_u = 0) {
    constexpr std::uint8_t ball_ball = 3, slab_ball = 4;  // without B's normal
    ByteWriter block;
    block.varint(1);
    int n_u = more_n_u;
    for (const std::uint8_t symbol : symbols)
        n_u += (symbol & 127) == ball_ball || (symbol & 127) == slab_ball ? 1 : 2;
    block.varint(static_cast<std::uint64_t>(n_u));
    for (const double d : {1., 0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0.}) block.real(d);
    block.text(std::string(symbols.begin(), symbols.end()));
    for (const std::uint8_t index : indices) block.signed_varint(index);
    return block.bytes;
}

TEST(DamagedTrace, ContradictionsAreNamed) {
    const TraceHeader header = small_trace().header;
    TraceHeader first = header, level = header, root = header, no_triangles = header,
                margin = header, threshold = header;
    root.options.stop_level = 0;
    margin.margin = -0.5;
    threshold.options.overlap.threshold = 1.5;
    first.options.max_pairs = 1;
    level.options.stop_level = 3;
    no_triangles.bodies[1].mesh.triangles = 0;
    // The nodes 0, 1 and 2 of A are divided: their children are 1, 3 and 5.
    const Bytes twice = {0, 0, 0, 3, 3, 3, 3};
    struct Case {
        TraceHeader header;
        Bytes block;
        std::string failure;  // empty: there is none
    };
    const std::vector<Case> cases = {
        {header, made_up(twice, {1, 2, 2}), ""},
        {header, made_up(twice, {1, 2, 234}), ""},
        {header, made_up(twice, {1, 2, 0}), "share a child"},
        {header, made_up(twice, {1, 2, 1}), "out of range"},
        {header, made_up(twice, {0, 2, 2}), "out of range"},
        {header, made_up(twice, {1, 2, 236}), "out of range"},
        {header, made_up(twice, {1, 2}), "out of range"},
        {header, made_up(twice, {1, 2, 2, 0}), "longer than its tests"},
        {header, made_up({0, 3, 3, 3, 3}, {1}), "tests after the last one"},
        {header, made_up({0, 0, 3}, {1}), "tests end before the query did"},
        {header, made_up({0, 3}, {1}), "tests end before the query did"},
        {header, made_up({0, 26, 3}, {1}), "a stage does not belong to its overlap test"},
        {header, made_up({0, 1, 2}, {1, 0, 0, 1}), ""},
        {header, made_up({0, 1, 2}, {1, 0, 0, 0}), "share a child or a triangle"},
        {header, made_up({0, 1, 2}, {1, 119, 0, 1}), "out of range"},
        // B's node 0 is a leaf beside A's node 2, and divided beside A's node 1.
        {header, made_up({0, 0, 2, 131, 3}, {1, 0, 0, 1}), "a leaf and is divided"},
        {header, made_up({0, 2, 0, 131, 3}, {1, 0, 0, 1}), "a leaf and is divided"},
        {header, made_up({0, 0, 0, 131, 3, 2, 3}, {1, 1, 2, 0, 0}), "a leaf and is divided"},
        {first, made_up({0, 2}, {1, 0, 0}), ""},
        {first, made_up({0, 2, 2}, {1, 0, 0, 1}), "tests after the last pair"},
        {level, made_up({0, 2, 2}, {1}), ""},
        {root, made_up({2}, {}), ""},
        {root, made_up({0, 2, 2}, {1}), "below the level to stop at"},
        {header, made_up({0, 8, 3}, {1}), "a stage does not belong to its overlap test"},
        {header, made_up({0, 3, 3}, {1}, 1), "its counts differ from its tests"},
        {margin, made_up({3}, {}), "its header cannot be read"},
        {threshold, made_up({3}, {}), "its header cannot be read"},
        {level, made_up({0, 2, 1}, {1}), "belongs to nodes that are no leaves"},
        {no_triangles, made_up({3}, {}), "its header cannot be read"},
    };
    for (std::size_t i = 0; i < cases.size(); ++i) {
        SCOPED_TRACE(i);
        const Bytes bytes = file_of(cases[i].header, {cases[i].block});
        if (cases[i].failure.empty())
            EXPECT_TRUE(survives(bytes));
        else
            expect_in(cases[i].failure, refusal_of(bytes));
    }
}

/// A trace of one query of a distance with a change, written as it is.
std::string refusal_after(const std::function<void(TraceHeader&, QueryTrace&)>& change) {
    Trace trace = record_trace(soup_a(), soup_b(), asking_distance(VolumeKind::scb2), {20}, -0.1);
    change(trace.header, trace.frames[0]);
    return refusal_of(encode_trace(trace));
}

TEST(DamagedTrace, ContradictionsOfDistancesAreNamed) {
    expect_in("a test has a parent that was not divided",
              refusal_after([](TraceHeader&, QueryTrace& frame) {
                  auto& tests = frame.steps.volumes;
                  const auto rejected =
                      std::find_if(tests.begin(), tests.end(),
                                   [](const Step& test) { return is_rejection(test.stage); });
                  ASSERT_LT(rejected, tests.end() - 2);
                  (tests.end() - 1)->parent = (tests.end() - 2)->parent =
                      static_cast<std::uint32_t>(rejected - tests.begin());
              }));
    expect_in("its counts differ from its tests",
              refusal_after([](TraceHeader&, QueryTrace& frame) { ++frame.found.n_u; }));
    expect_in("a stage does not belong", refusal_after([](TraceHeader&, QueryTrace& frame) {
                  for (Step& test : frame.steps.volumes)
                      if (is_rejection(test.stage)) test.stage = Stage::axis_a0;
              }));
    expect_in("its answer is none of the triangles that it measured",
              refusal_after([](TraceHeader&, QueryTrace& frame) {
                  // A pair of triangles that the query did not measure, at any order of its tests.
                  IndexPair pair{0, 0};
                  const auto measures = [&pair](const ItemStep& item) {
                      return item.items == pair;
                  };
                  const auto& items = frame.steps.items;
                  while (std::any_of(items.begin(), items.end(), measures)) ++pair.a;
                  frame.found.pairs = {pair};
              }));
    expect_in("its answer cannot be read",
              refusal_after([](TraceHeader& header, QueryTrace& frame) {
                  header.distance.limit = frame.nearest->distance / 2;
              }));
    expect_in("its answer cannot be read", refusal_after([](TraceHeader&, QueryTrace& frame) {
                  frame.nearest->point_a[1] = std::nan("");
              }));
    expect_in("its answer cannot be read",
              refusal_after([](TraceHeader&, QueryTrace& frame) { frame.rounding = -1; }));
    expect_in("its answer cannot be read",
              refusal_after([](TraceHeader&, QueryTrace& frame) { frame.nearest.reset(); }));
    // The smallest distance may be known before all pairs are divided, and all pairs within a
    // distance may not.
    expect_in("the tests end before the query did",
              refusal_after([](TraceHeader& header, QueryTrace& frame) {
                  header.kind = QueryKind::within;
                  header.tolerance = 2;
                  frame.nearest.reset();
              }));
    for (const double number : {-1.0, std::nan(""), HUGE_VAL}) {
        expect_in("its header cannot be read", refusal_after([&](TraceHeader& header, QueryTrace&) {
                      header.distance.relative_error = number;
                  }));
        if (number < HUGE_VAL || std::isnan(number))
            expect_in("its header cannot be read",
                      refusal_after([&](TraceHeader& header, QueryTrace&) {
                          header.distance.limit = number;
                      }));
    }
    expect_in("its header cannot be read", refusal_after([](TraceHeader& header, QueryTrace&) {
                  header.distance.seed = IndexPair{120, 0};
              }));
    expect_in("its header cannot be read", refusal_after([](TraceHeader& header, QueryTrace&) {
                  header.options.stop_level = 3;
              }));
}

TEST(DamagedTrace, FramesComeInOrder) {
    Trace trace = small_trace();
    std::swap(trace.frames[0], trace.frames[1]);
    expect_in("its frames are out of order", refusal_of(encode_trace(trace)));
}

}  // namespace
}  // namespace scb::scenes
