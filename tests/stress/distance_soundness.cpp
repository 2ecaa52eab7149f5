// distance_soundness [--pairs N] [--triangles N] [--seed S] [--threads T]: compares the lower
// bounds of distances with the distances of points in double-double arithmetic, for N pairs of each
// kind of volume, and of each packed volume. Compares triangle_distance with proven bounds, for N
// pairs of triangles in all. Except the times, the figures depend on N and S only. Exit status 1 if
// a bound is above a distance, or if a distance is wrong or its bounds are far apart.

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tests/core/distance/gap_tally.h"
#include "tests/core/distance/triangle_tally.h"

namespace {

using namespace scb;

constexpr std::uint64_t chunk = 1u << 14;

struct Arguments {
    std::uint64_t pairs = 1'000'000, triangles = 10'000'000, seed = 1,
                  threads = std::thread::hardware_concurrency();
};

bool parse(int count, char** values, Arguments& arguments) {
    for (int i = 1; i < count; i += 2) {
        std::uint64_t* target = std::strcmp(values[i], "--pairs") == 0       ? &arguments.pairs
                                : std::strcmp(values[i], "--triangles") == 0 ? &arguments.triangles
                                : std::strcmp(values[i], "--seed") == 0      ? &arguments.seed
                                : std::strcmp(values[i], "--threads") == 0   ? &arguments.threads
                                                                             : nullptr;
        if (target == nullptr || i + 1 == count) return false;
        const char* end = values[i + 1] + std::strlen(values[i + 1]);
        const auto [rest, error] = std::from_chars(values[i + 1], end, *target);
        if (error != std::errc{} || rest != end) return false;
    }
    arguments.threads = std::max<std::uint64_t>(arguments.threads, 1);
    return true;
}

// Chunk by chunk, each from a seed of its own, so that the threads can share them in any order.
template <class Tally, class Draw>
Tally tally_of(std::uint64_t pairs, const Arguments& arguments, const Draw& draw) {
    const std::uint64_t chunks = (pairs + chunk - 1) / chunk;
    std::vector<Tally> tallies(chunks);
    std::atomic<std::uint64_t> next = 0;
    const auto work = [&] {
        for (std::uint64_t i; (i = next++) < chunks;)
            tallies[i] = draw(Random(arguments.seed ^ Random(i + 1).next()).next(),
                              std::min(chunk, pairs - i * chunk));
    };
    std::vector<std::thread> threads;
    for (std::uint64_t t = 1; t < arguments.threads; ++t) threads.emplace_back(work);
    work();
    for (std::thread& thread : threads) thread.join();
    Tally sum;
    for (const Tally& tally : tallies) sum += tally;
    return sum;
}

bool bounds_are_below(const Arguments& arguments) {
    print_gap_header();
    bool correct = true;
    const auto take = [&](std::string_view name, const GapTally& tally) {
        print_tally(name, tally);
        std::fflush(stdout);
        correct = correct && tally.above == 0 && tally.loose == 0;
    };
    for (const VolumeKind kind : all_volume_kinds())
        take(volume_kind_name(kind),
             tally_of<GapTally>(arguments.pairs, arguments,
                                [kind](std::uint64_t seed, std::uint64_t pairs) {
                                    return tally_gaps(kind, seed, pairs);
                                }));
    for (const int slabs : {1, 2})
        take(slabs == 1 ? "packed scb" : "packed scb2",
             tally_of<GapTally>(arguments.pairs, arguments,
                                [slabs](std::uint64_t seed, std::uint64_t pairs) {
                                    return tally_packed_gaps(slabs, seed, pairs);
                                }));
    return correct;
}

bool triangles_are_right(const Arguments& arguments) {
    print_triangle_header();
    TriangleTally sum;
    const std::size_t families = triangle_pair_families.size();
    for (std::size_t k = 0; k < families; ++k) {
        const TrianglePairFamily& family = triangle_pair_families[k];
        const std::uint64_t pairs =
            arguments.triangles / families + (k < arguments.triangles % families ? 1 : 0);
        const auto tally = tally_of<TriangleTally>(
            pairs, arguments, [&family](std::uint64_t seed, std::uint64_t count) {
                return tally_triangles(family, seed, count);
            });
        print_tally(family.name, tally);
        std::fflush(stdout);
        sum += tally;
    }
    print_tally("all", sum);
    return sum.wrong == 0 && sum.unproven == 0;
}

template <class Part>
bool timed(const Part& part) {
    const auto start = std::chrono::steady_clock::now();
    const bool correct = part();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    std::printf("%.0f s\n", time.count());
    return correct;
}

}  // namespace

int main(int count, char** values) {
    Arguments arguments;
    if (!parse(count, values, arguments)) {
        std::fprintf(stderr,
                     "usage: distance_soundness [--pairs N] [--triangles N] [--seed S] "
                     "[--threads T]\n");
        return 2;
    }
    std::printf("%" PRIu64 " pairs of each volume, %" PRIu64 " of triangles, seed %" PRIu64 "\n",
                arguments.pairs, arguments.triangles, arguments.seed);
    const bool below = timed([&] { return bounds_are_below(arguments); }),
               right = timed([&] { return triangles_are_right(arguments); });
    return below && right ? 0 : 1;
}
