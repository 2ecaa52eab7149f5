#pragma once

#include <bit>
#include <cstring>
#include <string>
#include <vector>

#include "scb/hierarchy.h"
#include "scb/node_codec.h"
#include "scb/packed_layout.h"

namespace scb {

/// The most triangles of a packed leaf.
inline constexpr int most_leaf_triangles = 4;

/// A reference to a wide node or a leaf.
struct PackedRef {
    /// Set in `bits` of a leaf.
    static constexpr std::uint32_t leaf_bit = std::uint32_t{1} << 31;
    /// The index, and `leaf_bit`.
    std::uint32_t bits = 0;

    /// Whether it is a leaf.
    bool is_leaf() const { return (bits & leaf_bit) != 0; }
    /// The index of a node, or the index of a leaf's first word, see PackedLeaf.
    std::uint32_t index() const { return bits & ~leaf_bit; }
};

/// A node with up to `width` children, and its own volume. The children's volumes are relative to
/// the center of its own. Kernels load four numbers from an array of two, and so read beyond the
/// volumes. Floats follow there: integers would be read as denormal floats, with which tests take
/// up to twice as long.
template <class Codec>
struct PackedNode {
    std::uint32_t child[Codec::width] = {};  ///< bits of PackedRef
    /// How many children it has.
    std::uint16_t count = 0;
    std::uint16_t leaf_bits = 0;  ///< bit i: child i is a leaf
    /// The volumes of the children, relative to the center of `own`.
    Codec volumes;
    float reach = 0;  ///< no volume of the node reaches farther from the center of `own`
    /// Its own volume, in the body frame.
    typename Codec::Decoded own;
};

/// A leaf, as words of 4 bytes: the center and radius of its volume, the number of its triangles,
/// their indices, and, if stored, the coordinates of their corners relative to the center: x of all
/// first corners, then y, then z, then the same for the second and third corners. The slabs of its
/// volume stand before these words, since tests of triangles need the ball alone. Words are floats;
/// counts and indices are stored as their bits, which are moved and compared, but not computed
/// with.
struct PackedLeaf {
    /// The words that queries prefetch: three cache lines, nearly all of the largest leaf. Shorter
    /// leaves have fewer words, so as many are allocated behind the last leaf.
    static constexpr std::size_t fetched_words = 48;
    static constexpr std::size_t ball = 4,  ///< words of the ball
        header = ball + 1;                  ///< words before the indices
    /// The first word of the center.
    const float* words = nullptr;

    /// The volume: a PackedScb or a PackedScb2, depending on the layout.
    template <class Volume>
    Volume own() const {
        Volume volume;
        std::memcpy(static_cast<void*>(&volume), words, sizeof(float) * ball);
        std::memcpy(reinterpret_cast<float*>(&volume) + ball, words - words_before<Volume>,
                    sizeof(float) * words_before<Volume>);
        return volume;
    }
    /// The center of its ball: 3 floats, in the body frame.
    const float* center() const { return words; }
    /// The radius of its ball.
    float radius() const { return words[3]; }
    /// How many triangles it has, 1 to 4.
    std::uint32_t count() const { return std::bit_cast<std::uint32_t>(words[ball]); }
    /// The index of triangle k of `count()`.
    std::uint32_t triangle(std::size_t k) const {
        return std::bit_cast<std::uint32_t>(triangle_bits()[k]);
    }
    /// The bits of all indices.
    const float* triangle_bits() const { return words + header; }
    /// The stored corners, 9 floats a triangle; not there with LeafCorners::in_mesh.
    const float* corners() const { return words + header + count(); }
    /// The number of words of a leaf with `count` triangles, from its center on.
    static constexpr std::size_t size(std::size_t count, LeafCorners corners) {
        return header + (corners == LeafCorners::stored ? 10 : 1) * count;
    }
    /// The number of words of its volume's slabs, before the center.
    template <class Volume>
    static constexpr std::size_t words_before = sizeof(Volume) / sizeof(float) - ball;
    /// Writes the volume: its ball, and its slabs before the ball.
    template <class Volume>
    static void write_volume(float* words, const Volume& volume) {
        std::memcpy(words, &volume, sizeof(float) * ball);
        std::memcpy(words - words_before<Volume>, reinterpret_cast<const float*>(&volume) + ball,
                    sizeof(float) * words_before<Volume>);
    }
    /// Writes the corners behind the indices, rounded to the nearest floats.
    static void write_corners(float* words, const Mesh& mesh);
};

/// A hierarchy of slab cut balls, with one slab or two, made for queries: wide nodes, with volumes
/// and triangles rounded to less memory such that a query finds the same pairs as with the
/// hierarchy that it was packed from, see collide_packed. Immutable once built.
template <class Codec>
struct PackedHierarchy {
    std::vector<PackedNode<Codec>> nodes;  ///< parents first
    std::vector<float> leaves;             ///< their words, and a few more that kernels may read
    /// Where a query begins.
    PackedRef root;
    /// Where the corners of its leaves' triangles are.
    LeafCorners corners = LeafCorners::stored;
    double reach = 0;        ///< of the reference hierarchy's root, from the body frame's origin
    double leaf_radius = 0;  ///< mean radius of the leaves' balls

    /// The leaf that `ref` names; `ref` must be a leaf. Refers to `leaves`.
    PackedLeaf leaf(PackedRef ref) const { return {leaves.data() + ref.index()}; }
    /// The memory of nodes and leaves.
    std::size_t bytes() const {
        return nodes.size() * sizeof(PackedNode<Codec>) + leaves.size() * sizeof(float);
    }
};

/// Throws InputError, naming the mesh, if products of its coordinates may leave the range of
/// floats: coordinates above 1e8 in magnitude, or a size below 1e-8.
void check_packable(const Mesh& mesh, std::string_view name);

/// Packs a hierarchy of this mesh, `leaf_triangles` (1 to 4) triangles at most in a leaf; the same
/// for any number of threads. Throws InputError, naming the mesh, as check_packable does, and if
/// its leaves have more than 2^31 words: 100 to 170 million triangles with corners. O(n).
template <class Codec>
PackedHierarchy<Codec> pack(const Hierarchy<typename Codec::Volume>& hierarchy, const Mesh& mesh,
                            int leaf_triangles = most_leaf_triangles,
                            LeafCorners corners = LeafCorners::stored,
                            std::string_view name = "mesh", int threads = 1);

/// The codec with which queries are quickest, on scans and on CAD models, see
/// core/topics/packed.md.
using QuickestCodec = QuantizedCodec<8, Scb2>;
/// How packed hierarchies are built by default.
inline constexpr BuildOptions packed_build = {.split = SplitMethod::cost};

/// The same result as `pack<Codec>(build_hierarchy<Codec::Volume>(mesh, options, name), mesh,
/// ...)`, in less time: volumes that the packed hierarchy does not have are not fitted.
template <class Codec = QuickestCodec>
PackedHierarchy<Codec> build_packed(const Mesh& mesh, const BuildOptions& options = packed_build,
                                    int leaf_triangles = most_leaf_triangles,
                                    LeafCorners corners = LeafCorners::stored,
                                    std::string_view name = "mesh");

/// Checks that every triangle is in exactly one leaf, and that corners are the nearest floats.
/// Every vertex below a node or leaf must be in its own volume, and in the decoded volume that its
/// parent stores for it. Returns an empty string if so, else a sentence that names the first
/// offender. O(n log n).
template <class Codec>
std::string validate(const PackedHierarchy<Codec>& packed, const Mesh& mesh);

}  // namespace scb
