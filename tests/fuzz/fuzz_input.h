#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scb/error.h"
#include "scb/mesh.h"
#include "scb/pose.h"

namespace scb::fuzz {

/// Ends the process, which the fuzzer takes for a finding.
inline void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
}

/// A refusal is one sentence, on one line, that names the input.
inline void require_sentence(const InputError& error, std::string_view name) {
    const std::string_view sentence = error.what();
    require(sentence.find(name) != sentence.npos, "a refusal names the file");
    require(sentence.find('\n') == sentence.npos, "a refusal is one line");
    require(sentence.ends_with('.'), "a refusal ends as sentences do");
    require(sentence.size() < 2000, "a refusal is short");
}

/// Bytes as a file, for readers that take paths.
class InputFile {
  public:
    explicit InputFile(std::span<const std::uint8_t> bytes)
        : descriptor_(::memfd_create("input", MFD_CLOEXEC)),
          path_("/proc/self/fd/" + std::to_string(descriptor_)) {
        require(descriptor_ >= 0 && ::write(descriptor_, bytes.data(), bytes.size()) ==
                                        static_cast<ssize_t>(bytes.size()),
                "a file can be made");
    }
    ~InputFile() { ::close(descriptor_); }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    const std::string& path() const { return path_; }

  private:
    int descriptor_;
    std::string path_;
};

/// Whether vertices and triangles are the same bit by bit.
inline bool same_bits(const Mesh& a, const Mesh& b) {
    const auto same = [](const auto& first, const auto& second) {
        const std::size_t size = first.size() * sizeof first[0];
        return first.size() == second.size() &&
               (size == 0 || std::memcmp(first.data(), second.data(), size) == 0);
    };
    return same(a.vertices, b.vertices) && same(a.triangles, b.triangles);
}

/// Reads the bytes as a file by a reader of meshes: what it gives has no index out of range and is
/// the same when it is read again, and what it refuses gets a sentence.
template <class Reader>
void read_mesh(std::span<const std::uint8_t> bytes, const Reader& reader) {
    const InputFile file(bytes);
    try {
        const Mesh mesh = reader(file.path());
        require(same_bits(mesh, reader(file.path())), "a mesh is the same when it is read again");
        for (const Triangle& t : mesh.triangles)
            for (const std::uint32_t v : t)
                require(v < mesh.vertices.size(), "triangles name vertices");
    } catch (const InputError& error) {
        require_sentence(error, file.path());
    }
}

/// Numbers from bytes; zeros once there are no more.
class Numbers {
  public:
    explicit Numbers(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    bool empty() const { return bytes_.empty(); }

    template <class T>
    T raw() {
        T value{};
        const std::size_t size = std::min(sizeof value, bytes_.size());
        if (size > 0) std::memcpy(&value, bytes_.data(), size);
        bytes_ = bytes_.subspan(size);
        return value;
    }
    std::uint32_t below(std::uint32_t bound) { return raw<std::uint8_t>() % bound; }

    /// A coordinate: on a coarse grid, so that things touch; anywhere within 1e6; or either, moved
    /// by a few units in its last place.
    double coordinate() {
        const std::uint8_t kind = raw<std::uint8_t>();
        double value = raw<std::int8_t>() / 8.0;
        if (kind % 4 == 1) value = finite(raw<float>());
        if (kind % 4 == 2) value += raw<std::int8_t>() * 0x1p-24;
        if (kind % 4 == 3)
            for (int steps = raw<std::uint8_t>() % 8; steps > 0; --steps)
                value = std::nextafter(value, kind < 128 ? -1e9 : 1e9);
        return value;
    }
    Vec3 point() {
        const double x = coordinate(), y = coordinate(), z = coordinate();
        return {x, y, z};
    }
    Vec3 direction() {
        const Vec3 v = point();
        const double length = std::sqrt(squared_norm(v));
        return length > 1e-3 ? Vec3(v / length) : Vec3(0, 0, 1);
    }
    Pose pose() {
        Pose pose;
        if (below(2) == 1) {
            const Vec3 axis = direction();
            const double half = 3 * coordinate(), sine = std::sin(half);
            pose.rotation =
                Eigen::Quaterniond(std::cos(half), sine * axis[0], sine * axis[1], sine * axis[2])
                    .normalized()
                    .toRotationMatrix();
        }
        pose.translation = point();
        return pose;
    }
    Mesh mesh(std::uint32_t most_triangles) {
        Mesh mesh;
        const std::uint32_t vertices = 3 + below(2 * most_triangles);
        for (std::uint32_t i = 0; i < vertices; ++i) mesh.vertices.push_back(point());
        const std::uint32_t triangles = 1 + below(most_triangles);
        for (std::uint32_t i = 0; i < triangles; ++i)
            mesh.triangles.push_back({below(vertices), below(vertices), below(vertices)});
        return mesh;
    }

  private:
    static double finite(float value) {
        return std::isfinite(value) ? std::fmod(static_cast<double>(value), 1e6) : 0;
    }

    std::span<const std::uint8_t> bytes_;
};

}  // namespace scb::fuzz

/// What libFuzzer calls, with `input`.
#define SCB_FUZZ(input)                                                                 \
    static void try_input(std::span<const std::uint8_t> input);                         \
    extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) { \
        try_input({data, size});                                                        \
        return 0;                                                                       \
    }                                                                                   \
    static void try_input(std::span<const std::uint8_t> input)
